"""Lines broken to a width in terminal cells, for characters that are one or two cells wide."""

from __future__ import annotations

import unicodedata


def cells(text: str) -> int:
    """How many cells a text of printable characters takes in a fixed-width font."""
    return len(text) if text.isascii() else sum(map(_cell, text))


def wrapped(text: str, width: int) -> list[str]:
    """``text`` in rows of at most ``width`` cells, broken at blanks where there are any."""
    rows, row, room = list[str](), list[str](), width
    for word in text.split(" "):
        size = cells(word)
        if row and size + 1 > room:
            rows.append(" ".join(row))
            row, room = [], width
        while size > room and not row:
            head = _head(word, width)
            rows.append(head)
            word = word[len(head) :]  # noqa: PLW2901 - what is left of the word
            size = cells(word)
        room -= size + bool(row)
        row.append(word)
    return [*rows, " ".join(row)]


def _head(word: str, width: int) -> str:
    """As much of the word as fits, one character at least."""
    used = 0
    for index, character in enumerate(word):
        used += _cell(character)
        if used > width:
            return word[: max(index, 1)]
    return word


def _cell(character: str) -> int:
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1
