"""Following a log's chain of hashes over bytes alone: quick, for a list or for a known start.

Nothing of a line is parsed but its last two members, so it takes a small part
of the time that reading takes. It finds that something is amiss, not what.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from hashlib import sha256
from typing import BinaryIO, NamedTuple

from verbteach_sessions.lines import GENESIS, MAX_LINE

_TAIL = len(b',"prev":"') + 64 + len(b'","hash":"') + 64 + len(b'"}\n')
_HASH = len(b',"hash":"') + 64 + len(b'"}\n')
_PREV = slice(len(b',"prev":"'), len(b',"prev":"') + 64)


class Position(NamedTuple):
    """The end of a log: the next event's number, the last line's hash, the length in bytes."""

    seq: int = 0
    prev: str = GENESIS
    size: int = 0


class BrokenChainError(ValueError):
    """The lines up to a position are not those that were there."""


class Followed(NamedTuple):
    """The first and the last of the lines, and where each of them begins, in bytes."""

    first: bytes
    last: bytes
    begins: Sequence[int]


def follow(file: BinaryIO, end: Position) -> Followed:
    """Read the lines before ``end``. Raises :class:`BrokenChainError` if they end otherwise."""
    begins, at, prev = array("q"), 0, GENESIS.encode()
    first = raw = b""
    while len(begins) < end.seq:
        raw = file.readline(MAX_LINE + 1)
        if len(raw) < _TAIL or raw[-_TAIL:][_PREV] != prev:
            raise BrokenChainError(f"line {len(begins) + 1} does not follow the line before it")
        first = first or raw
        begins.append(at)
        at += len(raw)
        prev = sha256(raw).hexdigest().encode()
    if Position(len(begins), prev.decode(), at) != end:
        raise BrokenChainError(f"line {len(begins)} is not the one that was there")
    return Followed(first, raw, begins)


def hangs_together(file: BinaryIO) -> bool:
    """Whether each line follows on the one before, and the last one is what was written.

    A last line that was not written to its end says nothing.
    """
    prev, last = GENESIS.encode(), b""
    while (raw := file.readline(MAX_LINE + 1)).endswith(b"\n"):
        if raw[-_TAIL:][_PREV] != prev:
            return False
        prev, last = sha256(raw).hexdigest().encode(), raw
    body, sealed = last[:-_HASH] + b"}", last[-_HASH:]
    return sealed == b',"hash":"%s"}\n' % sha256(body).hexdigest().encode()
