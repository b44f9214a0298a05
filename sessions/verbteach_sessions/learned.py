"""What a session taught, read from its record alone: for sessions that go on from it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from verbteach.verbs.knowledge import VerbKnowledge
from verbteach_sessions.content import ContentHash
from verbteach_sessions.errors import LogError, NotASessionError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.header import Source
from verbteach_sessions.history import History
from verbteach_sessions.lines import Event
from verbteach_sessions.method import knowledge_of
from verbteach_sessions.names import safe_name
from verbteach_sessions.recomputing import EventError, check_fields

Experience = Mapping[tuple[str, str], int]


def source_from(path: Path) -> Source:
    """What ``path`` (a session's folder or log) taught, to begin another session with.

    Nothing is recomputed. Raises the errors of reading a log.
    """
    reader = LogReader(path)
    history, content = History(), ContentHash()
    for event in reader:
        _take(reader, history, content, event)
    header = history.header
    if header is None or history.current is None:
        raise NotASessionError(f"{reader.path}: nothing was said in this session")
    records = (*header.data["learned_before"], *history.records())
    try:
        knowledge_of(records)
    except ValueError as error:
        raise LogError(reader.path, 0, f"what was learned cannot be read, {error}") from error
    return Source(safe_name(header.data["id"]), content.hexdigest, records)


def knowledge_from(path: Path) -> tuple[VerbKnowledge, Experience]:
    """What a session's robot knew in the end: its verbs, and what phrases meant how often."""
    return knowledge_of(source_from(path).records)


def _take(reader: LogReader, history: History, content: ContentHash, event: Event) -> None:
    try:
        check_fields(event)
        history.take(event)
        content.add(event)
    except (EventError, ValueError) as error:
        raise LogError(reader.path, event.seq + 1, str(error)) from error
