from __future__ import annotations

import errno
import os
import resource
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from verbteach_sessions import eventlog
from verbteach_sessions.errors import (
    DamagedLogError,
    LogError,
    NewerLogError,
    NotASessionError,
    SessionInUseError,
    StorageError,
)
from verbteach_sessions.eventlog import LOG_NAME, Draft, EventLog, LogReader
from verbteach_sessions.lines import MAX_LINE, Event

DRAFTS = [Draft("note", float(n), {"text": f"note {n} " + "é\n" * n}) for n in range(5)]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    with_log(tmp_path)
    return tmp_path


def with_log(folder: Path) -> None:
    log = EventLog.create(folder)
    for draft in DRAFTS:
        log.append([draft])
    log.close()


def reopened(folder: Path) -> tuple[list[Event], tuple[str, ...]]:
    events: list[Event] = []
    log, warnings = EventLog.open(folder, events.append)
    log.close()
    return events, warnings


def texts(events: list[Event]) -> list[str]:
    return [event.data["text"] for event in events]


def lines_of(folder: Path) -> list[bytes]:
    return (folder / LOG_NAME).read_bytes().splitlines(keepends=True)


def test_what_was_appended_is_read_back(folder: Path) -> None:
    reader = LogReader(folder)
    events = list(reader)
    assert [(e.seq, e.type, e.at, e.data) for e in events] == [
        (n, *draft) for n, draft in enumerate(DRAFTS)
    ]
    assert reader.warnings == ()
    assert reader.position.size == (folder / LOG_NAME).stat().st_size


def test_a_file_and_its_folder_are_the_same_session(folder: Path) -> None:
    assert list(LogReader(folder / LOG_NAME)) == list(LogReader(folder))


def test_several_events_are_appended_as_one(tmp_path: Path) -> None:
    log = EventLog.create(tmp_path)
    events = log.append(DRAFTS)
    log.close()
    assert list(LogReader(tmp_path)) == list(events)


def test_appending_goes_on_where_the_log_ended(folder: Path) -> None:
    log, _ = EventLog.open(folder, lambda event: None)
    log.append([Draft("note", 9.0, {"text": "later"})])
    log.close()
    assert texts(list(LogReader(folder)))[-1] == "later"


def test_files_are_private(folder: Path) -> None:
    for path in folder.iterdir():
        assert path.stat().st_mode & 0o077 == 0, path


def test_a_log_cut_at_any_byte_keeps_every_whole_line(folder: Path) -> None:
    path = folder / LOG_NAME
    whole = path.read_bytes()
    ends = [0]
    for line in lines_of(folder):
        ends.append(ends[-1] + len(line))
    for cut in range(ends[1], len(whole) + 1):
        path.write_bytes(whole[:cut])
        # A line that lacks nothing but its newline is whole.
        kept = sum(end - 1 <= cut for end in ends[1:])
        reader = LogReader(folder)
        assert len(list(reader)) == kept
        assert bool(reader.warnings) == (cut not in ends)
        assert path.read_bytes() == whole[:cut], "reading must not write"
        events, warnings = reopened(folder)
        assert (len(events), bool(warnings)) == (kept, cut not in ends)
        assert path.read_bytes() == whole[: ends[kept]]


def test_a_log_cut_within_its_first_line_holds_nothing(folder: Path) -> None:
    path = folder / LOG_NAME
    first = lines_of(folder)[0]
    for cut in range(len(first) - 1):
        path.write_bytes(first[:cut])
        with pytest.raises(NotASessionError, match="nothing was said"):
            reopened(folder)


@pytest.mark.parametrize("line", range(5))
def test_an_edited_line_is_named_with_what_to_do(folder: Path, line: int) -> None:
    lines = lines_of(folder)
    lines[line] = lines[line].replace(b"note ", b"mote ", 1)
    (folder / LOG_NAME).write_bytes(b"".join(lines))
    with pytest.raises(DamagedLogError) as refused:
        list(LogReader(folder))
    message = str(refused.value)
    assert message.count("\n") == 0
    assert f"{folder / LOG_NAME}, line {line + 1}: was changed" in message
    assert "restore the file from a copy" in message


@pytest.mark.parametrize("line", range(4))
def test_a_missing_line_is_named(folder: Path, line: int) -> None:
    lines = lines_of(folder)
    del lines[line]
    (folder / LOG_NAME).write_bytes(b"".join(lines))
    with pytest.raises(DamagedLogError, match=f"line {line + 1}: is event {line + 1} where"):
        list(LogReader(folder))


