"""What does not fit, fails, is interrupted or is too long leaves log and state as they were."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.records import first, raw_lines, read_events
from tests.sessions.rooms import TAUGHT, begin, say
from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.moves import IllegalMoveError, Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import UnknownObjectError, UnknownSceneError
from verbteach.dialogue.turn import RobotTurn
from verbteach.world.fluents import Fluent, Literal
from verbteach_sessions.errors import TooLongError
from verbteach_sessions.lines import MAX_LINE
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Note


def kinds(session: Session) -> list[str]:
    return [event["type"] for event in read_events(session.path)]


@pytest.mark.parametrize(
    ("before", "misfit", "error"),
    [
        ("", acts.Yes(), IllegalMoveError),
        ("", acts.Good(), IllegalMoveError),
        ("", acts.GoToScene("the-moon"), UnknownSceneError),
        (
            TAUGHT + "bad\ndo: moveto Mug_1\ndo: grasp Mug_1\ndone\n",
            acts.Strike(Literal(Fluent("hot", ("Nothing",)))),
            IllegalMoveError,
        ),
    ],
)
def test_what_does_not_fit_leaves_log_and_state_as_they_were(
    tmp_path: Path, before: str, misfit: TeacherAct, error: type[Exception]
) -> None:
    with begin(tmp_path) as session:
        say(session, before)
        lines, state = raw_lines(session.path), session.robot.state
        with pytest.raises(error):
            session.perform(misfit)
        assert raw_lines(session.path) == lines
        assert session.robot.state is state


def test_pointing_at_nothing_leaves_log_and_state_as_they_were(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: wash the glorp\n")
        assert session.turn.phase is Phase.EXECUTION
        lines, state = raw_lines(session.path), session.robot.state
        with pytest.raises(UnknownObjectError):
            session.perform(acts.Point("Nothing_1"))
        assert raw_lines(session.path) == lines
        assert session.robot.state is state


def test_a_robot_that_fails_leaves_a_fault_and_the_session_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(robot: Robot, act: TeacherAct) -> RobotTurn:
        raise RuntimeError("a bug")

    with begin(tmp_path) as session:
        say(session, "command: boil the water")
        state = session.robot.state
        with monkeypatch.context() as patched:
            patched.setattr(Robot, "receive", broken)
            with pytest.raises(RuntimeError, match="a bug"):
                session.perform(acts.Skip())
        assert session.robot.state is state
        assert kinds(session)[-2:] == ["teacher", "fault"]
        assert first(read_events(session.path), "fault")["data"]["message"] == "a bug"
        assert "skip" not in [line.kind for line in session.transcript()]
        session.perform(acts.Skip())
        assert session.turn.phase is Phase.COMMAND


def test_an_interrupted_robot_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(robot: Robot, act: TeacherAct) -> RobotTurn:
        raise KeyboardInterrupt

    with begin(tmp_path) as session:
        lines = raw_lines(session.path)
        with monkeypatch.context() as patched:
            patched.setattr(Robot, "receive", interrupted)
            with pytest.raises(KeyboardInterrupt):
                session.perform(acts.Command("boil the water"))
        assert raw_lines(session.path) == lines


def test_what_is_too_long_for_a_line_is_refused_and_nothing_kept(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        lines = raw_lines(session.path)
        for act in (Note("x" * MAX_LINE), acts.Command("boil" + " the water" * (MAX_LINE // 10))):
            with pytest.raises(TooLongError, match="too long to be kept"):
                session.perform(act)
        assert raw_lines(session.path) == lines
