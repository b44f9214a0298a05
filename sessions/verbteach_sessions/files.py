"""Private files: made readable to their owner only, read without trusting what they are."""

from __future__ import annotations

import errno
import os
import stat
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from verbteach_sessions.errors import NotASessionError, StorageError

FOLDER_MODE = 0o700
FILE_MODE = 0o600


def open_regular(path: Path) -> BinaryIO:
    """Open for reading. A link, a pipe or a device in a file's place is refused, not waited for.

    Raises :class:`NotASessionError` where there is no such file or it is not a plain one.
    """
    try:
        fd = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_NOFOLLOW | os.O_CLOEXEC)
    except OSError as error:
        why = "it is a link" if error.errno == errno.ELOOP else error.strerror
        raise NotASessionError(f"{path}: cannot be read, {why}") from error
    if not stat.S_ISREG(os.fstat(fd).st_mode):
        os.close(fd)
        raise NotASessionError(f"{path}: is not a plain file")
    return os.fdopen(fd, "rb")


def open_private(path: Path, flags: int) -> int:
    """A file descriptor for writing; links are not followed. Raises :class:`StorageError`."""
    try:
        return os.open(path, flags | os.O_NOFOLLOW | os.O_CLOEXEC, FILE_MODE)
    except OSError as error:
        raise StorageError(path, error) from error


def make_private_folder(path: Path) -> None:
    """Make the folder ``path``, which must not exist, and whatever it stands in."""
    try:
        path.parent.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
        path.mkdir(mode=FOLDER_MODE)
    except OSError as error:
        raise StorageError(path, error) from error


def write_all(fd: int, data: bytes) -> None:
    """Write all of ``data``; a short write is continued."""
    view = memoryview(data)
    while view:
        view = view[os.write(fd, view) :]


def replace_file(path: Path, data: bytes) -> None:
    """Put ``data`` at ``path`` so that a reader sees the old bytes or the new, never a mixture."""
    draft = path.with_name(f".{path.name}.{os.getpid()}.new")
    fd = open_private(draft, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    try:
        write_all(fd, data)
        os.fsync(fd)
        draft.replace(path)
        sync_folder(path.parent)
    except OSError as error:
        with suppress(OSError):
            draft.unlink()
        raise StorageError(path, error) from error
    finally:
        os.close(fd)


def sync_folder(path: Path) -> None:
    """Make the names in a folder survive a crash of the machine."""
    fd = os.open(path, os.O_RDONLY | os.O_CLOEXEC)
    try:
        os.fsync(fd)
    finally:
        os.close(fd)
