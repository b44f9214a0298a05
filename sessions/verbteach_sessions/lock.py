"""One writer a session: a lock that the operating system lets go of when its holder dies."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path

from verbteach_sessions.errors import SessionInUseError
from verbteach_sessions.files import open_private, write_all

LOCK_NAME = "writer.lock"


class WriterLock:
    """Held from creation to :meth:`release`.

    The file stays when the lock is released: to remove it would let two writers
    lock two files of the same name. What it holds is only for the message.
    """

    def __init__(self, folder: Path) -> None:
        """Take the lock of the session in ``folder``, or raise :class:`SessionInUseError`."""
        path = folder / LOCK_NAME
        self._fd = open_private(path, os.O_RDWR | os.O_CREAT)
        try:
            fcntl.flock(self._fd, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            holder = _holder(self._fd)
            os.close(self._fd)
            raise SessionInUseError(
                f"{folder}: the session is open in another place ({holder});"
                " close it there, or start a new session"
            ) from error
        self._sign()

    def _sign(self) -> None:
        try:
            os.ftruncate(self._fd, 0)
            write_all(self._fd, f"{os.getpid()}\n".encode())
        except OSError:  # a full disk: the lock holds all the same
            pass

    def release(self) -> None:
        """Let the next writer in. Releasing twice is harmless."""
        if self._fd >= 0:
            os.close(self._fd)
            self._fd = -1


def in_use(folder: Path) -> bool:
    """Whether some writer holds the session's lock now."""
    try:
        fd = os.open(folder / LOCK_NAME, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK)
    except OSError:
        return False
    try:
        fcntl.flock(fd, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except OSError:
        return True
    finally:
        os.close(fd)
    return False


def _holder(fd: int) -> str:
    digits = os.pread(fd, 20, 0).strip()
    return f"process {digits.decode()}" if digits.isdigit() else "another process"
