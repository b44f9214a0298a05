"""JSON Lines in the layout of the Hugging Face hub: data, a JSON Schema each, and a card."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TextIO

from verbteach_sessions.exports.card import Figures, card
from verbteach_sessions.exports.columns import SESSIONS, TURNS, Row, session_row, turn_rows
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.folder import write_json, write_text

SPLITS = ("train", "validation", "test")


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``data/TABLE-SPLIT.jsonl``, ``schema/TABLE.schema.json`` and ``README.md``."""
    figures = Figures()
    with _Files(folder / "data") as files:
        for dialogue in dialogues:
            figures.add(dialogue)
            files.write(SESSIONS.name, dialogue.split, [session_row(dialogue)])
            files.write(TURNS.name, dialogue.split, turn_rows(dialogue))
        written = files.names
    for table in (SESSIONS, TURNS):
        write_json(folder / "schema" / f"{table.name}.schema.json", table.schema)
    write_text(folder / "README.md", card(figures, written))


class _Files:
    """One file a table and a split, opened when there is something to write."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._open: dict[tuple[str, str], TextIO] = {}

    def __enter__(self) -> _Files:
        self._folder.mkdir(parents=True)
        return self

    def __exit__(self, *error: object) -> None:
        for file in self._open.values():
            file.close()

    @property
    def names(self) -> Mapping[str, list[tuple[str, str]]]:
        """For each table its splits, each with the path of its file."""
        return {
            table.name: [
                (split, f"data/{table.name}-{split}.jsonl")
                for split in SPLITS
                if (table.name, split) in self._open
            ]
            for table in (TURNS, SESSIONS)
        }

    def write(self, table: str, split: str, rows: Iterable[Row]) -> None:
        """Append rows to the table's file of this split."""
        key = table, split
        if key not in self._open:
            path = self._folder / f"{table}-{split}.jsonl"
            self._open[key] = path.open("w", encoding="utf-8", newline="\n")
        for row in rows:
            # In ASCII, since some readers break lines at signs that are no line ends of JSON Lines.
            text = json.dumps(row, separators=(",", ":"), allow_nan=False)
            self._open[key].write(text + "\n")
