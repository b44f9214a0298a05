"""Adding to a session what a person says about it afterwards, without holding it again."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from verbteach_sessions import events as kinds
from verbteach_sessions.errors import LogError
from verbteach_sessions.eventlog import Draft, EventLog
from verbteach_sessions.history import History
from verbteach_sessions.lines import Event
from verbteach_sessions.recomputing import EventError, check_fields


def add_questionnaire(
    path: Path, name: str, answers: Mapping[str, int | str | None], seconds: float
) -> None:
    """Write a filled-in questionnaire to the end of the session in ``path``.

    Raises the errors of reading a log, ``SessionInUseError`` and ``StorageError``.
    """
    past = _Past(path)
    log, _ = EventLog.open(path, past.take)
    try:
        data = {"name": name, "answers": dict(answers), "seconds": round(seconds, 1)}
        log.append([Draft(kinds.QUESTIONNAIRE, past.at, data)])
    finally:
        log.close()


class _Past:
    """Follows a log's events, so that nothing is added to one that is out of order."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._history = History()
        self.at = 0.0

    def take(self, event: Event) -> None:
        try:
            check_fields(event)
            self._history.take(event)
        except (EventError, ValueError) as error:
            raise LogError(self._path, event.seq + 1, str(error)) from error
        self.at = event.at
