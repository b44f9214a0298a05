"""A session as plain values: who said what when, and what the robot had in mind.

Every export is made from these. They hold session time only, never the time of
day, and the session's name stands in for by an alias that does not tell it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from verbteach.dialogue.acts import QUESTIONS

ROBOT = "robot"
TEACHER = "teacher"

QUESTION_NAMES = frozenset(kind.name for kind in QUESTIONS)

Price = tuple[float, float]


@dataclass(frozen=True)
class Turn:
    """What one of the two said or did at one point.

    ``number`` counts from 0 in the dialogue, ``seq`` is the event's number in
    the record. ``reply_to`` is the number of the turn that this one replies to.
    ``kind`` is the event's type: ``robot``, ``teacher``, or one of the acts about
    the session (``undo``, ``redo``, ``flag``, ``note``, ``why``, ``repeat``).
    ``at`` and ``answer_seconds`` are seconds of session time. ``phase`` is what
    the robot waits for: after its own turn, or as the teacher acted. ``command``
    counts the commands of the session from 0. ``holds``: no undo took it back.
    The other fields are as the record has them.
    """

    number: int
    seq: int
    reply_to: int | None
    speaker: str
    kind: str
    at: float
    texts: tuple[str, ...]
    phase: str
    scene: str
    command: int | None
    holds: bool = True
    acts: tuple[Mapping[str, Any], ...] = ()
    raw: str = ""
    via: str = ""
    answer_seconds: float | None = None
    reading: str = ""
    reward: float | None = None
    decisions: tuple[Mapping[str, Any], ...] = ()
    beliefs: Mapping[str, Any] | None = None
    trace: Mapping[str, Any] | None = None
    learned: Mapping[str, Any] | None = None
    world: str = ""
    verbs_learned: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """All that was said, in one piece."""
        return " ".join(text for text in self.texts if text)

    @property
    def act_names(self) -> tuple[str, ...]:
        """The acts' names; an act about the session has its kind's."""
        return tuple(str(act.get("act")) for act in self.acts) or (self.kind,)

    @property
    def question(self) -> str | None:
        """The name of the question that the turn ends with, if it asks one."""
        last = self.act_names[-1]
        return last if self.speaker == ROBOT and last in QUESTION_NAMES else None

    @property
    def spoken(self) -> bool:
        """Whether it is part of the dialogue itself, not about the session."""
        return self.kind in (ROBOT, TEACHER)


@dataclass(frozen=True)
class Dialogue:
    """A session. ``id`` is its alias, ``source`` that of the session it goes on from.

    A branch has a ``parent``: the other session's alias, and the last event they share.
    ``prices`` are what questions cost, answered with yes and otherwise.
    ``questionnaires`` hold the answers given last, by name and question.
    ``seconds`` is how long it took in session time. ``split`` is the part of a
    corpus that it was put into.
    """

    id: str
    participant: str | None
    teacher: str
    interface: str
    scene: str
    policy: str
    seed: int
    noise: Mapping[str, Any]
    method: Mapping[str, Any]
    software: Mapping[str, str]
    study: Mapping[str, Any] | None
    source: str | None
    parent: tuple[str, int] | None
    content_hash: str
    ended: bool
    seconds: float
    totals: Mapping[str, float]
    verbs_learned: tuple[str, ...]
    prices: Mapping[str, Price]
    turns: tuple[Turn, ...]
    questionnaires: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    split: str = "train"
    warnings: tuple[str, ...] = ()

    @property
    def person(self) -> str:
        """Who taught, by the random code; else a name of this dialogue's own."""
        return self.participant or f"{TEACHER}-{self.id}"

    @property
    def held(self) -> tuple[Turn, ...]:
        """The turns that were said to the robot or by it and that still hold."""
        return tuple(turn for turn in self.turns if turn.holds and turn.spoken)
