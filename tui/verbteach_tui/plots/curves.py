"""What is to be drawn: named curves with intervals, as plain values. Knows no way of drawing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

COLOURS: Mapping[str, str] = {
    "rl": "#0072b2",
    "manual": "#e69f00",
    "split": "#009e73",
    "random": "#999999",
    "she16": "#cc79a7",
    "she16-all": "#d55e00",
    "lspi": "#0072b2",
    "bayesian": "#56b4e9",
    "true-online": "#cc79a7",
    "sarsa": "#d55e00",
}
"""A colour a policy or learner, told apart with any colour vision (Okabe & Ito)."""

MARKERS: Mapping[str, str] = {
    "rl": "o",
    "manual": "s",
    "split": "^",
    "random": "x",
    "she16": "D",
    "she16-all": "v",
    "lspi": "o",
    "bayesian": "P",
    "true-online": "D",
    "sarsa": "v",
}


class Point(NamedTuple):
    """A value at ``x`` with its interval."""

    x: float
    y: float
    low: float
    high: float


@dataclass(frozen=True)
class Line:
    """One policy's curve."""

    policy: str
    label: str
    points: tuple[Point, ...]


@dataclass(frozen=True)
class Chart:
    """Curves with what stands at the axes; ``marks`` are single points, by policy.

    ``bottom`` is where the axis upwards begins in a picture.
    """

    title: str
    across: str
    up: str
    lines: tuple[Line, ...]
    marks: Mapping[str, Point]
    bottom: float = 0.0

    @property
    def points(self) -> tuple[Point, ...]:
        """Every point."""
        return (*(p for line in self.lines for p in line.points), *self.marks.values())


def lines(curves: Mapping[str, Sequence[Sequence[Any]]], names: Mapping[str, str]) -> list[Line]:
    """Curves of a reproduction's document as lines."""
    return [
        Line(policy, names.get(policy, policy), tuple(point(x, figure) for x, figure in curve))
        for policy, curve in curves.items()
    ]


def point(x: float, figure: Mapping[str, Any]) -> Point:
    """A figure of the document at ``x``."""
    low, high = figure["ci95"]
    return Point(float(x), figure["mean"], low, high)
