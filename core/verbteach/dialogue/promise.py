"""A promise to the teacher: how much of what the robot carries out will be right.

It is kept by not carrying out what the robot is not sure enough of: it asks on,
and asks to be shown where it has no question left. How its sureness is measured
and how sure is enough was found beforehand (``policy/stopping.py``); here the
robot is only held to it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from verbteach.dialogue.acts import DemonstrationReason, RequestDemonstration, SelectHypo
from verbteach.dialogue.decision import Candidate


@dataclass(frozen=True)
class Sureness:
    """How likely carrying the best goal out now is right, from the features of ``select_hypo``.

    ``weights`` by feature name; the probability is their weighted sum through
    the logistic function.
    """

    weights: Mapping[str, float]

    def of(self, features: Mapping[str, float]) -> float:
        """The probability, 0 to 1."""
        score = math.fsum(self.weights[name] * features.get(name, 0.0) for name in self.weights)
        return 1.0 / (1.0 + math.exp(-min(max(score, -30.0), 30.0)))

    def now(self, candidates: Sequence[Candidate]) -> float | None:
        """That of a phase's candidate acts; ``None`` where there is nothing to carry out."""
        last = candidates[-1]
        return self.of(last.features) if isinstance(last.act, SelectHypo) else None


@dataclass(frozen=True)
class Promise:
    """Of the commands carried out, a share of ``rate`` or more is to be right.

    The robot acts when it is at least ``sure`` (0 to 1) by its ``sureness``;
    ``lessons`` is how many commands that was calibrated on. Raises
    ``ValueError`` for numbers that are no such promise.
    """

    rate: float
    sure: float
    lessons: int
    sureness: Sureness

    def __post_init__(self) -> None:
        if not 0.0 < self.rate < 1.0:
            raise ValueError(f"a promised success rate is between 0 and 1, not {self.rate}")
        if not 0.0 <= self.sure <= 1.0:
            raise ValueError(f"how sure the robot has to be is between 0 and 1, not {self.sure}")
        if self.lessons < 1:
            raise ValueError(f"a promise rests on lessons, not on {self.lessons}")

    @property
    def text(self) -> str:
        """The promise in one line, as screens and plain lines show it."""
        sure = f"{self.sure:.2f}".removeprefix("0")
        return (
            f"acts when at least {sure} sure: promised {self.rate:.0%},"
            f" calibrated on {self.lessons} lessons"
        )

    @property
    def short(self) -> str:
        """The promise in two words."""
        return f"promised {self.rate:.0%}"

    def covers(self, candidates: Sequence[Candidate]) -> bool:
        """Whether carrying out the last of a phase's candidate acts keeps the promise."""
        now = self.sureness.now(candidates)
        return now is not None and now >= self.sure


def held_to(promise: Promise | None, candidates: Sequence[Candidate]) -> list[Candidate]:
    """The candidate acts that the promise leaves open, the one that ends the phase last.

    Where the robot is less sure than it has to be, being shown stands in the
    place of carrying out; whatever policy asks, it chooses among the rest.
    """
    offered = list(candidates)
    if promise is None or not isinstance(offered[-1].act, SelectHypo) or promise.covers(offered):
        return offered
    return [*offered[:-1], instead_shown()]


def instead_shown() -> Candidate:
    """Asking to be shown, because nothing is sure enough."""
    shown = RequestDemonstration(DemonstrationReason.NOT_SURE)
    return Candidate(shown, {"request_demonstration": 1.0})
