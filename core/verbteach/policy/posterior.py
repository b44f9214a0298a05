"""A Gaussian over one phase's weights, as a value: the learner of live sessions.

Kalman temporal differences (Geist & Pietquin 2010): each step says that
(phi - gamma phi') . theta is the reward, give or take noise. Sums are exact
(``math.fsum``) and run by name, so that equal steps give equal bits on every
machine.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Rows = tuple[tuple[float, ...], ...]


class Told(NamedTuple):
    """The posterior after one step, and how far the step was from what was expected."""

    posterior: Posterior
    delta: float


@dataclass(frozen=True)
class Posterior:
    """``mean`` and ``covariance`` (symmetric) of the weights of the features ``names``."""

    names: tuple[str, ...]
    mean: tuple[float, ...]
    covariance: Rows

    def __post_init__(self) -> None:
        size = len(self.names)
        square = len(self.covariance) == size and all(len(r) == size for r in self.covariance)
        if len(self.mean) != size or not square:
            raise ValueError("a posterior has a weight, a row and a column for each feature")
        if len(set(self.names)) != size:
            raise ValueError("a feature is named twice")

    @classmethod
    def of(cls, weights: Mapping[str, float], variance: float) -> Posterior:
        """Weights that are all equally unsure and independent."""
        names = tuple(weights)
        rows = tuple(tuple(variance * (one == other) for other in names) for one in names)
        return cls(names, tuple(weights.values()), rows)

    def spread(self, factor: float) -> Posterior:
        """The same weights, surer (``factor`` below 1) or less sure."""
        rows = tuple(tuple(factor * value for value in row) for row in self.covariance)
        return Posterior(self.names, self.mean, rows)

    @cached_property
    def weights(self) -> Mapping[str, float]:
        """The mean by feature."""
        return dict(zip(self.names, self.mean, strict=True))

    @cached_property
    def digest(self) -> str:
        """SHA-256 of names, mean and covariance."""
        parts = (self.names, self.mean, self.covariance)
        return sha256(repr(parts).encode()).hexdigest()

    def shares(self, features: Mapping[str, float]) -> dict[str, float]:
        """Each feature's part of Q, weight times feature; one without a weight has none."""
        weights = self.weights
        return {name: weights.get(name, 0.0) * features[name] for name in sorted(features)}

    def draws(self, count: int, rng: np.random.Generator) -> Floats:
        """Weights drawn at random (count x features), as deviations from the mean."""
        return rng.standard_normal((count, len(self.names))) @ self._root.T

    def rows(self, features: Mapping[str, float]) -> Floats:
        """The features as a vector."""
        return np.array([features.get(name, 0.0) for name in self.names])

    def told(self, seen: Mapping[str, float], reward: float, noise: float) -> Told:
        """Condition on ``seen`` . theta = ``reward`` with variance ``noise``."""
        index = self._index
        known = [(index[name], seen[name]) for name in sorted(seen) if name in index]
        along = [math.fsum(row[i] * value for i, value in known) for row in self.covariance]
        variance = math.fsum(along[i] * value for i, value in known) + noise
        delta = reward - math.fsum(self.mean[i] * value for i, value in known)
        mean = tuple(m + a / variance * delta for m, a in zip(self.mean, along, strict=True))
        rows = tuple(
            tuple(value - (one * other) / variance for value, other in zip(row, along, strict=True))
            for row, one in zip(self.covariance, along, strict=True)
        )
        return Told(Posterior(self.names, mean, rows), delta)

    @cached_property
    def _index(self) -> Mapping[str, int]:
        return {name: place for place, name in enumerate(self.names)}

    @cached_property
    def _root(self) -> Floats:
        jitter = 1e-12 * np.eye(len(self.names))
        return np.asarray(np.linalg.cholesky(np.array(self.covariance) + jitter), dtype=np.float64)
