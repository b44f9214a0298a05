"""The register of exports: which session and which person went into which export.

It is kept in the folder of sessions, so that a withdrawal can name the copies
that are elsewhere. Only people are registered: a simulated teacher withdraws nothing.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from verbteach_sessions.corpus.folder import append_lines, read_lines
from verbteach_sessions.names import Now, utc_now

REGISTER_NAME = "exports.jsonl"


@dataclass(frozen=True)
class Entry:
    """An export: when it was made (ISO 8601), its format, where it went, what was in it."""

    at: str
    format: str
    out: str
    sessions: tuple[str, ...]
    participants: tuple[str, ...]


def register(
    folder: Path,
    kind: str,
    out: Path,
    contents: Iterable[tuple[str, str]],
    now: Now = utc_now,
) -> None:
    """Note an export of sessions in ``folder``: pairs of a session's name and a person's code.

    Raises ``StorageError``.
    """
    pairs = sorted(contents)
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
