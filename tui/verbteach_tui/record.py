"""A record read without recomputing it: what it began with, what holds, what came of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from verbteach_sessions.content import ContentHash
from verbteach_sessions.errors import LogError, NotASessionError
from verbteach_sessions.eventlog import LogReader, log_path
from verbteach_sessions.files import open_regular
from verbteach_sessions.header import Header
from verbteach_sessions.history import History
from verbteach_sessions.lines import Event
from verbteach_sessions.recomputing import EventError, check_fields
from verbteach_sessions.transcript import Line, transcript

_BEGUN = ("created", "interface", "teacher", "participant", "scene", "seed")


@dataclass(frozen=True)
class Record:
    """``facts`` are JSON-ready, in the order to show; ``lines`` what was said and holds."""

    facts: Mapping[str, Any]
    lines: tuple[Line, ...]
    warnings: tuple[str, ...]

    def to_json(self) -> dict[str, Any]:
        """What ``sessions show --json`` prints."""
        lines = [line._asdict() for line in self.lines]
        return {**self.facts, "transcript": lines, "warnings": list(self.warnings)}


def read_record(path: Path) -> Record:
    """Read the session at ``path``. Raises the errors of reading a log."""
    reader = LogReader(path)
    history, content = History(), ContentHash()
    for event in reader:
        _take(reader, history, content, event)
    if history.header is None or history.current is None:
        raise NotASessionError(f"{reader.path}: nothing was said in this session")
    header = Header.from_json(history.header.data)
    after = history.current.after
    facts = {
        "id": header.id,
        "session": str(reader.path.parent),
        **{name: history.header.data[name] for name in _BEGUN},
        "policy": header.method.policy.name,
        "goes_on_from": header.source.id if header.source else None,
        "events": reader.position.seq,
        "ended": history.ended,
        **after["totals"],
        "verbs_learned": after["verbs_learned"],
        "content_hash": content.hexdigest,
    }
    lines = transcript(history, header.method.parameters.rewards)
    return Record(facts, lines, reader.warnings)


def _take(reader: LogReader, history: History, content: ContentHash, event: Event) -> None:
    try:
        check_fields(event)
        history.take(event)
        content.add(event)
    except (EventError, ValueError) as error:
        raise LogError(reader.path, event.seq + 1, str(error)) from error


def count_events(path: Path) -> int:
    """How many lines the record at ``path`` has; 0 where it cannot be read."""
    try:
        with open_regular(log_path(path)) as log:
            return sum(1 for _ in log)
    except NotASessionError:
        return 0
