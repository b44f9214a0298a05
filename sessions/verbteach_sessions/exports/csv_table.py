"""CSV: one row a turn, and one a session in a file of its own.

Lists and objects are JSON text. A text that a spreadsheet would take for a
formula gets an apostrophe in front, so that opening the file runs nothing.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from verbteach_sessions.exports.columns import (
    SESSIONS,
    TURNS,
    Column,
    Row,
    json_text,
    session_row,
    turn_rows,
)
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.kinds import is_scalar

_FORMULA = ("=", "+", "-", "@", "\t", "\r")


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``turns.csv`` and ``sessions.csv``."""
    with (
        (folder / "turns.csv").open("w", encoding="utf-8", newline="") as turns,
        (folder / "sessions.csv").open("w", encoding="utf-8", newline="") as sessions,
    ):
        turn_writer, session_writer = csv.writer(turns), csv.writer(sessions)
        turn_writer.writerow(column.name for column in TURNS.columns)
        session_writer.writerow(column.name for column in SESSIONS.columns)
        for dialogue in dialogues:
            session_writer.writerow(_cells(SESSIONS.columns, session_row(dialogue)))
            for row in turn_rows(dialogue):
                turn_writer.writerow(_cells(TURNS.columns, row))


def _cells(columns: Iterable[Column], row: Row) -> list[str]:
    return [_cell(column, row[column.name]) for column in columns]


def _cell(column: Column, value: Any) -> str:
    if value is None:
        return ""
    if not is_scalar(column.kind):
        return json_text(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        # A zero byte ends the row for some readers.
        return _harmless(value.replace("\0", "\N{SYMBOL FOR NULL}"))
    return repr(value)


def _harmless(text: str) -> str:
    return f"'{text}" if text.startswith(_FORMULA) else text
