"""What was shown so far as rows: the steps with a cursor among them, and what they changed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from verbteach_tui.views.rows import Row, Span, wrapped

NEXT_HERE = "next step here"


class Change(NamedTuple):
    """A difference that the steps have made, in words; a ``trifle`` is only where the robot is."""

    text: str
    trifle: bool = False


def step_rows(
    steps: Sequence[str], cursor: int, at: int, width: int, active: bool = True
) -> list[list[Row]]:
    """Each step's rows, and last those of the end; the next step comes before step ``at``.

    ``cursor`` and ``at`` count from 0; the number of steps stands for the end.
    """
    drawn = []
    for index, step in enumerate(steps):
        here = _next_here(width) if index == at else []
        drawn.append(here + _step(index, step, index == cursor and active, width))
    end = Span("▸ " if cursor == len(steps) and active else "  ", "accent")
    text = NEXT_HERE if at == len(steps) else "the end"
    drawn.append(wrapped([Span(text, "note", str(len(steps)))], width, 5, [end, Span("   ")]))
    return drawn


def _step(index: int, step: str, under: bool, width: int) -> list[Row]:
    target = str(index)
    prefix = [Span("▸ " if under else "  ", "accent"), Span(f"{index + 1:2} ", "muted", target)]
    return wrapped([Span(step, "strong" if under else "text", target)], width, 5, prefix)


def _next_here(width: int) -> list[Row]:
    return wrapped([Span(NEXT_HERE, "new")], width, 5, [Span("   + ", "new")])


def change_rows(changes: Sequence[Change], problem: str, steps: int, width: int) -> list[Row]:
    """What could not be done, then what is different from before, trifles last."""
    rows: list[Row] = []
    if problem:
        rows += wrapped([Span(problem)], width, 2, [Span("✗ ", "bad")])
    if not steps:
        return rows + wrapped([Span("Nothing shown yet.", "muted")], width)
    if not changes:
        return rows + wrapped([Span("Nothing is different so far.", "muted")], width)
    for change in sorted(changes, key=lambda one: one.trifle):
        style = "muted" if change.trifle else "text"
        sign = Span("· ", "muted") if change.trifle else Span("✱ ", "new")
        rows += wrapped([Span(change.text, style)], width, 2, [sign])
    return rows
