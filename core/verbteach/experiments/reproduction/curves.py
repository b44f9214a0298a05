"""Scores against what they cost: against lessons (Figure 5), and against questions asked."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

from verbteach.experiments.figures import Figure, Observation, figure
from verbteach.experiments.reproduction.rows import Command, Row
from verbteach.experiments.reproduction.tables import RESAMPLES, SCORES, cells
from verbteach.experiments.sight import stream

Curve: TypeAlias = list[list[Any]]
"""[x, figure] by growing x."""


def figure5(
    rows: Sequence[Row], score: str = "sji", resamples: int = RESAMPLES
) -> dict[str, Curve]:
    """Policy -> [number of lessons, figure] from the rows' checkpoints."""
    found: dict[str, Curve] = {}
    for (policy, _), own in cells(rows).items():
        points = [_checkpoint(own, place, score, resamples) for place in _places(own)]
        if points:
            found[policy] = sorted(points, key=lambda point: int(point[0]))
    return found


def _places(rows: Sequence[Row]) -> range:
    return range(min(len(row.growth) for row in rows))


def _checkpoint(rows: Sequence[Row], place: int, score: str, resamples: int) -> list[Any]:
    taken = [row.growth[place] for row in rows]
    lessons = round(sum(one.lessons for one in taken) / len(taken))
    runs = [
        [Observation(s.document, float(getattr(s, score))) for s in one.scores] for one in taken
    ]
    rng = stream("checkpoint", score, place, *(row.place for row in rows))
    return [lessons, figure(runs, rng, resamples).to_json()]


def per_question(
    rows: Sequence[Row], noise: str, score: str = "sji", resamples: int = RESAMPLES
) -> dict[str, Curve]:
    """Policy -> [questions asked, figure]: what it comes to when stopped after so many.

    A command on which nothing is left to ask stays as it is, so that the
    questions asked are on average fewer than the limit; their mean is the x.
    """
    found: dict[str, Curve] = {}
    for (policy, level), own in cells(rows).items():
        longest = max(len(command.trace) for row in own for command in row.commands)
        if level == noise and longest:
            found[policy] = [_limited(own, limit, score, resamples) for limit in range(longest)]
    return found


def _limited(rows: Sequence[Row], limit: int, score: str, resamples: int) -> list[Any]:
    stopped = stopped_at(rows, float(limit))
    return [stopped.questions, stopped.figure(score, resamples).to_json()]


@dataclass(frozen=True)
class Stopped:
    """What policies' traces come to with a limit on the questions."""

    rows: tuple[Row, ...]
    limit: float

    @cached_property
    def questions(self) -> float:
        """Mean questions asked per command, over runs."""
        means = [
            math.fsum(min(self.limit, len(c.trace) - 1) for c in row.commands) / len(row.commands)
            for row in self.rows
        ]
        return math.fsum(means) / len(means)

    def observations(self, row: Row, score: str) -> list[Observation]:
        """A score of every command of one of the rows."""
        place = SCORES.index(score)
        return [Observation(c.document, _after(c, self.limit, place)) for c in row.commands]

    def figure(self, score: str, resamples: int = RESAMPLES) -> Figure:
        """A score over all commands and runs."""
        rng = stream("stopped", score, repr(self.limit), *(row.place for row in self.rows))
        return figure([self.observations(row, score) for row in self.rows], rng, resamples)


def stopped_at(rows: Sequence[Row], limit: float) -> Stopped:
    """The rows with a limit; a fraction is the probability that one more question is put."""
    return Stopped(tuple(rows), limit)


def asking(rows: Sequence[Row], questions: float) -> Stopped:
    """The rows with the limit at which so many questions are asked on average.

    Where they never ask as many, there is no limit but the trace's end. Between
    two whole limits the questions grow in proportion.
    """
    most = max(len(command.trace) - 1 for row in rows for command in row.commands)
    fewer = stopped_at(rows, 0.0)
    for limit in range(1, most + 1):
        more = stopped_at(rows, float(limit))
        if more.questions >= questions:
            part = (questions - fewer.questions) / (more.questions - fewer.questions)
            return stopped_at(rows, fewer.limit + max(0.0, part))
        fewer = more
    return fewer


def _after(command: Command, limit: float, place: int) -> float:
    """The score after so many questions, between two whole numbers in proportion."""
    last = len(command.trace) - 1
    whole, part = int(limit), limit - int(limit)
    here = command.trace[min(whole, last)][place]
    return here + part * (command.trace[min(whole + 1, last)][place] - here)
