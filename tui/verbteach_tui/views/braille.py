"""Straight lines drawn in braille dots: two by four dots in every terminal cell."""

from __future__ import annotations

from collections.abc import Iterator

_BLANK = 0x2800
# Unicode numbers the dots of a cell by column, with the bottom row added later.
_BITS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
ACROSS, DOWN = 2, 4
"""Dots in a cell, across and down."""


class BrailleCanvas:
    """A grid of dots; each cell remembers the style that was drawn in it last."""

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self._dots: dict[tuple[int, int], int] = {}
        self._styles: dict[tuple[int, int], str] = {}

    def line(self, start: tuple[float, float], end: tuple[float, float], style: str) -> None:
        """Draw from ``start`` to ``end``, both (x, y) in cells, fractions allowed."""
        for x, y in _points(_scaled(start), _scaled(end)):
            self._set(x, y, style)

    def cell(self, x: int, y: int) -> tuple[str, str]:
        """The character and style of a cell; a blank and "" where nothing was drawn."""
        dots = self._dots.get((x, y), 0)
        return (chr(_BLANK + dots), self._styles[x, y]) if dots else (" ", "")

    def _set(self, x: int, y: int, style: str) -> None:
        cell = (x // ACROSS, y // DOWN)
        if 0 <= cell[0] < self.width and 0 <= cell[1] < self.height:
            self._dots[cell] = self._dots.get(cell, 0) | _BITS[y % DOWN][x % ACROSS]
            self._styles[cell] = style


def _scaled(point: tuple[float, float]) -> tuple[int, int]:
    return int(point[0] * ACROSS), int(point[1] * DOWN)


def _points(start: tuple[int, int], end: tuple[int, int]) -> Iterator[tuple[int, int]]:
    """Bresenham's line."""
    (x, y), (dx, dy) = start, (abs(end[0] - start[0]), -abs(end[1] - start[1]))
    step_x, step_y = (1 if start[0] < end[0] else -1), (1 if start[1] < end[1] else -1)
    error = dx + dy
    while True:
        yield x, y
        if (x, y) == end:
            return
        doubled = 2 * error
        if doubled >= dy:
            error, x = error + dy, x + step_x
        if doubled <= dx:
            error, y = error + dx, y + step_y
