"""Hypothesis spaces by number, so that what refers to the same one again and again stays short."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from verbteach.verbs.space import HypothesisSpace

Entry = list[Any]
"""A space's digest and its JSON form."""


class SpacePool:
    """Grows only. A space that comes from JSON is built when it is first asked for."""

    def __init__(self, known: Iterable[Entry] = ()) -> None:
        self._entries: list[Entry] = []
        self._built: dict[int, HypothesisSpace] = {}
        self._numbers: dict[str, int] = {}
        self.extend(known)

    def __len__(self) -> int:
        return len(self._entries)

    def __getitem__(self, number: int) -> HypothesisSpace:
        """The space of this number. Raises ``IndexError``, and ``ValueError`` if it is none."""
        if number < 0:
            raise IndexError(f"there is no space {number}")
        if number not in self._built:
            digest, plain = self._entries[number]
            space = HypothesisSpace.from_json(plain)
            vars(space)["digest"] = digest  # which it has from then on, as if it had been asked
            self._built[number] = space
        return self._built[number]

    def extend(self, more: Iterable[Entry]) -> None:
        """Take spaces as :meth:`since` gave them."""
        for digest, plain in more:
            self._add(digest, plain)

    def since(self, number: int) -> list[Entry]:
        """The spaces from this number on, JSON-ready."""
        return self._entries[number:]

    def number(self, space: HypothesisSpace) -> int:
        """The number of a space; a new one if it is not there yet."""
        found = self._numbers.get(space.digest)
        if found is None:
            found = self._add(space.digest, space.to_json())
            self._built[found] = space
        return found

    def _add(self, digest: str, plain: Mapping[str, Any]) -> int:
        self._numbers[digest] = len(self._entries)
        self._entries.append([digest, plain])
        return self._numbers[digest]
