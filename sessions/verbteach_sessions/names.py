"""Names of sessions and codes of participants: plain file names that cannot leave their folder."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from datetime import UTC, datetime

from verbteach_sessions.errors import UnsafeNameError

Random = Callable[[int], bytes]
Now = Callable[[], datetime]

_LETTERS = "abcdefghjkmnpqrstuvwxyz23456789"
_SAFE = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")


def utc_now() -> datetime:
    """The time, in UTC."""
    return datetime.now(UTC)


def safe_name(name: str, what: str = "session name") -> str:
    """The name, if it is one that cannot leave its folder; else :class:`UnsafeNameError`."""
    if not _SAFE.fullmatch(name):
        raise UnsafeNameError(
            f"{name[:80]!r} is no {what}: use up to 64 letters, digits, '-' and '_'"
        )
    return name


def new_id(now: Now = utc_now, random: Random = os.urandom) -> str:
    """A session's name: when it began, and eight letters drawn at random."""
    return f"{now():%Y%m%d-%H%M%S}-{_drawn(8, random)}"


def new_code(random: Random = os.urandom) -> str:
    """A participant's code, ten random letters: it says nothing about the person."""
    return _drawn(10, random)


def _drawn(count: int, random: Random) -> str:
    return "".join(_LETTERS[byte % len(_LETTERS)] for byte in random(count))
