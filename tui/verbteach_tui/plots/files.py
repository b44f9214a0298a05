"""A chart as a picture file, with matplotlib."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from verbteach_tui.plots.curves import COLOURS, MARKERS, Chart, Line

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FORMATS = ("png", "svg")


def draw(chart: Chart, stem: Path) -> list[Path]:
    """Write ``stem``.png and ``stem``.svg; equal charts give equal files."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    paths = [stem.with_suffix(f".{kind}") for kind in FORMATS]
    with mpl.rc_context({"svg.hashsalt": "verbteach", "font.size": 10}):
        figure = Figure(figsize=(7.2, 4.6), layout="constrained")
        _plot(chart, figure.add_subplot())
        for path in paths:
            nothing = {"Date": None} if path.suffix == ".svg" else {"Software": None}
            figure.savefig(path, dpi=160, metadata=nothing)
    return paths


def _plot(chart: Chart, axes: Axes) -> None:
    for line in chart.lines:
        _line(line, axes)
    for policy, mark in chart.marks.items():
        axes.plot(
            mark.x, mark.y, marker="*", markersize=14, color=_colour(policy), zorder=5, ls="none"
        )
    axes.set_title(chart.title)
    axes.set_xlabel(chart.across)
    axes.set_ylabel(chart.up)
    axes.set_ylim(bottom=chart.bottom)
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)


def _line(line: Line, axes: Axes) -> None:
    across, up = [p.x for p in line.points], [p.y for p in line.points]
    colour, marker = _colour(line.policy), MARKERS.get(line.policy, ".")
    axes.plot(across, up, marker=marker, linewidth=1.8, color=colour, label=line.label)
    axes.fill_between(
        across,
        [p.low for p in line.points],
        [p.high for p in line.points],
        color=colour,
        alpha=0.12,
        linewidth=0,
    )


def _colour(policy: str) -> str:
    return COLOURS.get(policy, "#333333")
