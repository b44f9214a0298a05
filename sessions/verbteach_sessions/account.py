"""A record read event by event and nothing recomputed: what was said, and the hash of that."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from verbteach_sessions.content import ContentHash
from verbteach_sessions.errors import LogError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.history import History
from verbteach_sessions.lines import Event
from verbteach_sessions.recomputing import check_fields


class Account:
    """A session's ``history`` and ``content``, as far as its events were taken in."""

    def __init__(self, path: Path) -> None:
        """Of a session's folder or log; nothing is read yet."""
        self.reader = LogReader(path)
        self.history = History()
        self.content = ContentHash()

    def __iter__(self) -> Iterator[Event]:
        """Take in every event that is left, and hand each over. Raises the errors of reading."""
        for event in self.reader:
            self.take(event)
            yield event

    def take(self, event: Event) -> None:
        """Take in one event that the reader gave. Raises ``LogError`` where it does not follow."""
        with self.at(event):
            check_fields(event)
            self.history.take(event)
            self.content.add(event)

    @contextmanager
    def at(self, event: Event) -> Iterator[None]:
        """What is wrong with the event in this block is a ``LogError`` with its line."""
        try:
            yield
        except ValueError as error:
            raise LogError(self.reader.path, event.seq + 1, str(error)) from error
