"""What an interactive experiment works on, with what may be remembered between its runs.

Everything remembered is a function of the instances alone, so no result hangs
on which worker computed what before.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, product

from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.inquiry import InquiryParameters
from verbteach.dialogue.learning_inquiry import LearningInquiry, shown_grounding
from verbteach.experiments.gold import gold_sequence
from verbteach.experiments.sight import Sight
from verbteach.experiments.workroom import Workroom, Workrooms
from verbteach.perception.belief import Belief
from verbteach.verbs.analogy import Analogies
from verbteach.verbs.examples import Memory
from verbteach.verbs.instance import Instance
from verbteach.verbs.pool import PoolParameters, PoolSource
from verbteach.verbs.resemblance import Said
from verbteach.verbs.seen_change import seen_change
from verbteach.world.plan import Action


@dataclass(frozen=True)
class BenchParameters:
    """How commands are taken in.

    ``groundings``: at most that many joint groundings. ``oracle`` narrows the
    candidates to what the demonstration changed, also for new commands, which
    leaks the outcome: a result must say so.
    """

    groundings: int = 24
    oracle: bool = False
    pool: PoolParameters = field(default_factory=PoolParameters)
    inquiry: InquiryParameters = field(default_factory=InquiryParameters)


@dataclass
class Bench:
    """Instances in their rooms."""

    instances: Sequence[Instance]
    rooms: Workrooms
    parameters: BenchParameters = field(default_factory=BenchParameters)

    def __post_init__(self) -> None:
        self._analogies: dict[str, Analogies] = {}
        self._gold: dict[str, tuple[Action, ...]] = {}

    def room(self, instance: Instance) -> Workroom:
        """Where an instance takes place."""
        return self.rooms[instance.task_key]

    def gold(self, instance: Instance) -> tuple[Action, ...]:
        """The sequence that plans are compared with."""
        if instance.id not in self._gold:
            room = self.room(instance)
            self._gold[instance.id] = gold_sequence(instance, room.task, room.planner)
        return self._gold[instance.id]

    def candidates(self, instance: Instance) -> tuple[tuple[str, ...], ...]:
        """The objects that each noun phrase may mean, before anything is asked."""
        return instance.narrowed if self.parameters.oracle else instance.candidates

    def analogies(self, instance: Instance) -> Analogies:
        """The bindings of an instance's command."""
        if instance.id not in self._analogies:
            joint = islice(product(*self.candidates(instance)), self.parameters.groundings)
            said = Said(instance.verb, instance.phrases)
            setting = self.room(instance).setting
            self._analogies[instance.id] = Analogies(said, tuple(joint), setting)
        return self._analogies[instance.id]

    def command(self, instance: Instance, sight: Sight, memory: Memory) -> ExecutionInquiry:
        """The execution phase of an instance's command, nothing asked yet."""
        source = PoolSource(self.analogies(instance), memory, self.parameters.pool)
        weights: Mapping[str, Mapping[str, float]] = {
            phrase: dict.fromkeys(things, 1.0)
            for phrase, things in zip(instance.phrases, self.candidates(instance), strict=True)
        }
        room = self.room(instance)
        return ExecutionInquiry.begin(
            source,
            room.task.static,
            _changing(sight.met(instance, room), room),
            GroundingBelief.of(weights),
            self.parameters.inquiry,
        )

    def demonstration(self, instance: Instance, sight: Sight) -> LearningInquiry:
        """The learning phase after an instance's demonstration, nothing asked yet."""
        room = self.room(instance)
        before, after = sight.demonstrated(instance, room)
        change = seen_change(room.task, before, after, instance.actions)
        grounding = shown_grounding(
            instance.phrases, instance.candidates, change.likely, instance.actions
        )
        return LearningInquiry(change, grounding, self.parameters.inquiry)


def _changing(belief: Belief, room: Workroom) -> Belief:
    """The belief without what never changes, which is known."""
    static = room.task.static
    return Belief(
        {fluent: chance for fluent, chance in belief.items() if fluent not in static},
        belief.exclusive,
    )
