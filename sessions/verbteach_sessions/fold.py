"""The fold: from a session's events to the robot's state, live and from a record alike.

A reply is computed first and holds only once its event is taken, so whoever
drives the fold can put the event on the disk, or compare it with a recorded
one, in between.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from typing import Any, TypeAlias

from verbteach.dialogue.codec import teacher_act_from_json
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState, Totals
from verbteach_sessions import events as kinds
from verbteach_sessions.content import ContentHash
from verbteach_sessions.errors import CannotUndoError
from verbteach_sessions.header import Header
from verbteach_sessions.history import History, Node
from verbteach_sessions.lines import Event
from verbteach_sessions.recording import robot_data
from verbteach_sessions.turn_rows import Turn


@dataclass(frozen=True)
class Reply:
    """What the robot replies to an event: the events' data, and the state after them."""

    learned: Mapping[str, Any] | None
    robot: Mapping[str, Any]
    state: RobotState


RECENT = 256
EVERY = 64


class Fold:
    """A session's state so far.

    ``turns`` are all turns there were, undone ones too. ``states`` holds the
    robot's state after each of them that was computed here. States are
    immutable, so going back to one is exact and costs nothing. A fold that is
    ``brief`` keeps the last ``RECENT`` and of those before one in ``EVERY``;
    :meth:`state_of` then recomputes the others. ``recalls``: it does so by itself
    where an undo leads to one.
    """

    def __init__(self, settings: Settings, *, brief: bool = False) -> None:
        self.settings = settings
        self.recalls = True
        self._brief = brief
        self.history = History()
        self.content = ContentHash()
        self.turns: list[Turn] = []
        self.states: dict[int, RobotState] = {}
        self._saved: Saved | None = None
        self._header: Header | None = None
        self._robot: Robot | None = None

    @property
    def header(self) -> Header:
        """The session's header; there is one after the first event."""
        if self._header is None:
            raise RuntimeError("the fold has not seen a header")
        return self._header

    @property
    def robot(self) -> Robot:
        """The robot in the state that holds."""
        if self._robot is None:
            raise RuntimeError("the robot is in no scene yet")
        return self._robot

    @property
    def state(self) -> RobotState | None:
        """The state that holds; ``None`` where it was not computed."""
        current = self.history.current
        return None if current is None else self.states.get(current.seq)

    def reply(self, event: Event) -> Reply:
        """What the robot replies to a ``header``, ``rebuild`` or ``teacher`` event.

        The robot's own state stays as it was. Raises what ``Robot.receive``
        and ``Robot.open`` raise, and ``ActFormatError``.
        """
        if event.type == kinds.TEACHER:
            return _reply(event, self._answer(event))
        return _reply(event, self._begin(event))

    def take(self, event: Event, reply: Reply | None = None) -> None:
        """Add an event that is in the log; a ``robot`` event with the reply it records."""
        learned = self.history.learned
        self.history.take(event)
        self.content.add(event)
        if event.type == kinds.HEADER:
            self._header = Header.from_json(event.data)
        if event.type == kinds.ROBOT and self.history.current is not None:
            self.turns.append(Turn(self.history.current, None if learned is None else learned.seq))
        if reply is not None:
            self.states[event.seq] = reply.state
            self._forget()
        if event.type in (kinds.UNDO, kinds.REDO) and self.recalls:
            self._recall()
        if event.type in _MOVES and self.state is not None:
            self._stand(self.state)

    def restore(
        self,
        history: History,
        turns: Sequence[Turn],
        state: RobotState,
        content: str,
        saved: Saved,
    ) -> None:
        """Stand where a fold over the same events stood, of which only this was kept.

        ``state`` is the one that holds, ``content`` the content hash. ``saved``
        gives the state after the turn of a number, where that was kept too.
        Raises ``ValueError`` and ``SessionError`` where the header cannot be.
        """
        if history.current is None or history.header is None:
            raise ValueError("nothing was said")
        self._header = Header.from_json(history.header.data)
        self.history, self.turns = history, list(turns)
        self.content = ContentHash(content)
        self.states[history.current.seq] = state
        self._saved = saved
        self._stand(state)

    def state_of(self, node: Node) -> RobotState:
        """The state after a turn, recomputed from the nearest one known where it was not kept.

        Raises :class:`CannotUndoError` where that gives something else than was recorded.
        """
        way = [node]
        while not self._known(way[-1]) and not way[-1].root and way[-1].parent is not None:
            way.append(way[-1].parent)
        for one in reversed(way):
            if one.seq not in self.states:
                self.states[one.seq] = self._recomputed(one)
        return self.states[node.seq]

    def kept(self, node: Node) -> RobotState | None:
        """The state after a turn, if it is at hand."""
        return self.states[node.seq] if self._known(node) else None

    def _forget(self) -> None:
        """Let go of the state that has just ceased to be recent."""
        old = len(self.turns) - RECENT - 1
        if self._brief and old >= 0 and old % EVERY != EVERY - 1:
            self.states.pop(self.turns[old].node.seq, None)

    def _known(self, node: Node) -> bool:
        """Whether the state after a turn is at hand; one that was saved is fetched."""
        if node.seq not in self.states and self._saved is not None:
            state = self._saved(node.seq)
            if state is not None and state.digest == node.after["digest"]:
                self.states[node.seq] = state
        return node.seq in self.states

    def _recomputed(self, node: Node) -> RobotState:
        state = self._reached(node)
        if state is None or state.digest != node.after["digest"]:
            raise CannotUndoError(
                f"event {node.seq} cannot be gone back to: recomputing it gives something else"
                " than was recorded"
            )
        return state

    def _reached(self, node: Node) -> RobotState | None:
        """The state after a turn, from that of the turn before it."""
        if node.root:
            return self._opened(node.after["scene"], node.parent)
        if node.parent is None or node.teacher is None:
            return None
        stood = self.robot.state
        self.robot.state = self.states[node.parent.seq]
        try:
            return self._answer(node.teacher)
        except (LookupError, ValueError):  # a scene or an object that is no more
            return None
        finally:
            self.robot.state = stood

    def _recall(self) -> None:
        """After going back past what was computed here: the state that was there."""
        current = self.history.current
        if current is not None and current.seq not in self.states:
            with suppress(CannotUndoError):
                self.state_of(current)

    def _answer(self, event: Event) -> RobotState:
        act = teacher_act_from_json(event.data["act"])
        before = self.robot.state
        try:
            self.robot.receive(act)
            return self.robot.state
        finally:
            self.robot.state = before

    def _begin(self, event: Event) -> RobotState:
        before = self.history.current if event.type == kinds.REBUILD else None
        return self._opened(event.data["scene"], before)

    def _opened(self, scene: str, before: Node | None) -> RobotState:
        """The state of a robot that opens a scene, after a rebuild with what was learned before."""
        records = [*self.header.learned_before]
        if before is not None:
            records += self.history.records(before)
        robot = self.header.method.robot(self.settings, records)
        robot.open(scene)
        if before is None:
            return robot.state
        return replace(robot.state, totals=_totals(before.after["totals"]))

    def _stand(self, state: RobotState) -> None:
        if self._robot is None:
            self._robot = self.header.method.robot(self.settings)
        self._robot.state = state


Saved: TypeAlias = Callable[[int], RobotState | None]

_MOVES = frozenset({kinds.ROBOT, kinds.UNDO, kinds.REDO})


def _totals(recorded: Mapping[str, Any]) -> Totals:
    """The totals of a record; one of another version may have others."""
    return Totals(**{f.name: recorded.get(f.name, f.default) for f in fields(Totals)})


def _reply(event: Event, state: RobotState) -> Reply:
    record = state.turn.learned if event.type == kinds.TEACHER else None
    learned = None if record is None else {"reply_to": event.seq, "record": dict(record)}
    return Reply(learned, robot_data(event.seq, state), state)
