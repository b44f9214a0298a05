"""An event as one line of bytes, and back.

A line is a JSON object whose last two members are ``prev``, the SHA-256 of the
whole line before it, and ``hash``, that of the line itself without this member.
So a changed line is found, the last one included. What a line says is not
looked at here, only that it is whole.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from typing import Any, NoReturn

from verbteach_sessions.upcasting import STEPS, VERSION, upcast

MAX_LINE = 4 * 1024 * 1024
GENESIS = "0" * 64
_LATEST = 2.0**53  # seconds; beyond, a float no longer counts them
_HASH_MEMBER = len(b',"hash":""}') + 64


@dataclass(frozen=True)
class Event:
    """One thing that happened: ``seq`` counts from 0, ``at`` is in seconds of session time."""

    seq: int
    type: str
    at: float
    data: Mapping[str, Any]


class LineError(ValueError):
    """The bytes are no whole line of a log; the message says why."""


class ChangedLineError(LineError):
    """The line is not what was written."""


class AmbiguousLineError(LineError):
    """An object of the line has two members of one name."""


class NewerVersionError(LineError):
    """The line is of a later version of the format."""


def canonical(value: Any) -> bytes:
    """JSON with sorted keys and no spaces, in ASCII; NaN and infinities raise ``ValueError``."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), allow_nan=False).encode()


def digest(data: bytes) -> str:
    """SHA-256 in hexadecimal."""
    return sha256(data).hexdigest()


def encode(event: Event, prev: str) -> bytes:
    """The line of ``event`` after a line with the hash ``prev``, its newline included."""
    head = {"v": VERSION, "seq": event.seq, "type": event.type, "at": event.at}
    body = json.dumps(
        {**head, "data": event.data, "prev": prev}, separators=(",", ":"), allow_nan=False
    ).encode()
    return body[:-1] + f',"hash":"{digest(body)}"}}\n'.encode()


def decode(raw: bytes, *, strict: bool = False) -> tuple[Event, str]:
    """The event of a line without its newline, and the hash it gives the line before.

    ``strict`` refuses objects with two members of one name as well, of which
    otherwise the last one counts. Raises :class:`AmbiguousLineError`,
    :class:`NewerVersionError`, :class:`ChangedLineError`, else :class:`LineError`.
    """
    value = parse(raw, _STRICT if strict else _DECODER)
    if not isinstance(value, dict):
        raise LineError("is not a JSON object")
    version = value.get("v")
    if isinstance(version, int) and version > VERSION:
        raise NewerVersionError(f"is of version {version}; this program reads up to {VERSION}")
    if raw[-_HASH_MEMBER:] != f',"hash":"{digest(_body(raw))}"}}'.encode():
        raise ChangedLineError("was changed after it was written: its hash does not fit")
    return _event(value), _member(value, "prev", str)


def parse(raw: bytes, decoder: json.JSONDecoder | None = None) -> Any:
    """The JSON value of hostile bytes, or :class:`LineError`."""
    try:
        return (decoder or _DECODER).decode(raw.decode())
    except AmbiguousLineError:
        raise
    except RecursionError as error:
        raise LineError("is nested too deeply") from error
    except ValueError as error:  # UnicodeDecodeError and integers of thousands of digits as well
        raise LineError(f"is not JSON ({error})") from error


def _no_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is no number of JSON")


def _finite(text: str) -> float:
    number = float(text)
    if not math.isfinite(number):
        raise ValueError(f"{text} is too large a number")
    return number


def _unique(members: list[tuple[str, Any]]) -> dict[str, Any]:
    value = dict(members)
    if len(value) < len(members):
        names = [name for name, _ in members]
        twice = next(name for name in names if names.count(name) > 1)
        raise AmbiguousLineError(f"has a member {twice[:40]!r} twice")
    return value


_DECODER = json.JSONDecoder(parse_constant=_no_constant, parse_float=_finite)
_STRICT = json.JSONDecoder(
    parse_constant=_no_constant, parse_float=_finite, object_pairs_hook=_unique
)


def _body(raw: bytes) -> bytes:
    return raw[:-_HASH_MEMBER] + b"}"


def _event(value: Mapping[str, Any]) -> Event:
    version = value.get("v")
    if type(version) is not int or (version != VERSION and version not in STEPS):
        raise LineError(f"has the version {version!r}, which never was"[:200])
    at = value.get("at")
    if isinstance(at, bool) or not isinstance(at, int | float) or abs(at) > _LATEST:
        raise LineError("'at' is no number of seconds")
    kind, data = _member(value, "type", str), _member(value, "data", dict)
    return Event(_member(value, "seq", int), kind, float(at), upcast(version, kind, data))


def _member(value: Mapping[str, Any], name: str, kind: type[Any]) -> Any:
    member = value.get(name)
    if not isinstance(member, kind) or isinstance(member, bool):
        raise LineError(f"'{name}' is missing or of the wrong type")
    return member
