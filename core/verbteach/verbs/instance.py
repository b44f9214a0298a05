"""An instance: one command that somebody carried out, as the learner meets it.

It knows the words, the grounding and the recorded change of state, whatever
corpus or bundled lesson they came from; it must not know where that was. This
is the five-tuple of She & Chai 2017, section 3, without what the robot believes.
"""

from __future__ import annotations

from dataclasses import dataclass

from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Action


@dataclass(frozen=True)
class Instance:
    """One demonstrated command.

    ``id`` is unique in its collection and sorts in the order of recording.
    ``group`` names the document (one demonstrator, one recording) and
    ``environment`` the room it began in: hold out whole environments, resample
    whole groups. ``phrases`` are the noun phrases in the order said, and
    ``candidates[i]`` the objects that ``phrases[i]`` may mean, as the corpus
    maps them, never empty; ``grounding[i]`` is one of ``candidates[i]``, the
    gold object. ``actions`` lead from ``start`` to ``end``, both closed-world.
    ``goal`` is what the demonstration was meant to reach where that is known;
    demonstrations hold needless steps, so it need not be the whole change.
    ``task_key`` names the grounded task (objects and static facts) to plan with.
    ``gold`` is the demonstration without needless moves, which scores compare
    plans with; left empty, it is ``actions``.
    """

    id: str
    group: str
    environment: str
    verb: str
    phrases: tuple[str, ...]
    candidates: tuple[tuple[str, ...], ...]
    grounding: tuple[str, ...]
    start: State
    actions: tuple[Action, ...]
    end: State
    goal: Goal | None
    task_key: str
    gold: tuple[Action, ...] = ()

    def __post_init__(self) -> None:
        if not len(self.phrases) == len(self.candidates) == len(self.grounding):
            raise ValueError(
                f"{self.id}: {len(self.phrases)} noun phrases, {len(self.candidates)} candidate"
                f" sets and {len(self.grounding)} gold objects; there must be one of each a phrase"
            )
        for phrase, objects, gold in zip(
            self.phrases, self.candidates, self.grounding, strict=True
        ):
            if gold not in objects:
                raise ValueError(f"{self.id}: {gold!r} is not a candidate of {phrase!r}: {objects}")
        if not self.gold:
            object.__setattr__(self, "gold", self.actions)

    @property
    def frame(self) -> tuple[str, int]:
        """The verb and the number of grounded noun phrases: what hypotheses are filed under."""
        return self.verb, len(self.phrases)

    @property
    def changed_objects(self) -> frozenset[str]:
        """Every object that a changed fluent speaks of, and values such as ``Water`` with them."""
        return frozenset(word for fluent in self.start ^ self.end for word in fluent.args)

    @property
    def narrowed(self) -> tuple[tuple[str, ...], ...]:
        """The candidates of each phrase that the demonstration changed; all where it changed none.

        This is the published baseline's grounding (``oracle``). It looks at
        the outcome, so a score that uses it on new commands must say so.
        """
        changed = self.changed_objects
        return tuple(
            tuple(o for o in objects if o in changed) or objects for objects in self.candidates
        )
