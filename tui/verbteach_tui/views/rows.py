"""Rows of styled text: what the panels are drawn in before any widget is there to show them.

A style is a word that says what a span means ("robot", "muted"); which colours
that gets is the theme's business. A target names what clicking the span picks.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

from rich.cells import cell_len, chop_cells

STYLES = (
    "text",
    "muted",
    "strong",
    "robot",
    "teacher",
    "note",
    "accent",
    "good",
    "bad",
    "warn",
    "new",
    "asked",
    "border",
    "bar",
    "cursor",
    "tag",
)
"""Every style there is."""


GLUE = "\u00a0"
"""A blank at which :func:`wrapped` breaks no row; it comes out as an ordinary one."""


class Span(NamedTuple):
    """A run of text of one style; ``target`` is what clicking it picks, if anything."""

    text: str
    style: str = "text"
    target: str = ""


Row: TypeAlias = tuple[Span, ...]


_PIECES = re.compile(" +|[^ ]+")


def width_of(spans: Iterable[Span]) -> int:
    """The number of terminal cells that ``spans`` take."""
    return sum(cell_len(span.text) for span in spans)


def plain(row: Row) -> str:
    """The row's text without its styles."""
    return "".join(span.text for span in row)


def padded(spans: Sequence[Span], width: int) -> Row:
    """``spans`` with blanks after them, so that they take ``width`` cells."""
    missing = width - width_of(spans)
    return (*spans, Span(" " * missing)) if missing > 0 else tuple(spans)


def clipped(spans: Iterable[Span], width: int) -> Row:
    """``spans`` cut to ``width`` cells, the last one an ellipsis where something was cut."""
    spans = tuple(spans)
    if width_of(spans) <= width:
        return spans
    room, kept = max(width - 1, 0), list[Span]()
    for span in spans:
        text = _head(span.text, room)
        kept.append(span._replace(text=text))
        room -= cell_len(text)
        if len(text) < len(span.text):
            break
    return (*kept, Span("…"[:width], "muted"))


def unglued(row: Iterable[Span]) -> Row:
    """The row with ordinary blanks in place of ``GLUE``."""
    return tuple(span._replace(text=span.text.replace(GLUE, " ")) for span in row)


def wrapped(
    spans: Iterable[Span], width: int, hanging: int = 0, prefix: Sequence[Span] = ()
) -> list[Row]:
    """``spans`` broken between words into rows of at most ``width`` cells.

    ``prefix`` opens the first row; the following ones are indented by ``hanging``
    cells. Words longer than a row are broken where they must be.
    """
    width = max(width, hanging + 1, 1)
    lines = _Lines(width, hanging, prefix)
    for word in _words(spans):
        lines.add(word)
    return lines.finished()


_Word: TypeAlias = list[Span]
"""Spans without a blank between them, or the blanks between two words."""


class _Lines:
    """Rows under construction."""

    def __init__(self, width: int, hanging: int, prefix: Sequence[Span]) -> None:
        self._width, self._hanging = width, hanging
        self._rows: list[Row] = []
        self._row: list[Span] = list(prefix)
        self._used = width_of(prefix)
        self._empty = True

    def add(self, word: _Word) -> None:
        """Put a word, or the blanks between two words, where there is room for it."""
        cells, blank = width_of(word), word[0].text.isspace()
        if self._used + cells <= self._width:
            if not (blank and self._empty and self._rows):
                self._put(word, cells)
        elif not blank:
            self._break_for(word, cells)

    def finished(self) -> list[Row]:
        """All rows, each with neighbouring spans of one style joined."""
        return [unglued(_joined(row)) for row in (*self._rows, tuple(self._row))]

    def _put(self, word: _Word, cells: int) -> None:
        self._row += word
        self._used += cells
        self._empty = False

    def _break_for(self, word: _Word, cells: int) -> None:
        if not self._empty:
            self._newline()
        if self._used + cells <= self._width:
            self._put(word, cells)
            return
        for span in word:
            self._chop(span)

    def _chop(self, span: Span) -> None:
        """Put a piece of a word that is longer than a row, broken wherever it must be."""
        while span.text:
            head = _head(span.text, self._width - self._used)
            if not head and self._empty:
                head = span.text[:1]  # a character wider than the row
            if head:
                self._put([span._replace(text=head)], cell_len(head))
                span = span._replace(text=span.text[len(head) :])
            if span.text:
                self._newline()

    def _newline(self) -> None:
        while self._row and self._row[-1].text.isspace():
            self._row.pop()
        self._rows.append(tuple(self._row))
        self._row = [Span(" " * self._hanging)] if self._hanging else []
        self._used, self._empty = self._hanging, True


def _words(spans: Iterable[Span]) -> Iterator[_Word]:
    word: _Word = []
    for span in spans:
        for piece in _PIECES.findall(span.text):
            if word and (piece.isspace() or word[0].text.isspace()):
                yield word
                word = []
            word.append(span._replace(text=piece))
    if word:
        yield word


def _head(text: str, cells: int) -> str:
    """As much of ``text`` as takes at most ``cells`` cells."""
    if cells <= 0:
        return ""
    head = chop_cells(text, cells)[0] if text else ""
    return head if cell_len(head) <= cells else ""


def _joined(row: Sequence[Span]) -> Row:
    joined: list[Span] = []
    for span in row:
        if joined and joined[-1][1:] == span[1:]:
            joined[-1] = span._replace(text=joined[-1].text + span.text)
        else:
            joined.append(span)
    return tuple(joined)
