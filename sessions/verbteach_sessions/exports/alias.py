"""What must not be in an export: the time of day, and text that no file can hold.

A session's own name begins with when it began, so an export calls it by an alias.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from hashlib import sha256
from typing import Any

LARGEST = 2**63  # what a 64-bit column can no longer hold

_DATED = re.compile(r"\d{8}-\d{6}-([a-z0-9]{8,})")
_MOMENT = re.compile(r"\d{4}-\d{2}-\d{2}([T ]\d{2}:\d{2}.*)?")


def alias(session: str) -> str:
    """The random part of a session's name, or a digest of a name of another make."""
    dated = _DATED.fullmatch(session)
    return dated[1] if dated else f"x{sha256(session.encode()).hexdigest()[:12]}"


def timeless(value: Any) -> Any:
    """A JSON value without the members that are a date or a moment."""
    if isinstance(value, Mapping):
        kept = ((key, item) for key, item in value.items() if not _is_moment(item))
        return {key: timeless(item) for key, item in kept}
    if isinstance(value, list | tuple):
        return [timeless(item) for item in value if not _is_moment(item)]
    return value


def encodable(value: Any) -> Any:
    """A JSON value with a sign in place of half a surrogate pair, which UTF-8 cannot hold.

    Raises ``ValueError`` on a number that no column can hold.
    """
    if type(value) is int and abs(value) >= LARGEST:
        raise ValueError("holds a number that is too large to export")
    if isinstance(value, str):
        return value if value.isascii() else value.encode("utf-8", "replace").decode("utf-8")
    if isinstance(value, Mapping):
        return {encodable(key): encodable(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [encodable(item) for item in value]
    return value


def _is_moment(value: Any) -> bool:
    return isinstance(value, str) and _MOMENT.fullmatch(value) is not None
