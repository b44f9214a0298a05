"""Hypothesis spaces by number, so that what refers to the same one again and again stays short."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from verbteach.verbs.space import HypothesisSpace
from verbteach_sessions.lines import canonical, digest


class SpacePool:
    """Grows only. A space that comes from JSON is built when it is first asked for."""

    def __init__(self, known: Iterable[Mapping[str, Any]] = ()) -> None:
        self._plain: list[Mapping[str, Any]] = []
        self._built: dict[int, HypothesisSpace] = {}
        self._numbers: dict[str, int] = {}
        self._numbered = 0
        self.extend(known)

    def __len__(self) -> int:
        return len(self._plain)

    def __getitem__(self, number: int) -> HypothesisSpace:
        """The space of this number. Raises ``IndexError``, and ``ValueError`` if it is none."""
        if number < 0:
            raise IndexError(f"there is no space {number}")
        if number not in self._built:
            self._built[number] = HypothesisSpace.from_json(self._plain[number])
        return self._built[number]

    def extend(self, more: Iterable[Mapping[str, Any]]) -> None:
        """Take spaces in their JSON form, as :meth:`since` gave them."""
        for plain in more:
            self._plain.append(plain)

    def since(self, number: int) -> list[Mapping[str, Any]]:
        """The JSON form of the spaces from this number on."""
        return self._plain[number:]

    def number(self, space: HypothesisSpace) -> int:
        """The number of a space; a new one if it is not there yet."""
        found = self._by_digest().get(space.digest)
        if found is None:
            found = self._add(space.digest, space.to_json())
            self._built[found] = space
        return found

    def _add(self, key: str, plain: Mapping[str, Any]) -> int:
        self._numbers[key] = len(self._plain)
        self._plain.append(plain)
        self._numbered = len(self._plain)
        return self._numbers[key]

    def _by_digest(self) -> dict[str, int]:
        """The numbers; those of spaces that came as JSON are worked out on first need."""
        for number in range(self._numbered, len(self._plain)):
            self._numbers[digest(canonical(self._plain[number]))] = number
        self._numbered = len(self._plain)
        return self._numbers
