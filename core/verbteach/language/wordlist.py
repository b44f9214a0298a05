"""How this room writes its word lists down: words in plain text, separated by spaces."""

from __future__ import annotations


def word_set(text: str) -> frozenset[str]:
    """The words of ``text``."""
    return frozenset(text.split())


def phrase_list(text: str) -> tuple[tuple[str, ...], ...]:
    """Phrases separated by commas, each as its words; the longest first, then by alphabet."""
    phrases = [tuple(phrase.split()) for phrase in text.split(",")]
    return tuple(sorted(filter(None, phrases), key=lambda words: (-len(words), words)))


def by_first_word(text: str) -> dict[str, tuple[tuple[str, ...], ...]]:
    """The phrases of ``phrase_list`` under their first words, the longest first."""
    phrases = phrase_list(text)
    firsts = sorted({phrase[0] for phrase in phrases})
    return {first: tuple(p for p in phrases if p[0] == first) for first in firsts}


def pairs(text: str) -> dict[str, str]:
    """``a:b c:d`` as a mapping."""
    return {left: right for left, _, right in (entry.partition(":") for entry in text.split())}
