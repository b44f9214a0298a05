"""The log of a session on disk: read line by line, appended to by one writer.

It knows bytes, hashes and the disk, and nothing of what the events mean.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple, NoReturn

from verbteach_sessions import lines
from verbteach_sessions.chain import Followed, Position, follow
from verbteach_sessions.errors import (
    DamagedLogError,
    LogError,
    NewerLogError,
    NotASessionError,
    StorageError,
    TooLongError,
)
from verbteach_sessions.files import open_private, open_regular, sync_folder, write_all
from verbteach_sessions.lines import MAX_LINE, Event
from verbteach_sessions.lock import WriterLock

LOG_NAME = "events.jsonl"


class Draft(NamedTuple):
    """An event not yet written."""

    type: str
    at: float
    data: Mapping[str, Any]


class Start(NamedTuple):
    """Where to begin reading: the lines before are followed, not read, and then handed over."""

    position: Position
    passed: Callable[[Followed], None]


def log_path(path: Path) -> Path:
    """The log's file, given it or its folder."""
    return path / LOG_NAME if path.is_dir() else path


def _opened(path: Path) -> BinaryIO:
    """The log, to be read. Raises ``NotASessionError``; of a folder of sessions it says so."""
    try:
        return open_regular(path)
    except NotASessionError as error:
        inside = sorted(path.parent.glob(f"*/{LOG_NAME}")) if path.name == LOG_NAME else []
        if path.exists() or not inside:
            raise
        example = inside[-1].parent
        raise NotASessionError(
            f"{path.parent}: is a folder of sessions; name one of them, as in {example}"
        ) from error


class LogReader:
    """Iterates over a log's events once, checking each line's hash, number and version.

    Raises :class:`LogError` at the first line that does not fit. A last line
    that was not written to its end is left out; ``torn`` then holds its bytes.
    ``position`` is the end of what was read, ``before_last`` the end before its
    last event. With a ``start``, reading begins there; :class:`BrokenChainError`
    where the lines before are not those that it knows. ``strict`` as for :func:`lines.decode`.
    """

    def __init__(self, path: Path, start: Start | None = None, *, strict: bool = False) -> None:
        self.path = log_path(path)
        self.position = self.before_last = Position()
        self.torn = b""
        self.unfinished = False
        self._start = start
        self._strict = strict

    def __iter__(self) -> Iterator[Event]:
        with _opened(self.path) as file:
            if self._start is not None:
                self._start.passed(follow(file, self._start.position))
                self.position = self.before_last = self._start.position
            while raw := file.readline(MAX_LINE + 1):
                if len(raw) > MAX_LINE:
                    self._refuse(LogError, f"is longer than {MAX_LINE} bytes")
                if raw.endswith(b"\n"):
                    yield self._read(raw)
                elif self._is_whole(raw):
                    self.unfinished = True
                    yield self._read(raw + b"\n")
                else:
                    self.torn = raw
        if self.position.seq == 0:
            raise NotASessionError(f"{self.path}: holds no event; nothing was said in this session")

    @property
    def warnings(self) -> tuple[str, ...]:
        """What was not as it should be and yet did no harm."""
        line = self.position.seq + 1
        if self.torn:
            return (
                f"line {line} was not written to its end ({len(self.torn)} bytes) and is left"
                " out; it had not been acknowledged",
            )
        return (f"line {line - 1} lacks its line end",) if self.unfinished else ()

    def _is_whole(self, raw: bytes) -> bool:
        try:
            lines.decode(raw)
        except lines.NewerVersionError:
            return True
        except lines.LineError:
            return False
        return True

    def _read(self, raw: bytes) -> Event:
        try:
            event, prev = lines.decode(raw[:-1], strict=self._strict)
        except lines.NewerVersionError as error:
            self._refuse(NewerLogError, str(error), "update verbteach to read it")
        except lines.ChangedLineError as error:
            self._refuse(DamagedLogError, str(error), self._restore())
        except lines.AmbiguousLineError as error:
            self._refuse(LogError, str(error))
        except lines.LineError as error:
            # After a first line that was whole this is a log, and every line of it was whole once.
            kind = DamagedLogError if self.position.seq else LogError
            self._refuse(kind, str(error), self._restore())
        self._check_chain(event, prev)
        seq, _, size = self.before_last = self.position
        self.position = Position(seq + 1, sha256(raw).hexdigest(), size + len(raw))
        return event

    def _check_chain(self, event: Event, prev: str) -> None:
        expected = self.position.seq
        if event.seq != expected:
            problem = f"is event {event.seq} where event {expected} should stand"
            self._refuse(DamagedLogError, problem, self._restore())
        if prev != self.position.prev:
            problem = "does not follow the line before it, which was replaced"
            self._refuse(DamagedLogError, problem, self._restore())

    def _restore(self) -> str:
        last = self.position.seq - 1
        if last < 0:
            return "restore the file from a copy"
        return f"restore the file from a copy, or look at what is whole with `replay --to {last}`"

    def _refuse(self, kind: type[LogError], problem: str, advice: str = "") -> NoReturn:
        raise kind(self.path, self.position.seq + 1, problem, advice)


