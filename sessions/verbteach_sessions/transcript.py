"""What was said, as lines for people to read: the turns that hold, and the notes beside them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from verbteach.dialogue.acts import QUESTIONS
from verbteach.dialogue.codec import teacher_act_from_json
from verbteach.dialogue.rewards import Rewards
from verbteach_sessions import events as kinds
from verbteach_sessions.history import History, Node, Remark
from verbteach_sessions.script import spoken

ROBOT = "robot"
TEACHER = "teacher"
NOTE = "note"

_QUESTIONS = frozenset(kind.name for kind in QUESTIONS)


class Line(NamedTuple):
    """One sentence or act.

    ``speaker`` is ``robot``, ``teacher`` or ``note``; ``kind`` the act's name.
    ``price`` is what a question costs, answered with yes and otherwise; ``None``
    for whatever is no question. ``seq`` is the event that it stands in.
    """

    speaker: str
    text: str
    kind: str
    price: tuple[float, float] | None
    seq: int


class Transcript:
    """Makes the lines of one history, again and again as it grows; those of a turn only once."""

    def __init__(self, history: History, rewards: Rewards) -> None:
        self._history, self._rewards = history, rewards
        self._turns: dict[int, tuple[Line, ...]] = {}

    def lines(self) -> tuple[Line, ...]:
        """The lines in the order of events. Notes and flags stay though their turn was undone."""
        turns = self._history.effective()
        lines = [line for node in turns for line in self._of(node)]
        remarks = self._remarks({node.seq for node in turns})
        if not remarks:
            return tuple(lines)
        return tuple(sorted([*lines, *remarks], key=lambda line: line.seq))

    def _of(self, node: Node) -> tuple[Line, ...]:
        if node.seq not in self._turns:
            self._turns[node.seq] = tuple(_turn(node, self._rewards))
        return self._turns[node.seq]

    def _remarks(self, standing: set[int]) -> list[Line]:
        return [
            line
            for remark in self._history.remarks
            if remark.node.seq in standing or remark.type in (kinds.NOTE, kinds.FLAGGED)
            for line in _remark(remark)
        ]


def transcript(history: History, rewards: Rewards) -> tuple[Line, ...]:
    """The lines in the order of the events. Notes and flags stay though their turn was undone."""
    return Transcript(history, rewards).lines()


def said_in(node: Node) -> Line | None:
    """What the teacher said that a turn replies to; ``None`` for a first turn."""
    if node.teacher is None:
        return None
    act = teacher_act_from_json(node.teacher.data["act"])
    return Line(TEACHER, spoken(act), act.name, None, node.teacher.seq)


def _turn(node: Node, rewards: Rewards) -> Iterator[Line]:
    said = said_in(node)
    if said is not None:
        yield said
    for name, text in zip(node.acts, node.texts, strict=False):
        price = rewards.prices[name] if name in _QUESTIONS and name in rewards.prices else None
        yield Line(ROBOT, text, name, price, node.seq)


def _remark(remark: Remark) -> Iterator[Line]:
    if remark.type == kinds.FLAGGED:
        yield Line(NOTE, "flagged", kinds.FLAGGED, None, remark.seq)
    elif remark.type == kinds.NOTE:
        yield Line(NOTE, remark.texts[0], kinds.NOTE, None, remark.seq)
    else:
        yield Line(TEACHER, remark.type, remark.type, None, remark.seq)
        yield from (Line(ROBOT, text, remark.type, None, remark.seq) for text in remark.texts)
