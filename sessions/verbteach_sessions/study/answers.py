"""A table of a study: a row for each session, with its condition, its course, the answers.

Nothing in it says when; the participant's code joins it to the records.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from verbteach_sessions import events as kinds
from verbteach_sessions.errors import SessionError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.history import History, OrderError
from verbteach_sessions.study.enrolment import visits

Row = dict[str, Any]

FIRST = (
    *("participant", "study", "slot", "condition", "part", "step", "why", "session"),
    *("policy", "noise", "noise_reading", "panels", "seconds"),
)


def answer_rows(folder: Path) -> tuple[list[Row], tuple[str, ...]]:
    """The rows of all sessions in a study's folder, and what could not be read and why."""
    rows: list[Row] = []
    problems: list[str] = []
    for home, found in visits(folder):
        if isinstance(found, SessionError):
            problems.append(str(found))
            continue
        for number, name in sorted(found.sessions.items()):
            try:
                rows.append(_row(home / name, found.done.get(number, "")))
            except (SessionError, OrderError, KeyError) as error:
                problems.append(f"{home / name}: {error}")
    return rows, tuple(problems)


def as_csv(rows: Sequence[Row]) -> str:
    """The rows under a heading; a column that a row lacks is empty there."""
    names = list(dict.fromkeys([*FIRST, *(name for row in rows for name in row)]))
    text = io.StringIO()
    writer = csv.DictWriter(text, names, lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({name: _cell(value) for name, value in row.items()})
    return text.getvalue()


def _row(path: Path, why: str) -> Row:
    history, answers, seconds = History(), dict[str, Any](), 0.0
    for event in LogReader(path):
        history.take(event)
        seconds = event.at
        if event.type == kinds.QUESTIONNAIRE:
            answers = dict(event.data["answers"])
    header = history.header.data if history.header else {}
    study, condition = header["study"], header["study"]["condition"]
    totals: Mapping[str, Any] = history.current.after["totals"] if history.current else {}
    return {
        "participant": header["participant"],
        "study": study["id"],
        "slot": study["slot"],
        "condition": condition["id"],
        "part": study["part"],
        "step": study["step"],
        "why": why,
        "session": path.name,
        "policy": condition["policy"],
        "noise": condition["noise"],
        "noise_reading": condition["noise_reading"],
        "panels": condition["panels"],
        **{
            name: condition[name]
            for name in ("weights", "weights_hash", "freeze")
            if name in condition
        },
        "seconds": round(seconds, 1),
        **totals,
        **dict(_prefixed(answers)),
    }


def _prefixed(answers: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Ratings and answers under names that no count has."""
    for name, value in answers.items():
        yield f"answer_{name}", value


def _cell(value: object) -> object:
    """A list as one cell; a text that a spreadsheet would take for a formula as a text."""
    if isinstance(value, list):
        return " ".join(map(str, value))
    if isinstance(value, str) and value[:1] in ("=", "+", "-", "@", "\t", "\r"):
        return f"'{value}"
    return value
