"""Beginning a session, what is on the disk before and after an act, and ending it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.sessions.records import first, read_events
from tests.sessions.rooms import BOIL, TAUGHT, begin, recorded, say
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.codec import teacher_act_to_json
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import UnknownSceneError
from verbteach.dialogue.turn import RobotTurn
from verbteach_sessions.errors import SessionEndedError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.header_file import HEADER_NAME
from verbteach_sessions.session import Session, summary
from verbteach_sessions.session_acts import Flag


def kinds(session: Session) -> list[str]:
    return [event["type"] for event in read_events(session.path)]


def test_a_new_session_is_on_the_disk_with_its_header(tmp_path: Path) -> None:
    with begin(tmp_path, terminal=(120, 40), participant="p7") as session:
        assert session.path == tmp_path / session.header.id
        header, robot = read_events(session.path)
        shown = json.loads((session.path / HEADER_NAME).read_text())
        assert shown == {"v": 2, **header["data"]}
        assert header["data"]["terminal"] == [120, 40]
        assert robot["data"]["texts"] == list(session.turn.texts) == list(session.said)
        assert session.turn.phase is Phase.COMMAND


def test_nothing_in_a_session_is_open_to_others(tmp_path: Path) -> None:
    with begin(tmp_path / "sessions") as session:
        for path in (session.path.parent, session.path, *session.path.iterdir()):
            assert path.stat().st_mode & 0o077 == 0, path


def test_an_unknown_scene_leaves_no_session_behind(tmp_path: Path) -> None:
    with pytest.raises(UnknownSceneError):
        begin(tmp_path, "the-moon")
    assert list(tmp_path.iterdir()) == []


def test_the_teachers_act_is_on_the_disk_before_the_robot_thinks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[str] = []
    receive = Robot.receive

    def spied(robot: Robot, act: TeacherAct) -> RobotTurn:
        last = read_events(session.path)[-1]
        assert last["data"]["act"] == teacher_act_to_json(act)
        seen.append(last["type"])
        return receive(robot, act)

    with begin(tmp_path) as session:
        monkeypatch.setattr(Robot, "receive", spied)
        say(session, BOIL)
        assert seen == ["teacher"] * len(BOIL.splitlines())
        assert kinds(session)[-1] == "robot"


def test_what_is_acknowledged_is_on_the_disk(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        for line in BOIL.splitlines():
            say(session, line)
            robot = first(read_events(session.path)[::-1], "robot")["data"]
            assert robot["texts"] == list(session.turn.texts)
            assert robot["after"]["digest"] == session.robot.state.digest


def test_quitting_ends_the_session_but_not_its_record(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: boil the water\nquit")
        assert session.ended
        with pytest.raises(SessionEndedError, match="resume it"):
            session.perform(Flag())
        assert kinds(session)[-1] == "end"


def test_what_teach_prints_of_a_session(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, TAUGHT + "good\n")
        printed = summary(session)
        assert printed["session"] == str(session.path)
        assert (printed["episodes"], printed["successes"]) == (2, 1)
        assert printed["verbs_learned"] == ["boil"]
        assert printed["reward"] == 200.0
        assert json.loads(json.dumps(printed)) == printed


def test_session_time_starts_at_zero_and_runs_forward(tmp_path: Path) -> None:
    events = read_events(recorded(tmp_path, TAUGHT + "why\ngood\nundo\nredo\n"))
    times = [event["at"] for event in events]
    assert times[0] == 0.0
    assert times == sorted(times)
    assert (tmp_path / events[0]["data"]["id"] / LOG_NAME).exists()
