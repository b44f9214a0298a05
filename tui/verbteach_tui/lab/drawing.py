"""The lab's figures drawn as rows: a bar, a learning curve in dots, a table of policies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import groupby, pairwise
from typing import Any

from verbteach_tui.lab.about import FIGURES
from verbteach_tui.lab.lab import CANCELLED, DONE, FAILED, LabState
from verbteach_tui.views.braille import BrailleCanvas
from verbteach_tui.views.rows import Row, Span, clipped, padded, wrapped
from verbteach_tui.views.visible import visible

WINDOW = 25
"""Dialogues whose mean return makes a point of the curve."""

_STAGES: Mapping[str, str] = {
    "rooms": "Furnishing the rooms",
    "learning": "Learning what to ask about demonstrations",
    "lessons": "Being taught verbs",
    "execution": "Learning what to ask before acting",
    "tests": "Being tested",
}
_STYLES = {"learning": "accent", "execution": "robot"}
_AXIS = 7
_COARSE = 10  # a curve that spans less has a decimal on its axis
_FIRST = 8  # the mean of fewer dialogues only leaps about


def progress_rows(state: LabState, width: int) -> list[Row]:
    """What is going on, in a row or two."""
    if state.job is None:
        return wrapped([Span("Nothing is going on. Enter starts what is chosen.", "muted")], width)
    if state.phase == FAILED:
        return wrapped([Span("✗ It failed: ", "bad"), Span(visible(state.note))], width)
    if state.phase == CANCELLED:
        return wrapped([Span("■ Cancelled: ", "warn"), Span(state.note)], width)
    if state.phase == DONE:
        return wrapped([Span("✓ Done. ", "good"), Span(f"Saved in {state.folder}")], width)
    lead, _, stage = state.stage.rpartition(": ")
    text = _STAGES.get(stage, stage) or "Starting"
    head = [Span(f"{lead}: ", "accent")] if lead else []
    return [clipped([*head, Span(text)], width), _bar(state.done, state.total, width)]


def _bar(done: int, total: int, width: int) -> Row:
    said = f" {done} of {total}" if total > 1 else ""
    room = max(width - max(len(said), 14), 1)
    full = room * done // total if total else 0
    return (Span("█" * full, "accent"), Span("░" * (room - full), "border"), Span(said, "muted"))


def smoothed(figures: Sequence[float], window: int = WINDOW) -> list[float]:
    """The mean of each figure and those before it, ``window`` at most."""
    means, total = [], 0.0
    for number, figure in enumerate(figures):
        total += figure - (figures[number - window] if number >= window else 0.0)
        means.append(total / min(number + 1, window))
    return means


def curve_rows(
    curves: Mapping[str, Sequence[float]], total: int, width: int, height: int
) -> list[Row]:
    """The learning curves of both phases: mean return over the dialogues, with an axis."""
    drawn = {stage: smoothed(curves[stage]) for stage in _STYLES if len(curves.get(stage, ())) > 1}
    settled = {stage: points[_FIRST:] or points[-1:] for stage, points in drawn.items()}
    legend = [
        span
        for stage, points in drawn.items()
        for span in (Span("━ ", _STYLES[stage]), Span(f"{stage} {points[-1]:+.0f}   "))
    ]
    rows = height - 2
    if not drawn or rows < 2:
        return [clipped(legend, width)] if legend else []
    low = min(min(points) for points in settled.values())
    high = max(max(points) for points in settled.values())
    canvas = BrailleCanvas(max(width - _AXIS, 4), rows)
    for stage, points in drawn.items():
        _plot(canvas, points, total, (low, high), _STYLES[stage])
    digits = 0 if high - low >= _COARSE else 1
    labels = {0: f"{high:+.{digits}f}", rows - 1: f"{low:+.{digits}f}"}
    lines = [_line(canvas, y, labels.get(y, "")) for y in range(rows)]
    caption = f"{'':{_AXIS}}return of a dialogue, mean of {WINDOW}; {total} dialogues a phase"
    return [clipped(legend, width), *lines, clipped([Span(caption, "muted")], width)]


def _plot(
    canvas: BrailleCanvas,
    points: Sequence[float],
    total: int,
    span: tuple[float, float],
    style: str,
) -> None:
    low, high = span
    reach, steps = (high - low) or 1.0, max(total - 1, len(points) - 1, 1)

    def place(number: int, value: float) -> tuple[float, float]:
        x = number / steps * (canvas.width - 0.5)
        return x, (high - value) / reach * (canvas.height - 0.25)

    stride = max(len(points) // (canvas.width * 2), 1)
    kept = [*range(_FIRST, len(points) - 1, stride), len(points) - 1]
    for one, other in pairwise(kept):
        canvas.line(place(one, points[one]), place(other, points[other]), style)


def _line(canvas: BrailleCanvas, y: int, label: str) -> Row:
    cells = [canvas.cell(x, y) for x in range(canvas.width)]
    spans = [
        Span("".join(text for text, _ in run), style or "text")
        for style, run in groupby(cells, key=lambda cell: cell[1])
    ]
    return (Span(f"{label:>{_AXIS - 1}}│", "muted"), *spans)


_COLUMNS = (
    ("policy", 7),
    ("SJI", 16),
    ("IED", 16),
    ("right", 5),
    ("asked, learning", 15),
    ("acting", 6),
    ("", 4),
)
_NARROW = tuple((name, 5 if name in ("SJI", "IED") else room) for name, room in _COLUMNS)
"""Without the intervals, so that what was asked stays in view beside the scores."""


def table_rows(rows: Sequence[Mapping[str, Any]], width: int) -> list[Row]:
    """Policies side by side, the best SJI named as such.

    Where there is no room the intervals are left out, then columns, the last first.
    """
    if not rows:
        return []
    fits = _room(_COLUMNS) <= width
    shown = list(_COLUMNS if fits else _NARROW)
    while len(shown) > 2 and _room(shown) > width:
        shown.pop()
    best = max(row["sji"]["mean"] for row in rows)
    head = [Span(f"{name:{room}} ", "muted") for name, room in shown]
    lines: list[Row] = [clipped(head, width)]
    for row in rows:
        cells = _cells(row, fits, row["sji"]["mean"] == best)
        mark = "good" if cells[""] else "text"
        spans = [
            Span(f"{cells[name]:{room}} ", mark if name in ("policy", "SJI", "") else "text")
            for name, room in shown
        ]
        lines.append(clipped(padded(spans, width), width))
    return [*lines, (), *wrapped([Span(FIGURES, "muted")], width)]


def _room(columns: Sequence[tuple[str, int]]) -> int:
    return sum(room + 1 for _, room in columns) - 1


def bar_rows(rows: Sequence[Mapping[str, Any]], width: int) -> list[Row]:
    """Each policy's SJI as a bar up to 1, and what it asked for it, for a look from afar."""
    names = max([len(row["policy"]) for row in rows], default=0)
    return [_bar_of(row, names, width) for row in rows]


def _bar_of(row: Mapping[str, Any], names: int, width: int) -> Row:
    asked = row["questions_execution"]["mean"]
    said = f" {row['sji']['mean']:.2f} with {asked:.1f} questions"
    room = max(width - names - 1 - len(said), 1)
    full = round(room * min(max(row["sji"]["mean"], 0.0), 1.0))
    bar = (Span("█" * full, "bar"), Span("░" * (room - full), "border"))
    return clipped([Span(f"{row['policy']:{names}} "), *bar, Span(said, "muted")], width)


def _cells(row: Mapping[str, Any], intervals: bool, best: bool) -> dict[str, str]:
    return {
        "policy": row["policy"],
        "SJI": _figure(row["sji"], intervals),
        "IED": _figure(row["ied"], intervals),
        "right": f"{row['right']:.0%}",
        "asked, learning": f"{row['questions_learning']['mean']:.2f}",
        "acting": f"{row['questions_execution']['mean']:.2f}",
        "": "best" if best else "",
    }


def _figure(value: Mapping[str, Any], interval: bool) -> str:
    low, high = value["ci95"]
    return f"{value['mean']:.3f}" + (f" {low:.2f}-{high:.2f}" if interval else "")
