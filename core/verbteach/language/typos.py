"""Typing errors: words near one that is known. Offered to the person, never applied."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache


@lru_cache(maxsize=1 << 14)
def distance(one: str, other: str) -> int:
    """Optimal string alignment: insertions, deletions, changes and swaps of neighbours."""
    before: list[int] = []
    last = list(range(len(other) + 1))
    for i, letter in enumerate(one, 1):
        row = [i]
        for j, second in enumerate(other, 1):
            cost = letter != second
            best = min(row[j - 1] + 1, last[j] + 1, last[j - 1] + cost)
            if i > 1 and j > 1 and letter == other[j - 2] and one[i - 2] == second:
                best = min(best, before[j - 2] + 1)
            row.append(best)
        before, last = last, row
    return last[-1]


def bound(word: str) -> int:
    """How many errors a word of this length may hold: none up to 3 letters, 2 from 8 on."""
    return 0 if len(word) <= 3 else 1 if len(word) <= 7 else 2


def suggest(word: str, vocabulary: Iterable[str], most: int = 3) -> tuple[str, ...]:
    """Known words that ``word`` may have been meant for, the nearest first, then by spelling."""
    return _near(word, frozenset(vocabulary))[:most]


@lru_cache(maxsize=1 << 10)
def _near(word: str, vocabulary: frozenset[str]) -> tuple[str, ...]:
    """All words within the bound, the nearest first; a scene's words are asked about often."""
    limit = bound(word)
    near = (
        (distance(word, known), known)
        for known in vocabulary
        if known != word and abs(len(known) - len(word)) <= limit and len(known) > 2
    )
    return tuple(known for errors, known in sorted(near) if errors <= limit)


def suggest_verb(word: str, verbs: Iterable[str]) -> tuple[str, ...]:
    """Known verbs that ``word`` may have been meant for; of a short one a letter may be missing.

    Verbs are few, and an unknown one is always asked about: so "opn" may be "open",
    where a short noun is left alone.
    """
    known = frozenset(verbs)
    near = suggest(word, known)
    if near or len(word) != _SHORT:
        return near
    longer = [one for one in sorted(known) if len(one) == _SHORT + 1 and distance(word, one) == 1]
    return tuple(longer[:3])


_SHORT = 3
