"""Whatever ends the process or the disk: nothing acknowledged is lost, and the session goes on."""

from __future__ import annotations

import errno
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest

from tests.sessions.records import first, forge, raw_lines, read_events
from tests.sessions.rooms import BOIL, begin, recorded, resumed, say, settings
from verbteach.dialogue import acts
from verbteach_sessions.errors import NotASessionError, SessionInUseError, StorageError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.header_file import HEADER_NAME
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Flag


def states_in_order(events: list[dict[str, Any]]) -> list[str]:
    """The states that held one after the other."""
    return [event["data"]["after"]["digest"] for event in events if "after" in event["data"]]


def test_a_log_cut_at_any_byte_of_its_last_turn_resumes(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    lines, whole = raw_lines(path), (path / LOG_NAME).read_bytes()
    states = states_in_order(read_events(path))
    turn = sum(map(len, lines[:-3]))  # the teacher's "good", what was learned, the reply
    said = turn + len(lines[-3]) - 1  # here the "good" is whole but for its newline
    rng = np.random.default_rng(7)
    every = {turn, said - 1, said, said + 1, len(whole) - 2, len(whole) - 1, len(whole)}
    for cut in sorted(every | set(rng.integers(turn, len(whole), 12).tolist())):
        (path / LOG_NAME).write_bytes(whole[:cut])
        with resumed(path) as session:
            # An act that is on the disk is answered; one that is not was never said.
            assert session.robot.state.digest == states[-1 if cut >= said else -2], cut
            assert bool(session.recovered) == (cut not in (turn, len(whole))), cut
        assert verify(path, settings).first_difference is None
        assert (path / LOG_NAME).read_bytes().startswith(whole[: turn if cut < said else said])


def test_a_log_cut_before_the_robot_first_spoke_begins_again(tmp_path: Path) -> None:
    path = recorded(tmp_path, "")
    header, first = raw_lines(path)
    for cut in (len(header), len(header) + 1, len(header) + len(first) - 2):
        (path / LOG_NAME).write_bytes((header + first)[:cut])
        with resumed(path) as session:
            say(session, BOIL)
            assert session.robot.state.knowledge.verbs == ("boil",)
    (path / LOG_NAME).write_bytes(header[:-9])
    with pytest.raises(NotASessionError):
        resumed(path)


def test_a_session_cut_short_has_the_hash_of_one_that_was_not(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    hashed = verify(path, settings).content_hash
    whole = (path / LOG_NAME).read_bytes()
    for lines in (1, 2):
        (path / LOG_NAME).write_bytes(b"".join(raw_lines(path)[:-lines]))
        with resumed(path) as session:
            assert session.content_hash == hashed
            assert session.recovered
            assert "not answered" in session.recovered[-1]
        (path / LOG_NAME).write_bytes(whole)


def test_an_act_that_cannot_be_answered_after_a_crash_does_not_count(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)

    def misfit(events: list[dict[str, Any]]) -> None:
        teacher = dict(first(events, "teacher", -1)["data"])
        person = {**teacher, "reply_to": len(events) - 1, "act": {"act": "done"}}
        events.append({"type": "teacher", "at": events[-1]["at"], "data": person})

    forge(path, misfit)
    for times in (1, 2):
        with resumed(path) as session:
            assert ("could not be answered" in " ".join(session.recovered)) == (times == 1)
            assert session.robot.state.knowledge.verbs == ("boil",)
            assert session.turn.phase.value == "command"
    assert [event["type"] for event in read_events(path)][-3:] == ["resume", "fault", "resume"]
    assert verify(path, settings).verified


def test_the_header_file_is_made_again_from_the_log(tmp_path: Path) -> None:
    path = recorded(tmp_path, "")
    right = (path / HEADER_NAME).read_bytes()
    for wrong in (None, b"", right.replace(b"kitchen-1", b"kitchen-2")):
        (path / HEADER_NAME).unlink()
        if wrong is not None:
            (path / HEADER_NAME).write_bytes(wrong)
        resumed(path).close()
        assert (path / HEADER_NAME).read_bytes() == right


# Makes a process for each folder named to it, which teaches there until it is killed.
TEACHING = """
import os
import sys
from pathlib import Path
from tests.sessions.rooms import settings
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session

def teach(folder):
    session = Session.create(folder, Header.new("kitchen-1"), settings)
    heard = os.open(folder / "acknowledged", os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    def acknowledge(session):
        os.write(heard, (session.robot.state.digest + "\\n").encode())
    for script in [sys.argv[1], *[sys.argv[2]] * 1000]:
        drive(session, ScriptTeacher(script.splitlines()), acknowledge)

settings("kitchen-1"), settings("kitchen-3")
for line in sys.stdin:
    child = os.fork()
    if child == 0:
        teach(Path(line.strip()))
        os._exit(0)
    print(child, flush=True)
    os.waitpid(child, 0)
    print("ended", flush=True)
"""
AGAIN = (
    "scene: kitchen-1\ncommand: boil the water\nundo\ncommand: boil the water\nbad\n"
    "do: moveto Mug_1\nskip\nscene: kitchen-3\ncommand: boil the water\ngood\n"
)


def killed_while_teaching(school: subprocess.Popen[str], folder: Path, seconds: float) -> Path:
    """The folder of a session whose process was killed so long after its first acknowledgement."""
    assert school.stdin is not None
    assert school.stdout is not None
    school.stdin.write(f"{folder}\n")
    school.stdin.flush()
    teaching = int(school.stdout.readline())
    while not (folder / "acknowledged").exists():
        time.sleep(0.001)
    time.sleep(seconds)
    os.kill(teaching, signal.SIGKILL)
    assert school.stdout.readline() == "ended\n"
    return next(path for path in folder.iterdir() if path.is_dir())


def check_after_a_kill(path: Path, acknowledged: list[str]) -> None:
    with resumed(path) as session:
        kept = states_in_order(read_events(path))
        later = kept[len(kept) - kept[::-1].index(acknowledged[-1]) :]
        assert len(later) <= 1, "at most the act that was being answered is new"
        assert set(acknowledged) <= set(kept)
        assert session.robot.state.digest == kept[-1]
        assert session.perform(Flag()) is session.turn
    assert verify(path, settings).verified


def test_processes_killed_at_random_moments_lose_nothing(tmp_path: Path) -> None:
    rng = np.random.default_rng(20)
    program = [sys.executable, "-c", TEACHING, BOIL, AGAIN]
    with subprocess.Popen(
        program, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as school:
        for number, seconds in enumerate(rng.uniform(0.0, 0.3, 16).tolist()):
            folder = tmp_path / str(number)
            folder.mkdir()
            path = killed_while_teaching(school, folder, seconds)
            heard = (folder / "acknowledged").read_text()
            if "\n" in heard:
                check_after_a_kill(path, heard[: heard.rindex("\n")].split("\n"))
        school.communicate()


@contextmanager
def files_no_larger_than(size: int) -> Iterator[None]:
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def test_a_disk_that_fills_at_any_byte_of_a_turn_takes_nothing_of_it(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    lines = raw_lines(path)
    size = sum(map(len, lines[:-3]))
    turn = sum(map(len, lines[-3:]))
    before = b"".join(lines[:-3])
    for room in (
        0,
        1,
        len(lines[-3]) - 1,
        len(lines[-3]),
        len(lines[-3]) + 7,
        turn // 2,
        turn - 60,
    ):
        with TemporaryDirectory() as copied:
            copy = Path(shutil.copytree(path, Path(copied) / path.name))
            (copy / LOG_NAME).write_bytes(before)
            with resumed(copy) as session:
                kept, state = raw_lines(copy), session.robot.state
                used = sum(map(len, kept))
                assert used > size
                with files_no_larger_than(used + room), pytest.raises(StorageError):
                    session.perform(acts.Good())
                assert raw_lines(copy) == kept
                assert session.robot.state is state
                session.perform(acts.Good())
                assert session.robot.state.knowledge.verbs == ("boil",)
            assert verify(copy, settings).verified


def test_a_session_that_cannot_begin_leaves_nothing(tmp_path: Path) -> None:
    for size in (0, 500, 5000):
        with files_no_larger_than(size), pytest.raises(StorageError):
            begin(tmp_path, study={"note": "x" * 5000})
        assert list(tmp_path.iterdir()) == []


def test_a_disk_that_breaks_between_act_and_reply_is_recovered_from(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = 0

    def breaking(fd: int) -> None:
        nonlocal calls
        calls += 1
        if calls > 1:
            raise OSError(errno.EIO, os.strerror(errno.EIO))

    with begin(tmp_path) as session:
        state = session.robot.state
        with monkeypatch.context() as patched:
            patched.setattr(os, "fsync", breaking)
            with pytest.raises(StorageError):
                session.perform(acts.Command("boil the water"))
        assert session.robot.state is state
        with pytest.raises(StorageError):
            session.perform(acts.Command("boil the water"))
    with resumed(session.path) as again:
        say(again, "" if again.can_undo else "command: boil the water")
        assert again.turn.phase.value == "demonstration"


@pytest.fixture
def unprivileged(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder to work in as somebody for whom permissions count."""
    with TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        root = os.geteuid() == 0
        if root:
            os.chown(folder, 65534, 65534)
            os.seteuid(65534)
        try:
            yield Path(folder)
        finally:
            if root:
                os.seteuid(0)


def test_a_folder_that_cannot_be_written_is_named(unprivileged: Path) -> None:
    locked = unprivileged / "locked"
    locked.mkdir(mode=0o500)
    with pytest.raises(StorageError, match=r"locked.*permission to write is missing"):
        begin(locked)
    assert list(locked.iterdir()) == []


def test_a_session_that_cannot_be_written_can_be_verified_but_not_resumed(
    unprivileged: Path,
) -> None:
    path = recorded(unprivileged, BOIL)
    for name in (path / LOG_NAME, path / "writer.lock"):
        name.chmod(0o400)
    path.chmod(0o500)
    with pytest.raises(StorageError, match="permission to write is missing"):
        resumed(path)
    assert verify(path, settings).verified
    path.chmod(0o700)


def test_two_sessions_cannot_write_to_one_record(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        with pytest.raises(SessionInUseError):
            resumed(session.path)
        say(session, "command: boil the water")
    with resumed(session.path) as again:
        assert again.turn.phase.value == "demonstration"


def test_creating_where_a_session_is_already_is_refused(tmp_path: Path) -> None:
    with begin(tmp_path) as session, pytest.raises(StorageError):
        Session.create(tmp_path, session.header, settings)
