"""A private file of lines that only this person's own program can have written.

Each line is sealed with a key that never leaves the person's data folder, and
with the seal before it. Lines that do not fit end the file: what another put
there, or a crash left half-written, is as if it were not there.
"""

from __future__ import annotations

import hmac
import os
from collections.abc import Iterator, Sequence
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

from verbteach_sessions.errors import NotASessionError, StorageError
from verbteach_sessions.files import FOLDER_MODE, open_private, open_regular, write_all
from verbteach_sessions.places import data_folder

KEY_NAME = "seal.key"
_KEY_LENGTH = 32
_SEAL = 64


class SealedLine(NamedTuple):
    """A line's kind and what it says, without the newline."""

    kind: str
    text: bytes


def own_key() -> bytes | None:
    """This person's key, made on first need; ``None`` where it can be neither read nor kept."""
    path = data_folder() / KEY_NAME
    key = _read_key(path)
    if key is None:
        with suppress(StorageError, OSError):
            _make_key(path)
        key = _read_key(path)
    return key


def _read_key(path: Path) -> bytes | None:
    try:
        with open_regular(path) as file:
            key = file.read(_KEY_LENGTH + 1)
    except NotASessionError:
        return None
    return key if len(key) == _KEY_LENGTH else None


def _make_key(path: Path) -> None:
    """Whoever comes first makes it, and as a whole: a link never overwrites."""
    path.parent.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    fd = open_private(draft, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    try:
        write_all(fd, os.urandom(_KEY_LENGTH))
        os.fsync(fd)
        with suppress(FileExistsError):
            os.link(draft, path)
    finally:
        os.close(fd)
        draft.unlink()


class SealedFile:
    """Reads the lines that are sealed, and then appends.

    A failure to write is no error to anyone: the file is then left as it is.
    """

    def __init__(self, path: Path, key: bytes, limit: int) -> None:
        """``limit`` is the most bytes to read: a longer file counts as empty."""
        self.path = path
        self._key = key
        self._limit = limit
        self._seal = b""
        self._size = 0

    def read(self) -> tuple[SealedLine, ...]:
        """The lines up to the first that does not fit."""
        return tuple(self._lines())

    def begin_anew(self) -> None:
        """Forget what the file holds; the next line is its first."""
        self._seal, self._size = b"", 0

    def append(self, lines: Sequence[SealedLine]) -> bool:
        """Write lines after those that fit; whether that could be done."""
        block, seal = b"", self._seal
        for kind, text in lines:
            body = kind.encode() + b" " + text
            seal = self._sealed(seal, body)
            block += seal + b" " + body + b"\n"
        try:
            self._write(block)
        except (OSError, StorageError):
            return False
        self._seal, self._size = seal, self._size + len(block)
        return True

    def _write(self, block: bytes) -> None:
        fd = open_private(self.path, os.O_WRONLY | os.O_CREAT)
        try:
            os.ftruncate(fd, self._size)
            os.lseek(fd, self._size, os.SEEK_SET)
            write_all(fd, block)
        finally:
            os.close(fd)

    def _lines(self) -> Iterator[SealedLine]:
        for raw in self._raw().splitlines(keepends=True):
            seal, body = raw[:_SEAL], raw[_SEAL + 1 : -1]
            if not raw.endswith(b"\n") or not hmac.compare_digest(
                seal, self._sealed(self._seal, body)
            ):
                return
            self._seal, self._size = seal, self._size + len(raw)
            kind, _, text = body.partition(b" ")
            yield SealedLine(kind.decode(), text)

    def _raw(self) -> bytes:
        try:
            with open_regular(self.path) as file:
                raw = file.read(self._limit + 1)
        except NotASessionError:
            return b""
        return b"" if len(raw) > self._limit else raw

    def _sealed(self, before: bytes, body: bytes) -> bytes:
        mac = hmac.new(self._key, before, sha256)
        mac.update(body)
        return mac.hexdigest().encode()
