"""The order of a session's events: which turn follows which, and which of them hold now.

Turns form a tree. A teacher's act grows it from the turn that holds, undo and
redo move along it, and nothing is ever cut. What events mean to the robot is
not known here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from verbteach_sessions import events as kinds
from verbteach_sessions.lines import Event


class OrderError(ValueError):
    """An event that cannot follow those before it; the message says why."""


@dataclass(frozen=True)
class Node:
    """A robot turn and the teacher's act it replies to.

    The first turn of all has no ``parent``; that of a rebuild is a ``root`` too,
    which cannot be undone, though the turn that held before is its parent.
    """

    seq: int
    parent: Node | None
    root: bool
    teacher: Event | None
    record: Mapping[str, Any] | None
    acts: tuple[str, ...]
    texts: tuple[str, ...]
    phase: str
    after: Mapping[str, Any]


class Remark(NamedTuple):
    """A flag, a note, a why or a repeat, and the turn it stands beside."""

    seq: int
    node: Node
    type: str
    texts: tuple[str, ...]


class History:
    """Grows by :meth:`take`. ``current`` is the turn that holds; ``redoable`` what was undone."""

    def __init__(self) -> None:
        self.header: Event | None = None
        self.current: Node | None = None
        self.redoable: list[Node] = []
        self.remarks: list[Remark] = []
        self.teacher: Event | None = None
        self.learned: Event | None = None
        self.root: Event | None = None
        self.ended = False
        self.last: Event | None = None

    def take(self, event: Event) -> None:
        """Add an event. Raises :class:`OrderError`, and then nothing has changed."""
        take = _TAKERS.get(event.type)
        if take is None:
            raise OrderError(f"there is no event type {event.type!r}")
        if (event.type == kinds.HEADER) != (self.header is None):
            raise OrderError("a session begins with its header and has only one")
        if self.ended and event.type not in (kinds.RESUME, kinds.QUESTIONNAIRE):
            raise OrderError("the session had ended")
        take(self, event)
        self.last = event

    def effective(self, node: Node | None = None) -> tuple[Node, ...]:
        """The turns that hold, from the first to ``node`` (to the current one without it)."""
        return tuple(reversed(list(_upwards(node or self.current))))

    def records(self, node: Node | None = None) -> tuple[Mapping[str, Any], ...]:
        """What was learned in the turns that hold, in order."""
        return tuple(one.record for one in self.effective(node) if one.record is not None)

    @property
    def can_undo(self) -> bool:
        """Whether there is an act to take back."""
        return self.current is not None and not self.current.root

    def undoable(self) -> tuple[Node, ...]:
        """The turns that an undo could lead to, the nearest first."""
        found: list[Node] = []
        node = self.current
        while node is not None and not node.root and node.parent is not None:
            node = node.parent
            found.append(node)
        return tuple(found)

    @property
    def at_rest(self) -> bool:
        """Whether nobody owes a reply: the robot has spoken, and nothing was said since."""
        waiting = (self.teacher, self.learned, self.root)
        return self.current is not None and all(one is None for one in waiting)

    @property
    def redone(self) -> Node | None:
        """The turn that a redo would lead to."""
        return self.redoable[-1] if self.redoable else None

    def _turn(self) -> Node:
        if self.current is None or self.root is not None:
            raise OrderError("the robot has not spoken yet")
        return self.current

    def _idle(self, event: Event) -> Node:
        """The turn that the person's event goes with, when nobody owes a reply."""
        if self.teacher is not None:
            raise OrderError(f"event {self.teacher.seq} still waits for the robot's reply")
        turn = self._turn()
        if event.data["reply_to"] != turn.seq:
            raise OrderError(
                f"replies to event {event.data['reply_to']}, but event {turn.seq} was on the screen"
            )
        return turn

    def _take_header(self, event: Event) -> None:
        self.header = self.root = event

    def _take_teacher(self, event: Event) -> None:
        self._idle(event)
        self.teacher = event

    def _take_learned(self, event: Event) -> None:
        self._answered(event)
        if self.learned is not None:
            raise OrderError("the same act cannot be learned from twice")
        self.learned = event

    def _take_robot(self, event: Event) -> None:
        root = self.root
        if root is not None:
            if event.data["reply_to"] != root.seq:
                raise OrderError(f"does not follow event {root.seq}, which begins the scene")
        else:
            self._answered(event)
        self.current = self._node(event)
        self.redoable = []
        self.teacher = self.learned = self.root = None

    def _node(self, event: Event) -> Node:
        record = None if self.learned is None else self.learned.data["record"]
        return Node(
            seq=event.seq,
            parent=self.current,
            root=self.root is not None,
            teacher=self.teacher,
            record=record,
            acts=tuple(str(act.get("act")) for act in event.data["acts"]),
            texts=tuple(event.data["texts"]),
            phase=event.data["phase"],
            after=event.data["after"],
        )

    def _take_fault(self, event: Event) -> None:
        self._answered(event)
        if self.learned is not None:
            raise OrderError("something was learned from the act, so it was replied to")
        self.teacher = None

    def _answered(self, event: Event) -> None:
        if self.teacher is None:
            raise OrderError("nothing was said that it could reply to")
        if event.data["reply_to"] != self.teacher.seq:
            raise OrderError(f"does not reply to event {self.teacher.seq}, which waits")

    def _take_undo(self, event: Event) -> None:
        self._idle(event)
        back = self.undoable()
        turns = next((n for n, one in enumerate(back, 1) if one.seq == event.data["to"]), 0)
        if not turns:
            raise OrderError("goes back to no turn before the one that holds")
        for _ in range(turns):
            self._step_back()

    def _step_back(self) -> None:
        turn = self._turn()
        self.redoable.append(turn)
        self.current = turn.parent

    def _take_redo(self, event: Event) -> None:
        self._idle(event)
        if all(one.seq != event.data["to"] for one in self.redoable):
            raise OrderError("does again something else than what was taken back last")
        while self._turn().seq != event.data["to"]:
            self.current = self.redoable.pop()

    def _take_remark(self, event: Event) -> None:
        turn = self._idle(event)
        text = event.data.get("text")
        texts = event.data.get("texts", ()) if text is None else (text,)
        self.remarks.append(Remark(event.seq, turn, event.type, tuple(texts)))

    def _take_resume(self, event: Event) -> None:
        self.ended = False

    def _take_rebuild(self, event: Event) -> None:
        if self.teacher is not None or self._turn().seq != event.data["standing"]:
            raise OrderError("does not start from the turn that held")
        self.root = event

    def _take_questionnaire(self, event: Event) -> None:
        """It stands beside everything, and neither ends nor opens a session."""

    def _take_end(self, event: Event) -> None:
        self._idle(event)
        self.ended = True


def _upwards(node: Node | None) -> Iterator[Node]:
    while node is not None:
        yield node
        node = node.parent


_TAKERS: Mapping[str, Callable[[History, Event], None]] = {
    kinds.HEADER: History._take_header,
    kinds.TEACHER: History._take_teacher,
    kinds.LEARNED: History._take_learned,
    kinds.ROBOT: History._take_robot,
    kinds.FAULT: History._take_fault,
    kinds.UNDO: History._take_undo,
    kinds.REDO: History._take_redo,
    kinds.FLAGGED: History._take_remark,
    kinds.NOTE: History._take_remark,
    kinds.WHY: History._take_remark,
    kinds.REPEAT: History._take_remark,
    kinds.RESUME: History._take_resume,
    kinds.REBUILD: History._take_rebuild,
    kinds.END: History._take_end,
    kinds.QUESTIONNAIRE: History._take_questionnaire,
}
