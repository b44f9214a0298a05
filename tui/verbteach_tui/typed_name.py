"""Finding a name in a list by typing it: "liv", "kitchen-3", or "k3" for short.

Knows times only as numbers handed to it, so that it can be tested without a clock.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

PAUSE = 1.5
"""Seconds after a letter in which the next one belongs to the same name."""


class TypedName:
    """What was typed so far, and the name that it means."""

    def __init__(self, names: Sequence[str]) -> None:
        self._names = names
        self._last = float("-inf")
        self.text = ""

    def type(self, character: str, now: float, current: str = "") -> str | None:
        """The name meant now, ``None`` where no name goes on like that: the letter is then dropped.

        One letter again and again goes through the names that begin with it,
        from ``current`` on.
        """
        text = (self.text if now - self._last < PAUSE else "") + character.lower()
        found = next(self._meant(text), None)
        if found is None and set(text) == {text[0]}:
            text = text[0]
            found = self._next(text, current)
        if found is not None:
            self.text, self._last = text, now
        return found

    def back(self, now: float) -> str | None:
        """The name meant without the last letter; ``None`` where nothing is left of it."""
        self.text, self._last = self.text[:-1], now
        return next(self._meant(self.text), None) if self.text else None

    def _meant(self, text: str) -> Iterator[str]:
        """The names that begin so, then those whose letters in order are these, then others."""
        fits: tuple[Callable[[str], bool], ...] = (
            lambda name: name.startswith(text),
            lambda name: name[:1] == text[:1] and _in_order(text, name),
            lambda name: text in name,
        )
        for fit in fits:
            yield from (name for name in self._names if fit(name.lower()))

    def _next(self, text: str, current: str) -> str | None:
        names = [name for name in self._names if name.lower().startswith(text)]
        if current in names:
            return names[(names.index(current) + 1) % len(names)]
        return names[0] if names else None


def _in_order(text: str, name: str) -> bool:
    letters = iter(name)
    return all(letter in letters for letter in text)
