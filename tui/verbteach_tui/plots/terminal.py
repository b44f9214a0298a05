"""A chart in the terminal: braille dots, one colour a curve, each named at its right end."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from verbteach_tui.plots.curves import COLOURS, Chart, Line, Point
from verbteach_tui.views.braille import BrailleCanvas

if TYPE_CHECKING:
    from rich.text import Text

_LEFT = 6
"""Cells for the numbers at the left axis."""


@dataclass(frozen=True)
class _Frame:
    """Where the chart's numbers fall on a canvas of so many cells."""

    width: int
    height: int
    left: float
    right: float
    top: float

    def at(self, point: Point) -> tuple[float, float]:
        """A point in cells from the upper left."""
        span = self.right - self.left or 1.0
        across = (point.x - self.left) / span * (self.width - 1)
        return across, (1.0 - point.y / self.top) * (self.height - 0.5)


def draw(chart: Chart, width: int = 80, height: int = 20) -> Text:
    """The chart in ``width`` x ``height`` cells, axes and names included."""
    from rich.text import Text

    longest = max((len(line.label) for line in chart.lines), default=0)
    frame = _frame(chart, max(10, width - _LEFT - longest - 3), max(4, height - 3))
    canvas = BrailleCanvas(frame.width, frame.height)
    for line in chart.lines:
        _draw(line, frame, canvas)
    names = _names(chart, frame)
    marks = _marks(chart, frame)
    text = Text(f"{chart.title}\n", no_wrap=True)
    for row in range(frame.height):
        number = _number(row, frame)
        text.append(number.rjust(_LEFT - 1) + ("┤" if number else "│"))
        for column in range(frame.width):
            text.append(*marks.get((column, row), canvas.cell(column, row)))
        for label, style in names.get(row, []):
            text.append(f" {label}", style)
        text.append("\n")
    text.append(_bottom(chart, frame))
    return text


def _frame(chart: Chart, width: int, height: int) -> _Frame:
    across = [p.x for p in chart.points] or [0.0, 1.0]
    highest = max((p.y for p in chart.points), default=1.0)
    return _Frame(width, height, min(across), max(across), max(0.1, math.ceil(highest * 10) / 10))


def _draw(line: Line, frame: _Frame, canvas: BrailleCanvas) -> None:
    places = [frame.at(point) for point in line.points]
    for start, end in zip(places, places[1:] or places, strict=False):
        canvas.line(start, end, _colour(line.policy))


def _marks(chart: Chart, frame: _Frame) -> dict[tuple[int, int], tuple[str, str]]:
    """A star, with its style, in the cell of each single point."""
    found = {}
    for policy, mark in chart.marks.items():
        across, down = frame.at(mark)
        found[int(across), int(down)] = ("★", _colour(policy))
    return found


def _names(chart: Chart, frame: _Frame) -> dict[int, list[tuple[str, str]]]:
    """Each curve's name beside its end, moved to a free row where two would meet."""
    found: dict[int, list[tuple[str, str]]] = {}
    ends = ((frame.at(line.points[-1])[1], line) for line in chart.lines if line.points)
    for height, line in sorted(ends, key=lambda pair: (pair[0], pair[1].policy)):
        row = next(_free(found, int(height), frame.height), frame.height - 1)
        found.setdefault(row, []).append((line.label, _colour(line.policy)))
    return found


def _free(taken: dict[int, list[tuple[str, str]]], wanted: int, height: int) -> Iterator[int]:
    rows = sorted(range(height), key=lambda row: (abs(row - wanted), row))
    return (row for row in rows if row not in taken)


def _number(row: int, frame: _Frame) -> str:
    """The figure at a row of the left axis, at every fourth."""
    if row % 4 and row != frame.height - 1:
        return ""
    value = frame.top * (1.0 - row / (frame.height - 0.5))
    return f"{max(0.0, value):.2f}" if row != frame.height - 1 else "0.00"


def _bottom(chart: Chart, frame: _Frame) -> str:
    left, right = (f"{round(value, 1):g}" for value in (frame.left, frame.right))
    gap = max(1, frame.width - len(left) - len(right))
    axis = " " * (_LEFT - 1) + "└" + "─" * frame.width
    numbers = " " * _LEFT + left + chart.across.center(gap) + right
    return f"{axis}\n{numbers}"


def _colour(policy: str) -> str:
    return COLOURS.get(policy, "")
