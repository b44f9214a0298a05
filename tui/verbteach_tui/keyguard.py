"""Makes a wrong key cheap: key repeat answers once, and a typed word is not three answers.

Knows times only as numbers handed to it, so that it can be tested without a clock.
"""

from __future__ import annotations

DEBOUNCE = 0.3
"""Seconds after an answer in which no other key answers."""

SWALLOW = 0.6
"""Seconds after any letter in which a further one counts as typing and is swallowed."""


class KeyGuard:
    """Decides, key by key, which count; times are in seconds of any steady clock."""

    def __init__(self, debounce: float = DEBOUNCE, swallow: float = SWALLOW) -> None:
        self._debounce, self._swallow = debounce, swallow
        self._answered = float("-inf")
        self._typed = float("-inf")
        self._last = ""
        self.swallowed = 0

    def typing(self, character: str, now: float, repeats: bool = False) -> bool:
        """Whether ``character`` is part of a word being typed, to be swallowed.

        A swallowed one opens the window for the next, so that the rest of a
        word is swallowed however long the word is. A key that ``repeats`` may be
        pressed again and again: only after another one is it part of a word.
        """
        going_on = self.goes_on(now) and not character.isdigit()
        if repeats and character == self._last and not self.swallowed:
            going_on = False
        if character.isalpha() or going_on:
            self._typed, self._last = now, character
        self.swallowed = self.swallowed + 1 if going_on else 0
        return going_on

    def goes_on(self, now: float) -> bool:
        """Whether a word is being typed."""
        return now - self._typed < self._swallow

    def ends(self, now: float) -> bool:
        """Whether Enter ``now`` is meant for what was typed or answered just before."""
        return now - max(self._typed, self._answered) < self._swallow

    def answers(self, now: float) -> bool:
        """Whether an answer given ``now`` counts, and is not the last one's key repeating."""
        if now - self._answered < self._debounce:
            return False
        self._answered = now
        return True
