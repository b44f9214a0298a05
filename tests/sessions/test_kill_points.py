"""Killed (SIGKILL) at every event's boundary or any byte of a write, a session loses nothing."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.sessions.records import raw_lines, read_events
from tests.sessions.rooms import BOIL, begin, resumed, say, settings
from verbteach_sessions.errors import SessionInUseError, StorageError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session

SCRIPT = (
    "note: before\ncommand: boil the water\ndo: moveto Kettle_1\nundo\nredo\nflag\n"
    + BOIL.split("\n", 2)[2]
    + "scene: kitchen-3\ncommand: boil the water\ngood\nrepeat\n"
)
LINES = SCRIPT.splitlines()
SAID = {"teacher", "undo", "redo", "note", "flag", "repeat"}

# Makes a process for each order, "folder write point share": it holds the script in a session
# there and kills itself at that point of that write, having written that share of the bytes.
DYING = f"""
import os, signal, sys
from pathlib import Path
from tests.sessions.rooms import begin, settings
from verbteach_sessions import checkpoints, eventlog
from verbteach_sessions.driving import ScriptTeacher, drive

SCRIPT = {SCRIPT!r}
checkpoints.EVERY = 5
write_all, fsync = eventlog.write_all, os.fsync
die = lambda: os.kill(os.getpid(), signal.SIGKILL)

