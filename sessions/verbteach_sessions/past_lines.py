"""Single events of a log that was followed but not read: looked up when they are asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

from verbteach_sessions.files import open_regular
from verbteach_sessions.lines import MAX_LINE, Event, decode


class PastLines:
    """Where each line of a log begins; the lines themselves stay on the disk."""

    def __init__(self, path: Path, begins: Sequence[int]) -> None:
        self._path = path
        self._begins = begins

    def event(self, seq: int) -> Event:
        """The event of this number. Raises ``LineError`` and ``IndexError``."""
        with open_regular(self._path) as file:
            file.seek(self._begins[seq])
            return decode(file.readline(MAX_LINE + 1).removesuffix(b"\n"))[0]

    @property
    def last(self) -> int:
        """The number of the last event."""
        return len(self._begins) - 1


class PastRecord(Mapping[str, Any]):
    """What was learned in a ``learned`` event, read when it is first looked into."""

    def __init__(self, lines: PastLines, seq: int) -> None:
        self._lines = lines
        self._seq = seq

    @cached_property
    def _record(self) -> Mapping[str, Any]:
        record: Mapping[str, Any] = self._lines.event(self._seq).data["record"]
        return record

    def __getitem__(self, name: str) -> Any:
        return self._record[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._record)

    def __len__(self) -> int:
        return len(self._record)
