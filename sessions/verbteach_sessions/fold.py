"""The fold: from a session's events to the robot's state, live and from a record alike.

A reply is computed first and holds only once its event is taken, so whoever
drives the fold can put the event on the disk, or compare it with a recorded
one, in between.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

from verbteach.dialogue.codec import teacher_act_from_json
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState, Totals
from verbteach_sessions import events as kinds
from verbteach_sessions.content import ContentHash
from verbteach_sessions.header import Header
from verbteach_sessions.history import History
from verbteach_sessions.lines import Event
from verbteach_sessions.recording import robot_data


@dataclass(frozen=True)
class Reply:
    """What the robot replies to an event: the events' data, and the state after them."""

    learned: Mapping[str, Any] | None
    robot: Mapping[str, Any]
    state: RobotState


class Fold:
    """A session's state so far.

    ``states`` holds the robot's state after each of its turns. They are
    immutable, so going back to one is exact and costs nothing.
    """

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.history = History()
        self.content = ContentHash()
        self.states: dict[int, RobotState] = {}
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
        self.history.take(event)
        self.content.add(event)
        if event.type == kinds.HEADER:
            self._header = Header.from_json(event.data)
        if reply is not None:
            self.states[event.seq] = reply.state
        if event.type in _MOVES and self.state is not None:
            self._stand(self.state)

    def _answer(self, event: Event) -> RobotState:
        act = teacher_act_from_json(event.data["act"])
        before = self.robot.state
        try:
            self.robot.receive(act)
            return self.robot.state
        finally:
            self.robot.state = before

    def _begin(self, event: Event) -> RobotState:
        records = [*self.header.learned_before]
        if event.type == kinds.REBUILD:
            records += self.history.records()
        robot = self.header.method.robot(self.settings, records)
        robot.open(event.data["scene"])
        if event.type == kinds.REBUILD and self.history.current is not None:
            totals = _totals(self.history.current.after["totals"])
            return replace(robot.state, totals=totals)
        return robot.state

    def _stand(self, state: RobotState) -> None:
        if self._robot is None:
            self._robot = self.header.method.robot(self.settings)
        self._robot.state = state


_MOVES = frozenset({kinds.ROBOT, kinds.UNDO, kinds.REDO})


def _totals(recorded: Mapping[str, Any]) -> Totals:
    """The totals of a record; one of another version may have others."""
    return Totals(**{f.name: recorded.get(f.name, f.default) for f in fields(Totals)})


def _reply(event: Event, state: RobotState) -> Reply:
    record = state.turn.learned if event.type == kinds.TEACHER else None
    learned = None if record is None else {"reply_to": event.seq, "record": dict(record)}
    return Reply(learned, robot_data(event.seq, state), state)
