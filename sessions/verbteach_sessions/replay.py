"""Playing a record back: to look at it, and to check that recomputing it gives the same."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState
from verbteach_sessions.errors import DamagedLogError, LogError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.header import Header, versions
from verbteach_sessions.lines import Event
from verbteach_sessions.recomputing import Difference, EventError, Recomputing


@dataclass(frozen=True)
class Verification:
    """What recomputing a whole record gave.

    ``unanswerable`` counts the turns for which the record holds no answer:
    none, as long as nothing but the record is replayed.
    """

    verified: bool
    events: int
    first_difference: Difference | None
    content_hash: str
    unanswerable: int = 0
    warnings: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """What ``replay --verify --json`` prints."""
        difference = self.first_difference
        return {
            "verified": self.verified,
            "events": self.events,
            "first_difference": None if difference is None else difference.to_json(),
            "unanswerable": self.unanswerable,
            "content_hash": self.content_hash,
            "warnings": list(self.warnings),
        }


class Frame(NamedTuple):
    """An event, and the robot's state after it; ``None`` where it could not be recomputed."""

    event: Event
    state: RobotState | None


def verify(
    path: Path,
    settings: Settings,
    to: int | None = None,
    heard: Callable[[int], None] | None = None,
) -> Verification:
    """Recompute every event of a session, up to number ``to`` with it, and compare.

    ``heard`` is told how many events are done, whenever one is. A line that was
    changed, lost or replaced is a difference; a torn last line is a warning.
    Raises ``NewerLogError``, ``NotASessionError``, ``LogError`` on a file that
    is no log, ``UnknownSceneError`` and ``NoSecondReaderError``.
    """
    reader = LogReader(path)
    past = Recomputing(settings, brief=True)
    difference: Difference | None = None
    events = 0
    try:
        for event in reader:
            if to is not None and event.seq > to:
                break
            events += 1
            _take(reader, past, event)
            if heard is not None:
                heard(events)
    except DamagedLogError as error:
        difference = past.difference or _damage(reader, error)
    difference = difference or past.difference
    return Verification(
        verified=difference is None,
        events=events,
        first_difference=difference,
        content_hash=past.fold.content.hexdigest,
        warnings=(*reader.warnings, *_pins(past)),
    )


def replay(path: Path, settings: Settings, to: int | None = None) -> Iterator[Frame]:
    """The events of a session, up to number ``to`` with it, each with the state it led to.

    What was recorded is shown whatever recomputing gives. Raises as
    :func:`verify` does, and ``DamagedLogError`` on reaching the damage.
    """
    reader = LogReader(path)
    past = Recomputing(settings, brief=True)
    for event in reader:
        _take(reader, past, event)
        yield Frame(event, None if past.diverged else past.fold.state)
        if event.seq == to:
            return


def fold_of(reader: LogReader, settings: Settings, heard: Callable[[int], None]) -> Recomputing:
    """A whole record recomputed, with the state after each turn. Raises as :func:`replay` does."""
    past = Recomputing(settings)
    for event in reader:
        _take(reader, past, event)
        heard(event.seq + 1)
    return past


def _take(reader: LogReader, past: Recomputing, event: Event) -> None:
    try:
        past.take(event)
    except EventError as error:
        raise LogError(reader.path, event.seq + 1, str(error)) from error


def _damage(reader: LogReader, error: DamagedLogError) -> Difference:
    return Difference(reader.position.seq, "line", f"line {error.line} {error.problem}", None)


def _pins(past: Recomputing) -> tuple[str, ...]:
    header = past.fold.history.header
    if header is None:
        return ()
    recorded, now = Header.from_json(header.data), versions()
    made = recorded.machine.software
    return tuple(
        f"recorded with {name} {made.get(name, 'not installed')},"
        f" recomputed with {now.get(name, 'none')}"
        for name in recorded.changed_software(now)
    )
