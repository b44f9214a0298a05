"""Reading a record's lines in tests, and forging records whose chain of hashes holds."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Any

from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.lines import GENESIS, Event, encode


def raw_lines(session: Path) -> list[bytes]:
    """The log's lines as they stand, with their newlines."""
    return (session / LOG_NAME).read_bytes().splitlines(keepends=True)


def read_events(session: Path) -> list[dict[str, Any]]:
    """The log's events as plain JSON."""
    return [json.loads(line) for line in raw_lines(session)]


def write_events(session: Path, events: Sequence[dict[str, Any]]) -> None:
    """Write a log of these events, with numbers and hashes that hold."""
    prev, lines = GENESIS, []
    for seq, event in enumerate(events):
        line = encode(Event(seq, event["type"], event["at"], event["data"]), prev)
        prev = sha256(line).hexdigest()
        lines.append(line)
    (session / LOG_NAME).write_bytes(b"".join(lines))


def forge(session: Path, change: Callable[[list[dict[str, Any]]], object]) -> None:
    """Change the events of a record and make its hashes hold again."""
    events = read_events(session)
    change(events)
    write_events(session, events)


def first(events: Sequence[dict[str, Any]], kind: str, number: int = 0) -> dict[str, Any]:
    """The event of a type, the first or that ``number``."""
    return [event for event in events if event["type"] == kind][number]
