"""Intervals for estimates from few and skewed trajectories: the studentised bootstrap.

Whole groups (people) are resampled. Each resample's error is measured in its
own standard error, so that the interval is wide on the side where a few heavy
weights hide (Hall 1988); plain percentiles were measured and cover too little.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verbteach.experiments.off_policy.estimators import Estimator, Valued
from verbteach.experiments.off_policy.trajectories import Floats

RESAMPLES = 400
LEVEL = 0.95


@dataclass(frozen=True)
class Estimate:
    """A policy's estimated return with its standard error and 95 % interval."""

    name: str
    value: float
    error: float
    ci95: tuple[float, float]

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        return {"value": self.value, "error": self.error, "ci95": list(self.ci95)}


def estimate(
    estimator: Estimator,
    groups: NDArray[np.int64],
    rng: np.random.Generator,
    resamples: int = RESAMPLES,
) -> Estimate:
    """The estimate on the whole log, with the interval from ``resamples`` resamples of groups."""
    valued = estimator(np.ones(len(groups)))
    error = standard_error(valued, groups, np.ones(len(groups)))
    number = int(groups.max()) + 1
    pulls = []
    for drawn in rng.integers(number, size=(resamples, number)):
        counts = np.bincount(drawn, minlength=number).astype(float)[groups]
        one = estimator(counts)
        spread = standard_error(one, groups, counts)
        if spread > 0.0:
            pulls.append((one.value - valued.value) / spread)
    tail = (1.0 - LEVEL) / 2.0
    low, high = np.quantile(pulls, [tail, 1.0 - tail]) if pulls else (0.0, 0.0)
    interval = (valued.value - float(high) * error, valued.value - float(low) * error)
    return Estimate(estimator.name, valued.value, error, interval)


def standard_error(valued: Valued, groups: NDArray[np.int64], counts: Floats) -> float:
    """The error of the mean influence where only groups are independent of each other."""
    sums = np.bincount(groups, weights=valued.influence)
    times = np.zeros(len(sums))
    times[groups] = counts
    drawn = float(times.sum())
    if drawn < 2.0 or counts.sum() <= 0.0:
        return 0.0
    variance = float(times @ sums**2) * drawn / (drawn - 1.0)
    return float(np.sqrt(variance)) / float(counts.sum())
