"""What an interactive experiment works on, with what may be remembered between its runs.

Everything remembered is a function of the instances alone, so no result hangs
on which worker computed what before.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import islice, product
from typing import TypeAlias

from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.inquiry import InquiryParameters
from verbteach.dialogue.learning_inquiry import LearningInquiry, shown_grounding
from verbteach.experiments.gold import gold_sequence
from verbteach.experiments.groundings import Grounder
from verbteach.experiments.sight import Sight
from verbteach.experiments.simulated_human import HumanParameters, SimulatedHuman
from verbteach.experiments.workroom import Workroom, Workrooms
from verbteach.perception.belief import Belief, Exclusivity
from verbteach.perception.noise import NoiseModel
from verbteach.verbs.analogy import Analogies
from verbteach.verbs.examples import Memory
from verbteach.verbs.instance import Instance
from verbteach.verbs.pool import PLACES, PoolParameters, PoolSource
from verbteach.verbs.resemblance import Said
from verbteach.verbs.seen_change import seen_change
from verbteach.world.plan import Action
from verbteach.world.reliance import Foresight, foresight

IN_ONE_PLACE = Exclusivity(
    tuple((predicate, argument) for predicate, argument in PLACES.items() if predicate != "beside"),
    joint=True,
)
"""A thing is on or in one other, or in a hand; it may be beside a third at the same time."""

Joint: TypeAlias = tuple[tuple[str, ...], ...]
"""Joint groundings: an object for each noun phrase."""


@dataclass(frozen=True)
class BenchParameters:
    """How commands are taken in.

    ``groundings``: at most that many joint groundings. ``oracle`` narrows the
    candidates to what the demonstration changed, also for new commands, which
    leaks the outcome: a result must say so. ``caution`` is that of eyes that
    see phantoms (see ``InquiryParameters``); others see nothing that is not there.
    """

    groundings: int = 24
    oracle: bool = False
    caution: float = 0.99
    pool: PoolParameters = field(default_factory=PoolParameters)
    inquiry: InquiryParameters = field(default_factory=InquiryParameters)


@dataclass
class _Looks:
    """What was seen in one draw: beliefs of commands and demonstrations by instance id."""

    sight: Sight
    met: dict[str, Belief] = field(default_factory=dict)
    shown: dict[str, LearningInquiry] = field(default_factory=dict)


@dataclass
class Bench:
    """Instances in their rooms.

    ``grounder`` says what noun phrases may mean; without one the corpus's
    candidates are equally likely. What the human means by them is the corpus's
    all the same.
    """

    instances: Sequence[Instance]
    rooms: Workrooms
    parameters: BenchParameters = field(default_factory=BenchParameters)
    grounder: Grounder | None = None

    def __post_init__(self) -> None:
        self._analogies: dict[tuple[str, Joint], Analogies] = {}
        self._humans: dict[str, SimulatedHuman] = {}
        self._gold: dict[str, tuple[Action, ...]] = {}
        self._foresights: dict[str, Foresight] = {}
        self._looks: _Looks | None = None

    def sight(self, noise: NoiseModel, seed: int, run: int) -> Sight:
        """What the robot sees of the instances in one draw; what it saw last is remembered.

        Policies of one run meet the same draw, so it pays to try them in turn.
        """
        looks = self._looks
        if looks is None or not looks.sight.is_draw(noise, seed, run):
            rules = (IN_ONE_PLACE,) if noise.phantoms else ()
            looks = self._looks = _Looks(Sight.of(noise, self.instances, seed, run, rules))
        return looks.sight

    def room(self, instance: Instance) -> Workroom:
        """Where an instance takes place."""
        return self.rooms[instance.task_key]

    def human(self, instance: Instance, parameters: HumanParameters) -> SimulatedHuman:
        """Who teaches an instance and judges it; the last one is kept, with what it has judged."""
        kept = self._humans.get(instance.id)
        if kept is None or kept.parameters != parameters:
            kept = SimulatedHuman(instance, self.room(instance), parameters)
            self._humans[instance.id] = kept
        return kept

    def gold(self, instance: Instance) -> tuple[Action, ...]:
        """The sequence that plans are compared with."""
        if instance.id not in self._gold:
            room = self.room(instance)
            self._gold[instance.id] = gold_sequence(instance, room.task, room.planner)
        return self._gold[instance.id]

    def command(
        self, instance: Instance, sight: Sight, memory: Memory, trust: float = 1.0
    ) -> ExecutionInquiry:
        """The execution phase of an instance's command, nothing asked yet.

        ``trust`` is how likely the robot takes a yes or no to be right.
        """
        joint, grounding = self._grounded(instance, memory)
        pool = replace(self.parameters.pool, reliability=trust)
        source = PoolSource(self._analogies_of(instance, joint), memory, pool)
        room = self.room(instance)
        return ExecutionInquiry.begin(
            source,
            room.task.static,
            self._met(instance, sight),
            grounding,
            self._asking(sight, trust),
            self._foresight(instance),
        )

    def _grounded(self, instance: Instance, memory: Memory) -> tuple[Joint, GroundingBelief]:
        """The joint groundings that are weighed, and the belief over each phrase's objects."""
        if self.grounder is None:
            each = instance.narrowed if self.parameters.oracle else instance.candidates
            weights = {
                phrase: dict.fromkeys(things, 1.0)
                for phrase, things in zip(instance.phrases, each, strict=True)
            }
            joint = tuple(islice(product(*each), self.parameters.groundings))
            return joint, GroundingBelief.of(weights)
        shown = [example.demonstration for example in memory.examples]
        rows = self.grounder(instance, shown)[: self.parameters.groundings]
        return tuple(objects for objects, _ in rows), marginals(instance.phrases, rows)

    def _analogies_of(self, instance: Instance, joint: Joint) -> Analogies:
        """The bindings of an instance's command."""
        key = (instance.id, joint)
        if key not in self._analogies:
            said = Said(instance.verb, instance.phrases)
            self._analogies[key] = Analogies(said, joint, self.room(instance).surroundings)
        return self._analogies[key]

    def _foresight(self, instance: Instance) -> Foresight:
        """What goals take for granted in the instance's room."""
        if instance.task_key not in self._foresights:
            room = self.room(instance)
            self._foresights[instance.task_key] = foresight(room.task, room.planner)
        return self._foresights[instance.task_key]

    def _met(self, instance: Instance, sight: Sight) -> Belief:
        """What is believed when the command is given, of what may change."""
        looks = self._looks_of(sight)
        if instance.id not in looks.met:
            room = self.room(instance)
            looks.met[instance.id] = _changing(sight.met(instance, room), room)
        return looks.met[instance.id]

    def demonstration(
        self, instance: Instance, sight: Sight, trust: float = 1.0
    ) -> LearningInquiry:
        """The learning phase after an instance's demonstration, nothing asked yet."""
        looks = self._looks_of(sight)
        if instance.id not in looks.shown:
            looks.shown[instance.id] = self._shown(instance, sight)
        shown = looks.shown[instance.id]
        return shown if trust == 1.0 else replace(shown, parameters=self._asking(sight, trust))

    def _asking(self, sight: Sight, trust: float) -> InquiryParameters:
        caution = self.parameters.caution if sight.noise.phantoms else 0.0
        return replace(self.parameters.inquiry, trust=trust, caution=caution)

    def _looks_of(self, sight: Sight) -> _Looks:
        kept = self._looks
        return kept if kept is not None and kept.sight is sight else _Looks(sight)

    def _shown(self, instance: Instance, sight: Sight) -> LearningInquiry:
        room = self.room(instance)
        before, after = sight.demonstrated(instance, room)
        change = seen_change(room.task, before, after, instance.actions)
        candidates: Sequence[Sequence[str]] = instance.candidates
        if self.grounder is not None:
            belief = marginals(instance.phrases, self.grounder(instance, ()))
            candidates = [[thing for thing, _ in belief[phrase]] for phrase in instance.phrases]
        grounding = shown_grounding(instance.phrases, candidates, change.likely, instance.actions)
        return LearningInquiry(change, grounding, self.parameters.inquiry)


def marginals(
    phrases: Sequence[str], rows: Sequence[tuple[tuple[str, ...], float]]
) -> GroundingBelief:
    """Each phrase's objects, from joint groundings with their probabilities."""
    weights: dict[str, dict[str, float]] = {phrase: {} for phrase in phrases}
    for objects, probability in rows:
        for phrase, thing in zip(phrases, objects, strict=True):
            weights[phrase][thing] = weights[phrase].get(thing, 0.0) + probability
    return GroundingBelief.of(weights)


def _changing(belief: Belief, room: Workroom) -> Belief:
    """The belief without what never changes, which is known."""
    static = room.task.static
    return Belief(
        {fluent: chance for fluent, chance in belief.items() if fluent not in static},
        belief.exclusive,
    )
