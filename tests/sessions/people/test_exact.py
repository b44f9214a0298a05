"""The teacher of a record: the same to the bit, and a refusal where the robot does otherwise."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.people.corpus import settings as bundled
from tests.sessions.rooms import BOIL, TAUGHT, begin, recorded, settings
from verbteach.perception.noise import NoiseModel
from verbteach_sessions.driving import drive
from verbteach_sessions.errors import LogError, SessionError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.header import Header
from verbteach_sessions.people.exact import DivergedError, RecordedTeacher
from verbteach_sessions.people.recorded import read_header
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session


def test_a_record_teaches_the_same_session_to_the_bit(
    example: tuple[Path, ...], tmp_path: Path
) -> None:
    path = example[0]
    old = read_header(path)
    with Session.create(tmp_path, Header.new(old.scene, old.method), bundled()) as session:
        drive(session, RecordedTeacher(path))
        assert session.content_hash == verify(path, bundled()).content_hash


def test_what_was_taken_back_is_not_said_again(tmp_path: Path) -> None:
    script = BOIL.replace("done\n", "do: moveto Mug_1\nundo\ndone\n")
    path = recorded(tmp_path, script + "note: so\n")
    with begin(tmp_path) as session:
        teacher = RecordedTeacher(path)
        drive(session, teacher)
        plain = recorded(tmp_path, BOIL)
        assert session.content_hash == verify(plain, settings).content_hash
        assert teacher.said == len(BOIL.splitlines())


def test_a_robot_that_does_something_else_is_told_where(tmp_path: Path) -> None:
    """One that has never been shown asks; the one in the record carried it out."""
    path = recorded(tmp_path, TAUGHT + "good\n")
    with begin(tmp_path, scene="kitchen-3") as session:
        teacher = RecordedTeacher(path)
        with pytest.raises(DivergedError, match=r"event 1: .*in kitchen-3 instead of kitchen-1"):
            drive(session, teacher)
        assert teacher.said == 0


def test_the_first_difference_is_named_and_what_was_said_before_is_kept(tmp_path: Path) -> None:
    path = recorded(tmp_path, TAUGHT + "good\n")
    old = read_header(path)
    other = Header.new(old.scene, old.method.with_noise(NoiseModel.named("uniform")))
    with Session.create(tmp_path, other, settings) as session:
        teacher = RecordedTeacher(path)
        with pytest.raises(DivergedError, match="no answer to that") as refused:
            drive(session, teacher)
        assert 0 < teacher.said < len(TAUGHT.splitlines()) + 1
        assert refused.value.recorded != refused.value.now
        assert refused.value.recorded.name in str(refused.value)
        assert len([line for line in session.transcript() if line.speaker == "teacher"]) > 0


def test_a_damaged_record_is_refused(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    log = path / LOG_NAME
    log.write_bytes(log.read_bytes().replace(b"boil the water", b"boil the milk.", 1))
    with pytest.raises(LogError):
        RecordedTeacher(path)
    with pytest.raises(SessionError):
        RecordedTeacher(tmp_path / "nowhere")
