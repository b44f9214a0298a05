"""A goal read back: which of the demonstrated changes belong to it, one to a row."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from verbteach.world.fluents import Literal
from verbteach_tui.views.rows import Row, Span, wrapped


class GoalPart(NamedTuple):
    """A literal in words; ``kept``: it belongs to the goal as the robot has it."""

    literal: Literal
    kept: bool
    must: str
    need_not: str


def read_back_rows(parts: Sequence[GoalPart], cursor: int, width: int) -> list[list[Row]]:
    """Each part's rows; the one under the cursor is marked."""
    return [_part_rows(part, index, index == cursor, width) for index, part in enumerate(parts)]


def _part_rows(part: GoalPart, index: int, under: bool, width: int) -> list[Row]:
    box = Span("[✓] " if part.kept else "[ ] ", "good" if part.kept else "muted", str(index))
    text = part.must if part.kept else part.need_not
    style = "strong" if under else "text" if part.kept else "muted"
    prefix = [Span("▸ " if under else "  ", "accent"), box]
    return wrapped([Span(text, style, str(index))], width, 6, prefix)
