"""Evaluating a policy on another policy's log, or saying why the log cannot tell."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from verbteach.experiments.off_policy.estimators import DoublyRobust, FittedQ, estimators
from verbteach.experiments.off_policy.intervals import RESAMPLES, Estimate, estimate
from verbteach.experiments.off_policy.trajectories import Log

MINIMUM = 30.0
"""The effective sample size below which nothing is estimated. In simulated logs 95 % intervals
held the truth .93 to .99 of the time above it, .90 to .94 between 15 and 30, down to .81 below."""

OUTSIDE = 0.01
"""The share of the evaluated policy's dialogues that may leave what was logged."""


class UnsupportedLogError(ValueError):
    """The log does not hold what the evaluation needs; the message says what and why."""


@dataclass(frozen=True)
class Evaluation:
    """What a log says of a policy.

    ``logged`` is the mean return of the policy that was logged. Where the
    effective sample size is too small, ``declined`` says so and there are no
    estimates.
    """

    trajectories: int
    groups: int
    effective_size: float
    mean_weight: float
    logged: float
    estimates: tuple[Estimate, ...]
    declined: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, as the command line prints it."""
        return {
            "trajectories": self.trajectories,
            "people": self.groups,
            "effective_sample_size": self.effective_size,
            "mean_weight": self.mean_weight,
            "logged_return": self.logged,
            "declined": self.declined or None,
            "estimates": {one.name: one.to_json() for one in self.estimates},
        }


def evaluate(
    log: Log,
    rng: np.random.Generator,
    minimum: float = MINIMUM,
    resamples: int = RESAMPLES,
) -> Evaluation:
    """Estimate the evaluated policy's mean return. Raises :class:`UnsupportedLogError`."""
    check_support(log)
    size = log.effective_size
    declined = "" if size >= minimum else _too_small(size, minimum, len(log))
    found = () if declined else estimators(log)
    estimates = [estimate(one, log.groups, rng, resamples) for one in found]
    return Evaluation(
        len(log),
        int(log.groups.max()) + 1,
        size,
        log.mean_weight,
        float(log.returns.mean()),
        _doubted(estimates),
        declined,
    )


def _doubted(estimates: Sequence[Estimate]) -> tuple[Estimate, ...]:
    """Fitted Q's interval, widened to hold the doubly robust one.

    Its own knows the sampling error and not what the features leave out: with
    features that leave out what matters it held the truth in none of 200 logs.
    """
    robust = {one.name: one.ci95 for one in estimates}.get(DoublyRobust.name)
    return tuple(
        replace(one, ci95=_hull(one.ci95, robust)) if robust and one.name == FittedQ.name else one
        for one in estimates
    )


def _hull(one: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    return min(one[0], other[0]), max(one[1], other[1])


def check_support(log: Log) -> None:
    """Raise :class:`UnsupportedLogError` where the log cannot tell about the evaluated policy.

    That is where a propensity is no probability, and where the logged policy
    took its act for certain though the evaluated one might take another, in
    more than ``OUTSIDE`` of the dialogues that the evaluated one would have.
    """
    if not log.trajectories:
        raise UnsupportedLogError("there is no choice in the log")
    choices = [choice for one in log.trajectories for choice in one.choices]
    if not all(0.0 < choice.propensity <= 1.0 for choice in choices):
        raise UnsupportedLogError(
            "a propensity is missing or no probability above 0: the log does not say how likely"
            " the logged policy was to do what it did"
        )
    if log.outside > OUTSIDE:
        raise UnsupportedLogError(
            f"in {log.outside:.0%} of its dialogues the evaluated policy would do what the logged"
            " one, which took its act for certain, never does; what would have come of it is in no"
            " log: record sessions with a policy that explores, such as random"
        )


def _too_small(size: float, minimum: float, trajectories: int) -> str:
    if trajectories < minimum:
        return (
            f"{trajectories} dialogues are too few to say anything:"
            f" at least {minimum:g} are needed, and more where the two policies differ"
        )
    return (
        f"the {trajectories} trajectories are worth {size:.1f} of the evaluated policy's own,"
        f" fewer than {minimum:g}: the two policies act too differently to say"
    )
