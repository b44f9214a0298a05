"""The rows of a sweep on disk: one JSON line each, appended as it comes; and as CSV, to look at.

A row that a crash cut short is the last line and is left out on reading; the
next one appended takes its place.
"""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from verbteach.experiments.reproduction.rows import Row
from verbteach_scenarios.errors import WorldFileError

COLUMNS = (
    *("section", "policy", "noise", "noise_reading", "run", "lessons", "document", "instance"),
    *("ied", "sji", "right", "ground", "env", "goal", "total"),
)
"""The columns of the CSV: one line a test command."""


class RowsFileError(WorldFileError):
    """A file of rows does not fit."""


class RowsFile:
    """Rows, in the order they were done."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def read(self) -> tuple[Row, ...]:
        """Every whole row. Raises ``RowsFileError`` where a line before the last is none."""
        return tuple(self._rows())

    def _rows(self) -> Iterator[Row]:
        lines = self._bytes().split(b"\n")
        for number, line in enumerate(lines[:-1], start=1):
            try:
                yield Row.from_json(json.loads(line))
            except ValueError as error:
                raise RowsFileError(self.path, number, str(error)) from error

    def _bytes(self) -> bytes:
        return self.path.read_bytes() if self.path.exists() else b""

    def append(self, row: Row) -> None:
        """Add a row; it is on disk when this returns, whole or not at all."""
        line = json.dumps(row.to_json(), separators=(",", ":"), allow_nan=False).encode() + b"\n"
        with self.path.open("ab") as file:
            self._cut_torn(file.fileno())
            file.write(line)
            file.flush()
            os.fsync(file.fileno())

    def _cut_torn(self, descriptor: int) -> None:
        """Take away what a crash left of a line."""
        size = os.fstat(descriptor).st_size
        if not size:
            return
        with self.path.open("rb") as file:
            file.seek(size - 1)
            if file.read(1) == b"\n":
                return
        os.ftruncate(descriptor, self._bytes().rfind(b"\n") + 1)


def write_csv(path: Path, sections: Mapping[str, Sequence[Row]]) -> None:
    """Every test command of every row, a line each."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for section, rows in sections.items():
            writer.writerows(_lines(section, rows))


def _lines(section: str, rows: Iterable[Row]) -> Iterator[Sequence[Any]]:
    for row in rows:
        head = (section, row.policy, row.noise, row.settings["reading"], row.run, row.lessons)
        for one in row.commands:
            scores = (one.ied, one.sji, int(one.right))
            asked = (one.ground, one.env, one.goal, one.total)
            yield (*head, one.document, one.instance, *scores, *asked)