def teach(folder, last, point, share):
    count = 0
    def writing(fd, block):
        nonlocal count
        count += 1
        if count != last:
            return write_all(fd, block)
        if point == "before":
            die()
        write_all(fd, block[: int(share * len(block))] if point == "torn" else block)
        if point in ("torn", "written"):
            die()
    def syncing(fd):
        fsync(fd)
        if count == last and point == "synced":
            die()
    eventlog.write_all = writing
    eventlog.os.fsync = syncing
    heard = os.open(folder / "acknowledged", os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    def acknowledge(session):
        os.write(heard, (session.robot.state.digest + "\\n").encode())
    drive(begin(folder), ScriptTeacher(SCRIPT.splitlines()), acknowledge)

settings("kitchen-1"), settings("kitchen-3")
for line in sys.stdin:
    folder, last, point, share = line.rsplit(" ", 3)
    child = os.fork()
    if child == 0:
        teach(Path(folder), int(last), point, float(share))
        os._exit(0)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""


@pytest.fixture(scope="module")
def school() -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [sys.executable, "-c", DYING], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as program:
        yield program
        program.communicate()


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> tuple[list[str], str]:
    """The states of the session that nobody killed, line by line, and its content hash."""
    with begin(tmp_path_factory.mktemp("whole")) as session:
        states = [session.robot.state.digest]
        for line in LINES:
            say(session, line)
            states.append(session.robot.state.digest)
        return states, session.content_hash


def killed(school: subprocess.Popen[str], folder: Path, order: str) -> Path | None:
    """The session of a process that was killed so; ``None`` if it had no log yet."""
    folder.mkdir()
    assert school.stdin is not None
    assert school.stdout is not None
    school.stdin.write(f"{folder} {order}\n")
    school.stdin.flush()
    assert school.stdout.readline() == "-9\n", "it was killed"
    return next((path.parent for path in folder.glob(f"*/{LOG_NAME}")), None)


def kept_lines(log: bytes) -> list[bytes]:
    """The whole lines, but for what was learned without a reply: that is written again."""
    lines = [line for line in log.splitlines(keepends=True) if line.endswith(b"\n")]
    return lines[:-1] if b'"type":"learned"' in lines[-1] else lines


def check(path: Path, states: list[str], content: str) -> tuple[str, ...]:
    """What was acknowledged is there, the state is the one there was, and it can go on."""
    acknowledged = (path.parent / "acknowledged").read_text().split()
    before = (path / LOG_NAME).read_bytes()
    with resumed(path) as session:
        said = sum(event["type"] in SAID for event in read_events(path))
        assert acknowledged == states[: len(acknowledged)]
        assert said in (len(acknowledged) - 1, len(acknowledged)), "one act at most is new"
        assert session.robot.state.digest == states[said]
        assert b"".join(raw_lines(path)).startswith(b"".join(kept_lines(before)))
        recovered = session.recovered
        for line in LINES[said:]:
            say(session, line)
        assert session.robot.state.digest == states[-1]
        assert session.content_hash == content
    assert verify(path, settings).verified
    return recovered


@pytest.mark.slow
def test_killed_at_every_boundary_and_at_any_byte(
    school: subprocess.Popen[str], whole: tuple[list[str], str], tmp_path: Path
) -> None:
    rng = np.random.default_rng(11)
    counts: Counter[str] = Counter()
    writes = 2 + len(LINES) + sum(not line.startswith(tuple("nufr")) for line in LINES)
    for write in range(3, writes + 1):
        points = [("before", 0.0), ("written", 1.0), ("synced", 1.0)]
        points += [("torn", share) for share in rng.uniform(0.0, 1.0, 2).tolist()]
        for point, share in points:
            folder = tmp_path / f"{write}-{sum(counts.values())}"
            path = killed(school, folder, f"{write} {point} {share}")
            assert path is not None
            counts[point] += 1
            recovered = check(path, *whole)
            counts["told"] += bool(recovered)
            assert recovered or point != "torn" or share * 50 < 1
    print(f"\nkilled {sum(counts.values()) - counts['told']} times: {dict(counts)}; nothing lost")


def test_killed_at_some_points(
    school: subprocess.Popen[str], whole: tuple[list[str], str], tmp_path: Path
) -> None:
    orders = ("3 torn 0.5", "9 torn 0.9", "14 written 1", "20 synced 1", "21 before 0")
    for number, order in enumerate(orders):
        path = killed(school, tmp_path / str(number), order)
        assert path is not None
        check(path, *whole)


def test_killed_while_it_is_made_there_is_no_session_or_one_that_goes_on(
    school: subprocess.Popen[str], whole: tuple[list[str], str], tmp_path: Path
) -> None:
    for number, order in enumerate(("1 torn 0.4", "1 synced 1", "2 torn 0.3", "2 synced 1")):
        path = killed(school, tmp_path / str(number), order)
        assert path is not None
        if order == "1 torn 0.4":
            with pytest.raises(Exception, match="nothing was said"):
                resumed(path)
            continue
        with resumed(path) as session:
            assert session.robot.state.digest == whole[0][0]


def test_a_second_process_cannot_write(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        lines = raw_lines(session.path)
        child = os.fork()
        if child == 0:
            try:
                resumed(session.path)
            except SessionInUseError as error:
                os._exit(42 if f"process {os.getppid()}" in str(error) else 1)
            os._exit(2)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 42
        assert raw_lines(session.path) == lines
        say(session, "note: still mine\n")


def fill(session: Session, spoken: list[str]) -> None:
    """Write notes, and keep those that were acknowledged, until there is no more room."""
    while True:
        say(session, "note: and so on")
        spoken.append("and so on")


@pytest.mark.slow
def test_a_small_disk_that_is_full_loses_nothing(tmp_path: Path) -> None:
    """On a real file system of 48 KiB, made larger afterwards."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=48k", "none", str(disk)]
    if os.geteuid() != 0 or subprocess.run(mount, check=False, capture_output=True).returncode:
        pytest.skip("file systems can be made here by nobody but root")
    try:
        with begin(disk) as session:
            spoken: list[str] = []
            with pytest.raises(StorageError, match="the disk is full"):
                fill(session, spoken)
            state, lines = session.robot.state, raw_lines(session.path)
            assert len(lines) == 2 + len(spoken), "what was acknowledged and nothing more"
            subprocess.run(["mount", "-o", "remount,size=1m", str(disk)], check=True)
            say(session, "note: there is room again")
            assert raw_lines(session.path)[: len(lines)] == lines
            assert session.robot.state is state
        assert verify(session.path, settings).verified
    finally:
        subprocess.run(["umount", str(disk)], check=True)
