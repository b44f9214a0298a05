"""A figure over runs: mean, deviation and an interval that knows where the numbers come from.

Instances of one document are alike and runs differ by their draws, so the
interval resamples runs and, within each, documents (a two-level bootstrap).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

_Table: TypeAlias = NDArray[np.float64]


class Observation(NamedTuple):
    """One instance's value and the document it belongs to."""

    group: str
    value: float


@dataclass(frozen=True)
class Figure:
    """Mean over instances and runs; ``sd`` over the runs' means (0 for one run)."""

    mean: float
    sd: float
    ci95: tuple[float, float]
    runs: int

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, as the command line prints it."""
        return {"mean": self.mean, "sd": self.sd, "ci95": list(self.ci95), "runs": self.runs}


def figure(
    runs: Sequence[Sequence[Observation]], rng: np.random.Generator, resamples: int = 2000
) -> Figure:
    """Summarise the runs' observations. Raises ``ValueError`` where there is none."""
    if not runs or not all(runs):
        raise ValueError("a figure needs at least one run, and each run an observation")
    tables = [_by_group(run) for run in runs]
    means = np.array([sums.sum() / counts.sum() for sums, counts in tables])
    low, high = np.quantile(_resampled(tables, rng, resamples), [0.025, 0.975])
    sd = float(means.std(ddof=1)) if len(means) > 1 else 0.0
    return Figure(float(means.mean()), sd, (float(low), float(high)), len(runs))


def constant(value: float, runs: int) -> Figure:
    """A figure that is the same in every run by construction."""
    return Figure(value, 0.0, (value, value), runs)


def paired(
    runs: Sequence[Sequence[Observation]],
    others: Sequence[Sequence[Observation]],
    rng: np.random.Generator,
    resamples: int = 2000,
) -> Figure:
    """Summarise the differences ``runs`` - ``others``, instance by instance."""
    differences = [
        [Observation(a.group, a.value - b.value) for a, b in zip(one, other, strict=True)]
        for one, other in zip(runs, others, strict=True)
    ]
    return figure(differences, rng, resamples)


def _by_group(run: Sequence[Observation]) -> tuple[_Table, _Table]:
    """Each document's sum and count, by document."""
    index = {group: i for i, group in enumerate(sorted({one.group for one in run}))}
    sums, counts = np.zeros(len(index)), np.zeros(len(index))
    for group, value in run:
        sums[index[group]] += value
        counts[index[group]] += 1
    return sums, counts


def _resampled(
    tables: Sequence[tuple[_Table, _Table]], rng: np.random.Generator, resamples: int
) -> _Table:
    """The means of bootstrap samples: runs are drawn, and documents within each drawn run."""
    drawn = rng.integers(len(tables), size=(resamples, len(tables)))
    means = np.zeros(drawn.shape)
    for run, (sums, counts) in enumerate(tables):
        places = drawn == run
        documents = rng.integers(len(sums), size=(int(places.sum()), len(sums)))
        means[places] = sums[documents].sum(1) / counts[documents].sum(1)
    return np.asarray(means.mean(1))