def test_a_line_from_another_log_is_found(
    folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    other = tmp_path_factory.mktemp("other")
    log = EventLog.create(other)
    log.append([Draft("note", 0.0, {"text": "another beginning"})])
    log.append(DRAFTS[1:])
    log.close()
    mixed = [*lines_of(folder)[:2], *lines_of(other)[2:]]
    (folder / LOG_NAME).write_bytes(b"".join(mixed))
    with pytest.raises(DamagedLogError, match="line 3: does not follow"):
        list(LogReader(folder))


def test_a_cut_in_the_middle_of_the_file_is_no_torn_line(folder: Path) -> None:
    lines = lines_of(folder)
    lines[2] = lines[2][:40] + b"\n"
    (folder / LOG_NAME).write_bytes(b"".join(lines))
    with pytest.raises(LogError, match="line 3: is not JSON"):
        reopened(folder)
    assert (folder / LOG_NAME).read_bytes() == b"".join(lines), "nothing may be repaired"


def test_a_newer_version_is_refused_by_name(folder: Path) -> None:
    newer = b'{"v":7,"what":"nobody here knows"}'
    for end in (b"\n", b""):
        (folder / LOG_NAME).write_bytes(b"".join(lines_of(folder)[:5]) + newer + end)
        with pytest.raises(NewerLogError, match=r"line 6: is of version 7.*update verbteach"):
            reopened(folder)


def test_an_endless_line_is_refused_in_bounded_memory(folder: Path) -> None:
    with (folder / LOG_NAME).open("ab") as file:
        file.truncate(file.tell() + 50 * MAX_LINE)  # a hole: NUL bytes that need no disk
    with pytest.raises(LogError, match=f"longer than {MAX_LINE} bytes"):
        list(LogReader(folder))


def test_what_is_no_file_is_refused_and_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / LOG_NAME)
    with pytest.raises(NotASessionError, match="not a plain file"):
        list(LogReader(tmp_path))
    with pytest.raises(NotASessionError, match=LOG_NAME):
        reopened(tmp_path / "nowhere")


def test_a_link_is_neither_read_nor_written_through(
    folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    (elsewhere / LOG_NAME).symlink_to(folder / LOG_NAME)
    with pytest.raises(NotASessionError, match="it is a link"):
        list(LogReader(elsewhere))
    with pytest.raises(NotASessionError, match="it is a link"):
        reopened(elsewhere)


def test_a_second_writer_is_refused_and_told_who_the_first_is(folder: Path) -> None:
    first, _ = EventLog.open(folder, lambda event: None)
    with pytest.raises(SessionInUseError, match=f"open in another place .process {os.getpid()}"):
        reopened(folder)
    first.close()
    assert len(reopened(folder)[0]) == len(DRAFTS)


def test_a_dead_writers_lock_does_not_block(folder: Path) -> None:
    program = (
        "import os, signal, sys\n"
        "from pathlib import Path\n"
        "from verbteach_sessions.eventlog import EventLog\n"
        "log, _ = EventLog.open(Path(sys.argv[1]), lambda event: None)\n"
        "print('open', flush=True)\n"
        "sys.stdin.read()\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program, str(folder)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"open\n"
        with pytest.raises(SessionInUseError, match=f"process {holder.pid}"):
            reopened(folder)
        holder.kill()
    assert len(reopened(folder)[0]) == len(DRAFTS)


@contextmanager
def files_no_larger_than(size: int) -> Iterator[None]:
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def test_a_disk_that_takes_half_a_line_keeps_none_of_it(folder: Path) -> None:
    size = (folder / LOG_NAME).stat().st_size
    log, _ = EventLog.open(folder, lambda event: None)
    position = log.position
    with files_no_larger_than(size + 60), pytest.raises(StorageError, match="may not grow"):
        log.append([Draft("note", 9.0, {"text": "too long for what is left"})])
    assert log.position == position
    assert (folder / LOG_NAME).stat().st_size == size
    log.append([Draft("note", 9.0, {"text": "there is room again"})])
    log.close()
    assert texts(list(LogReader(folder)))[-1] == "there is room again"


@pytest.mark.parametrize("call", ["write_all", "fsync"])
def test_a_full_disk_is_an_error_with_its_reason(
    folder: Path, monkeypatch: pytest.MonkeyPatch, call: str
) -> None:
    def full(*args: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    log, _ = EventLog.open(folder, lambda event: None)
    with monkeypatch.context() as patched:
        if call == "fsync":
            done = iter([full])  # the first fsync fails, that of the repair does not
            patched.setattr(os, "fsync", lambda fd: next(done, lambda: None)())
        else:
            patched.setattr(eventlog, "write_all", full)
        with pytest.raises(StorageError, match="the disk is full"):
            log.append([Draft("note", 9.0, {"text": "lost"})])
    log.append([Draft("note", 9.0, {"text": "kept"})])
    log.close()
    assert texts(list(LogReader(folder)))[-1] == "kept"


def test_after_a_failure_that_could_not_be_repaired_nothing_more_is_written(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*args: object) -> None:
        raise OSError(errno.EIO, os.strerror(errno.EIO))

    log, _ = EventLog.open(folder, lambda event: None)
    with monkeypatch.context() as patched:
        patched.setattr(os, "fsync", broken)
        with pytest.raises(StorageError):
            log.append([Draft("note", 9.0, {"text": "perhaps"})])
    with pytest.raises(StorageError):
        log.append([Draft("note", 9.0, {"text": "not after a perhaps"})])
    log.close()
    assert len(reopened(folder)[0]) >= len(DRAFTS)


def test_events_can_be_taken_back_until_they_are_acknowledged(folder: Path) -> None:
    before = lines_of(folder)
    log, _ = EventLog.open(folder, lambda event: None)
    position = log.position
    log.append([Draft("note", 9.0, {"text": "a misfit"})])
    log.take_back(position)
    assert lines_of(folder) == before
    log.append([Draft("note", 9.0, {"text": "a fit"})])
    log.close()
    assert texts(list(LogReader(folder)))[-1] == "a fit"
