"""Letting a teacher teach: a script or a simulation says one thing whenever the robot waits."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Protocol

from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach_sessions.errors import CannotUndoError, ScriptError, TooLongError
from verbteach_sessions.recorder import MISFITS
from verbteach_sessions.script import LineSyntaxError, ScriptAct, parse_line
from verbteach_sessions.session import Session


class Speaker(Protocol):
    """A teacher who may also say things about the session; every ``Teacher`` is one."""

    def reply(self, turn: RobotTurn, state: RobotState) -> ScriptAct | None:
        """What is said to ``turn``; ``None`` when there is no more to say."""
        ...


class ScriptTeacher:
    """Says the lines of a script in order, whatever the robot waits for.

    ``lines`` are read one at a time, as they are needed, so that a pipe works.
    ``line`` is the number of the last one read, from 1, ``text`` what it says.
    """

    def __init__(self, lines: Iterable[str]) -> None:
        self._lines = enumerate(lines, start=1)
        self.line = 0
        self.text = ""

    def reply(self, turn: RobotTurn, state: RobotState) -> ScriptAct | None:
        """The next line's act. Raises :class:`ScriptError` on a line that names none."""
        for number, text in self._lines:
            self.line, self.text = number, text.strip()
            try:
                act = parse_line(text)
            except LineSyntaxError as error:
                raise self.misfit(error) from error
            if act is not None:
                return act
        return None

    def misfit(self, error: Exception) -> ScriptError:
        """The error that names the last line."""
        reason = error.args[0] if error.args else error
        return ScriptError(self.line, f"'{self.text[:80]}': {reason}")


def drive(
    session: Session,
    teacher: Speaker,
    on_turn: Callable[[Session], None] | None = None,
    via: str = "simulated",
) -> None:
    """Let ``teacher`` answer until it has no more to say or the session has ended.

    ``on_turn`` is called whenever the robot has spoken, before the teacher is
    asked; ``session.said`` is what it said. Raises what ``Session.perform`` raises, as
    :class:`ScriptError` where a script's line is at fault; what was said before
    is in the log.
    """
    while not session.ended:
        if on_turn is not None:
            on_turn(session)
        act = teacher.reply(session.turn, session.robot.state)
        if act is None:
            return
        _perform(session, act, teacher, via)


def _perform(session: Session, act: ScriptAct, teacher: Speaker, via: str) -> None:
    if not isinstance(teacher, ScriptTeacher):
        session.perform(act, via=via)
        return
    try:
        session.perform(act, raw=teacher.text, via="script")
    except (*MISFITS, CannotUndoError, TooLongError) as error:
        raise teacher.misfit(error) from error
