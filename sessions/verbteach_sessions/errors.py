"""What can go wrong with a session: the person's input, the file, or the disk; never a bug."""

from __future__ import annotations

import errno
from collections.abc import Mapping
from pathlib import Path
from typing import ClassVar


class SessionError(Exception):
    """Something about a session that the person can put right; the message is one line."""


class NoHomeError(SessionError):
    """Nobody said where things are kept, and there is no home directory to keep them in."""


class LogError(SessionError):
    """The log cannot be used as it is: which file, which line (from 1), why, and what to do."""

    def __init__(self, path: Path, line: int, problem: str, advice: str = "") -> None:
        self.path, self.line, self.problem, self.advice = path, line, problem, advice
        place = f"{path}, line {line}" if line else str(path)
        super().__init__(f"{place}: {problem}" + (f"; {advice}" if advice else ""))


class DamagedLogError(LogError):
    """A line was changed, lost or put in another's place after it was written."""


class NewerLogError(LogError):
    """The log was written by a version of this program that knows more than this one."""


class SessionInUseError(SessionError):
    """Another process (or another part of this one) writes to the session."""


class StorageError(SessionError):
    """The disk did not take what should be kept; nothing of it counts as kept."""

    REASONS: ClassVar[Mapping[int, str]] = {
        errno.ENOSPC: "the disk is full",
        errno.EDQUOT: "the disk quota is used up",
        errno.EFBIG: "the file may not grow further",
        errno.EROFS: "the disk is read-only",
        errno.EACCES: "permission to write is missing",
        errno.EPERM: "permission to write is missing",
        errno.ENOENT: "the folder is not there",
        errno.ENOTDIR: "a part of the path is no folder",
    }

    def __init__(self, path: Path, error: OSError) -> None:
        self.path = path
        known = self.REASONS.get(error.errno or 0)
        self.reason = known or error.strerror or type(error).__name__
        super().__init__(f"{path}: cannot be written, {self.reason}")


class TooLongError(SessionError):
    """What was said, or the reply to it, is too long for a line of the record."""


class NotASessionError(SessionError):
    """The path holds no session."""


class SessionEndedError(SessionError):
    """The session is closed; it can be resumed."""


class CannotUndoError(SessionError):
    """There is nothing to take back, or nothing to do again."""


class UnsafeNameError(SessionError):
    """A session's name or a participant's code that is no plain file name."""


class ScriptError(SessionError):
    """A line of a teacher's script that cannot be said; ``line`` counts from 1."""

    def __init__(self, line: int, reason: str) -> None:
        self.line, self.reason = line, reason
        super().__init__(f"script, line {line}: {reason}")
