"""The register of exports: which session and which person went into which export.

It is kept in the folder of sessions, so that a withdrawal can name the copies
that are elsewhere, and what was made of people's answers: a fitted user, a
policy's weights. Only people are registered: a simulated teacher withdraws nothing.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NamedTuple

from verbteach_sessions.corpus.folder import append_lines, corpus_of, read_lines
from verbteach_sessions.header import SIMULATED
from verbteach_sessions.names import Now, utc_now

REGISTER_NAME = "exports.jsonl"


class Contribution(NamedTuple):
    """A session that went into an export: where it is, who taught in it, and what kind of teacher.

    ``participant`` is the person's code; without one nobody can withdraw it.
    """

    session: Path
    participant: str | None
    teacher: str


@dataclass(frozen=True)
class Entry:
    """An export: when it was made (ISO 8601), its format, where it went, what was in it."""

    at: str
    format: str
    out: str
    sessions: tuple[str, ...]
    participants: tuple[str, ...]


def register(
    kind: str, out: Path, contributions: Iterable[Contribution], now: Now = utc_now
) -> None:
    """Note an export in each folder that people's sessions in it come from.

    Raises ``StorageError``.
    """
    people: dict[Path, list[tuple[str, str]]] = {}
    for session, participant, teacher in contributions:
        if participant is not None and teacher != SIMULATED:
            people.setdefault(corpus_of(session), []).append((session.name, participant))
    for folder in sorted(people):
        _note(folder, kind, out, sorted(people[folder]), now)


def _note(folder: Path, kind: str, out: Path, pairs: list[tuple[str, str]], now: Now) -> None:
    entry = Entry(
        at=now().isoformat(timespec="seconds"),
        format=kind,
        out=str(out.absolute()),
        sessions=tuple(session for session, _ in pairs),
        participants=tuple(sorted({code for _, code in pairs})),
    )
    append_lines(folder / REGISTER_NAME, [asdict(entry)])


def exports_of(folder: Path, participant: str) -> tuple[Entry, ...]:
    """The exports that a person's sessions were in, in the order they were made."""
    entries = (_entry(line) for line in read_lines(folder / REGISTER_NAME))
    return tuple(entry for entry in entries if participant in entry.participants)


def _entry(line: dict[str, Any]) -> Entry:
    return Entry(
        at=str(line.get("at", "")),
        format=str(line.get("format", "")),
        out=str(line.get("out", "")),
        sessions=_texts(line.get("sessions")),
        participants=_texts(line.get("participants")),
    )


def _texts(value: Any) -> tuple[str, ...]:
    return tuple(map(str, value)) if isinstance(value, list) else ()