class EventLog:
    """The one writer of a log. What :meth:`append` returns is on the disk.

    ``position`` is the log's end; ``before_last`` what it was before the last
    event, as long as nothing was appended since opening.
    """

    def __init__(self, path: Path, fd: int, lock: WriterLock, position: Position) -> None:
        self.path = path
        self.position = self.before_last = position
        self._fd = fd
        self._lock = lock
        self._failure: StorageError | None = None

    @classmethod
    def create(cls, folder: Path, name: str = LOG_NAME) -> EventLog:
        """An empty log in ``folder``, which exists and holds none."""
        lock = WriterLock(folder)
        try:
            path = folder / name
            fd = open_private(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND)
            with _storage(path):
                sync_folder(folder)
        except BaseException:
            lock.release()
            raise
        return cls(path, fd, lock, Position())

    @classmethod
    def open(
        cls,
        path: Path,
        visit: Callable[[Event], None],
        start: Callable[[], Start | None] = lambda: None,
    ) -> tuple[EventLog, tuple[str, ...]]:
        """An existing log, after ``visit`` has seen its events; a torn last line is cut off.

        The texts say what was repaired. ``start`` is asked where to begin once nobody
        else can write. Raises :class:`SessionInUseError` before anything
        is read, and what :class:`LogReader` and ``visit`` raise.
        """
        found = log_path(path)
        if not found.is_file():
            raise NotASessionError(f"{path}: holds no {LOG_NAME}")
        lock = WriterLock(found.parent)
        try:
            reader = LogReader(path, start())
            for event in reader:
                visit(event)
            fd = open_private(reader.path, os.O_WRONLY | os.O_APPEND)
            log = cls(reader.path, fd, lock, reader.position)
            log.before_last = reader.before_last
            log._repair(reader)
        except BaseException:
            lock.release()
            raise
        return log, reader.warnings

    def append(self, drafts: Sequence[Draft]) -> tuple[Event, ...]:
        """Write the events in one go and wait until the disk has them.

        Raises :class:`StorageError` and :class:`TooLongError`; then none is in the log.
        """
        if self._failure is not None:
            raise self._failure
        position, events, block = self.position, [], b""
        for draft in drafts:
            event = Event(position.seq, draft.type, draft.at, draft.data)
            line = lines.encode(event, position.prev)
            if len(line) > MAX_LINE:
                raise TooLongError(f"this is too long to be kept, at most {MAX_LINE} bytes are")
            position = Position(
                position.seq + 1, sha256(line).hexdigest(), position.size + len(line)
            )
            events.append(event)
            block += line
        self._write(block)
        self.position = position
        return tuple(events)

    def take_back(self, position: Position) -> None:
        """Cut the log back to an earlier end: what followed was never acknowledged."""
        try:
            with _storage(self.path):
                os.ftruncate(self._fd, position.size)
                os.fsync(self._fd)
        except StorageError as error:
            # What is on the disk is not known any more: only reading it again tells.
            self._failure = error
            raise
        self.position = position

    @property
    def closed(self) -> bool:
        """Whether nothing more can be written, because it was closed or the disk failed."""
        return self._fd < 0 or self._failure is not None

    def close(self) -> None:
        """Let go of the file and of the lock. Closing twice is harmless."""
        if self._fd >= 0:
            os.close(self._fd)
            self._fd = -1
        self._lock.release()

    def _write(self, block: bytes) -> None:
        try:
            with _storage(self.path):
                write_all(self._fd, block)
                os.fsync(self._fd)
        except StorageError:
            with suppress(StorageError):
                self.take_back(self.position)
            raise

    def _repair(self, reader: LogReader) -> None:
        if reader.torn:
            self.take_back(reader.position)
        elif reader.unfinished:
            with _storage(self.path):
                write_all(self._fd, b"\n")
                os.fsync(self._fd)


@contextmanager
def _storage(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise StorageError(path, error) from error
