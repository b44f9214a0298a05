"""Is a record sound? Every rule by name, and where and why it was broken; nothing is written."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from verbteach.dialogue.setting import Settings, UnknownSceneError
from verbteach.language.agreement import NoSecondReaderError
from verbteach_sessions.checks import CHECKS
from verbteach_sessions.corpus.personal import Scanner
from verbteach_sessions.errors import DamagedLogError, LogError, NotASessionError, SessionError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.events import EVENT_TYPES, FITTING, HEADER
from verbteach_sessions.header import Header
from verbteach_sessions.header_file import header_fits
from verbteach_sessions.history import History, OrderError
from verbteach_sessions.lines import Event
from verbteach_sessions.replay import verify
from verbteach_sessions.shapes import wrong_fields
from verbteach_sessions.typed import typed

RULES: Mapping[str, str] = {
    "file": "The file is there, is a log of a version that can be read, and its lines are JSON.",
    "hash": "No line was changed, lost or replaced after it was written.",
    "schema": "Every event is of a known type and has its fields, each of its kind, not too deep.",
    "header": "The header names a method that can be built, and names that are safe.",
    "order": "Every event follows on those before it.",
    **{name: check.__doc__ or "" for name, check in CHECKS.items()},
    "replay": "Recomputing every reply gives what was recorded. Asked only if all else is sound.",
}
CAUTIONS: Mapping[str, str] = {
    "torn": "The last line was written to its end.",
    "header-file": "`header.json` is there and says what the log says.",
    "personal": "Nothing that a person typed looks like personal data. The scan can be wrong.",
}
"""Rules that a sound record may break: that is told as a warning."""


@dataclass(frozen=True)
class Finding:
    """A rule that was broken: at which event (``None``: the whole record), and how."""

    rule: str
    seq: int | None
    message: str


@dataclass(frozen=True)
class Validation:
    """What was found. ``warnings`` do no harm: a record with none but these is valid."""

    problems: tuple[Finding, ...] = ()
    warnings: tuple[Finding, ...] = ()

    @property
    def valid(self) -> bool:
        """Whether no rule was broken."""
        return not self.problems

    def to_json(self) -> dict[str, Any]:
        """What ``sessions validate --json`` prints of one session."""
        return {
            "valid": self.valid,
            "problems": [asdict(one) for one in self.problems],
            "warnings": [asdict(one) for one in self.warnings],
        }


def validate(
    path: Path, settings: Settings, heard: Callable[[int], None] | None = None
) -> Validation:
    """Hold a session against every rule. What is wrong with the record is never an exception.

    ``heard`` is told how many events have been recomputed, whenever one has.
    """
    reader = LogReader(path, strict=True)
    walk = _Walk(reader)
    problems = tuple(walk.problems())
    if not problems:
        problems = tuple(_replayed(path, settings, heard))
    return Validation(problems, tuple(walk.warnings()))


class _Walk:
    """One pass over a record with a history that grows along."""

    def __init__(self, reader: LogReader) -> None:
        self._reader = reader
        self._history = History()
        self._scanner = Scanner()
        self._told: set[str] = set()
        self._personal: list[Finding] = []

    def problems(self) -> Iterator[Finding]:
        try:
            for event in self._reader:
                wrong = [*self._wrong(event)]
                yield from wrong
                if any(one.rule in _BASIC for one in wrong):
                    return  # what follows cannot be told from what followed from this
        except DamagedLogError as error:
            yield Finding("hash", error.line - 1, f"line {error.line} {error.problem}")
        except LogError as error:
            yield Finding("file", error.line - 1, f"line {error.line} {error.problem}")
        except NotASessionError as error:
            yield Finding("file", None, str(error))

    def warnings(self) -> Iterator[Finding]:
        yield from self._personal
        for text in self._reader.warnings:
            yield Finding("torn", self._reader.position.seq, text)
        header = self._history.header
        if header is not None and not header_fits(self._reader.path.parent, header):
            yield Finding(
                "header-file", 0, "header.json is missing or does not say what the log says"
            )

    def _wrong(self, event: Event) -> Iterator[Finding]:
        shape = EVENT_TYPES.get(event.type)
        if shape is None:
            yield Finding("schema", event.seq, f"there is no event type {event.type!r}")
            return
        if not FITTING[event.type](event.data):
            for problem in wrong_fields(shape, event.data):
                yield Finding("schema", event.seq, f"{event.type}{problem}")
            return
        yield from self._wrong_here(event)

    def _wrong_here(self, event: Event) -> Iterator[Finding]:
        if event.type == HEADER and (problem := _wrong_header(event)):
            yield Finding("header", event.seq, problem)
            return
        self._scan(event)
        found = [
            Finding(rule, event.seq, problem)
            for rule, check in CHECKS.items()
            for problem in check(event, self._history)
        ]
        try:
            self._history.take(event)
        except OrderError as error:  # what the others say of such an event means nothing
            found = [Finding("order", event.seq, str(error))]
        yield from found

    def _scan(self, event: Event) -> None:
        """Note what looks personal, each text once; what it is is not said again."""
        hits = (hit for text in typed(event) for hit in self._scanner.hits(text))
        for hit in hits:
            if hit.text not in self._told:
                self._told.add(hit.text)
                message = f"what was typed looks like personal data ({hit.kind})"
                self._personal.append(Finding("personal", event.seq, message))


_BASIC = frozenset({"schema", "header", "order"})


def _wrong_header(event: Event) -> str:
    try:
        Header.from_json(event.data)
    except (ValueError, SessionError) as error:
        return str(error)
    return ""


def _replayed(
    path: Path, settings: Settings, heard: Callable[[int], None] | None
) -> Iterator[Finding]:
    try:
        difference = verify(path, settings, heard=heard).first_difference
    except (SessionError, UnknownSceneError, NoSecondReaderError) as error:
        yield Finding("replay", None, str(error))
        return
    if difference is not None:
        yield Finding(
            "replay",
            difference.seq,
            f"{difference.field} was recorded as {difference.recorded!r},"
            f" recomputing gives {difference.recomputed!r}"[:400],
        )
