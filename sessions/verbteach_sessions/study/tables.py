"""Reading the tables of a study's file: each value by its name and kind, every misfit noted.

A misfit does not stop the reading, so that whoever writes a study hears of all
of them at once.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any, TypeVar

from verbteach_sessions.study.errors import Problem
from verbteach_sessions.study.toml_lines import Path, nearest

_T = TypeVar("_T")


class Notes:
    """What was found not to fit so far."""

    def __init__(self, lines: Mapping[Path, int]) -> None:
        self._lines = lines
        self.problems: list[Problem] = []

    def add(self, path: Path, message: str) -> None:
        """Note what is wrong at ``path``."""
        name = ".".join(str(part) for part in path if not isinstance(part, int))
        self.problems.append(Problem(nearest(self._lines, path), f"{name}: {message}"))


class Table:
    """One table of the file. Ask for what it may hold, then :meth:`close` it."""

    def __init__(self, data: Any, path: Path, notes: Notes) -> None:
        if not isinstance(data, dict):
            notes.add(path, "must be a table")
            data = {}
        self.path, self.notes = path, notes
        self._data: Mapping[str, Any] = data
        self._asked: set[str] = set()

    def __contains__(self, name: str) -> bool:
        return name in self._data

    def fail(self, name: str, message: str) -> None:
        """Note that the member ``name`` does not fit."""
        self.notes.add((*self.path, name), message)

    def text(self, name: str, default: str | None = None) -> str:
        """A text; needed unless there is a default."""
        value = self._get(name, default)
        if value is None:
            self.fail(name, "is missing: write a text in quotes")
            return ""
        if not isinstance(value, str) or (not value.strip() and default is None):
            self.fail(name, "must be a text in quotes, and not empty")
            return default or ""
        return value

    def choice(self, name: str, among: Collection[str], default: str | None = None) -> str:
        """A text that is one of ``among``."""
        value = self.text(name, default)
        if value and value not in among:
            self.fail(name, f"{value[:40]!r} is none of: {', '.join(among)}")
        return value

    def whole(self, name: str, default: int | None, least: int, most: int) -> int | None:
        """A whole number between ``least`` and ``most``."""
        if name not in self:
            return self._left_out(name, default)
        value = self._get(name, default)
        if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
            self.fail(name, f"must be a whole number from {least} to {most}")
            return default
        return value

    def number(self, name: str, default: float | None, above: float = 0.0) -> float | None:
        """A number greater than ``above``."""
        if name not in self:
            return self._left_out(name, default)
        value = self._get(name, default)
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if not is_number or not above < value < 1e9:
            self.fail(name, f"must be a number greater than {above:g}")
            return default
        return float(value)

    def flag(self, name: str, default: bool) -> bool:
        """``true`` or ``false``."""
        value = self._get(name, default)
        if not isinstance(value, bool):
            self.fail(name, "must be true or false")
            return default
        return value

    def words(
        self, name: str, default: tuple[str, ...], among: Collection[str] = ()
    ) -> tuple[str, ...]:
        """A list of texts, each of ``among`` where that is given."""
        if name not in self:
            return self._left_out(name, default)
        value = self._get(name, default)
        if not isinstance(value, list) or not all(isinstance(one, str) for one in value):
            self.fail(name, "must be a list of texts in quotes")
            return default
        for one in value:
            if among and one not in among:
                self.fail(name, f"{one[:40]!r} is none of: {', '.join(among)}")
        return tuple(dict.fromkeys(value))

    def table(self, name: str) -> Table:
        """A table inside this one; an empty one where it is missing."""
        return Table(self._get(name, {}), (*self.path, name), self.notes)

    def tables(self, name: str) -> Iterator[Table]:
        """A list of tables inside this one, ``[[name]]`` each."""
        value = self._get(name, [])
        if not isinstance(value, list):
            self.fail(name, f"must be a list of tables: write [[{name}]]")
            return
        for index, one in enumerate(value):
            yield Table(one, (*self.path, name, index), self.notes)

    def close(self) -> None:
        """Note what was never asked for: a name that means nothing here, often a slip."""
        for name in self._data:
            if name not in self._asked:
                has = ", ".join(sorted(self._asked))
                self.fail(name, f"is not known here; this table may have: {has}")

    def _left_out(self, name: str, default: _T) -> _T:
        self._asked.add(name)
        return default

    def _get(self, name: str, default: Any) -> Any:
        self._asked.add(name)
        return self._data.get(name, default)
