"""Three estimators of a policy's value from another policy's log, one a class.

Each takes the weight that every trajectory has in the sample (how often a
bootstrap drew it) and answers with the value and with each trajectory's
influence on it, from which the standard error follows.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from verbteach.experiments.off_policy.trajectories import Floats, Log

RIDGE = 1e-3
FOLDS = 5


class Valued(NamedTuple):
    """A value, and how far each trajectory pulls it: influences average 0 over the sample."""

    value: float
    influence: Floats


class Estimator(Protocol):
    """Estimates one log's value under the evaluated policy."""

    @property
    def name(self) -> str:
        """The estimator's name, as the command line prints it."""
        ...

    def __call__(self, counts: Floats) -> Valued:
        """The value where trajectory ``i`` counts ``counts[i]`` times."""
        ...


class ImportanceSampling:
    """Per-decision weighted importance sampling (Precup, Sutton & Singh 2000).

    Each step's rewards are averaged with the product of the ratios up to it.
    Needs no model; biased for few trajectories, consistent for many.
    """

    name = "weighted_importance_sampling"

    def __init__(self, log: Log) -> None:
        self._log = log

    def __call__(self, counts: Floats) -> Valued:
        """Average each step by its weights, and add the steps up."""
        log = self._log
        means, shares = _averages(log.weights, log.rewards, counts)
        pulls = (shares * (log.rewards - means)) @ log.discounts
        return Valued(float(means @ log.discounts), pulls)


class FittedQ:
    """Fitted Q evaluation with a linear Q, iterated to its fixed point (Le et al. 2019; LSTD-Q).

    Needs no propensities; as good as the features are.
    """

    name = "fitted_q"

    def __init__(self, log: Log) -> None:
        self._systems, self._targets = _systems(log)
        self._first = np.array([one.choices[0].expected for one in log.trajectories])

    def __call__(self, counts: Floats) -> Valued:
        """Solve for the weights, and average the first states' values."""
        total = float(counts.sum())
        matrix = _ridged(np.tensordot(counts, self._systems, 1) / total)
        theta = np.linalg.solve(matrix, counts @ self._targets / total)
        values = self._first @ theta
        value = float(counts @ values) / total
        errors = self._targets - self._systems @ theta
        lever = np.linalg.solve(matrix.T, counts @ self._first / total)
        return Valued(value, values - value + errors @ lever)


class DoublyRobust:
    """Weighted doubly robust evaluation (Jiang & Li 2016; Thomas & Brunskill 2016).

    A fitted Q, and importance sampling of what it gets wrong: right in the
    limit if either the features or the propensities are. A trajectory's Q is
    fitted to the other groups' trajectories only.
    """

    name = "doubly_robust"

    def __init__(self, log: Log, folds: int = FOLDS) -> None:
        self._log = log
        taken, expected = _crossfitted(log, folds)
        self._surprise = log.rewards - taken
        self._expected = expected
        ahead = np.ones_like(log.weights)
        ahead[:, 1:] = log.weights[:, :-1]
        self._before = ahead

    def __call__(self, counts: Floats) -> Valued:
        """Q's value of the first state, and the weighted surprises of each step."""
        log = self._log
        surprises, shares = _averages(log.weights, self._surprise, counts)
        values, earlier = _averages(self._before, self._expected, counts)
        pulls = shares * (self._surprise - surprises) + earlier * (self._expected - values)
        return Valued(float((surprises + values) @ log.discounts), pulls @ log.discounts)


def estimators(log: Log) -> tuple[Estimator, ...]:
    """All three, for one log."""
    return ImportanceSampling(log), FittedQ(log), DoublyRobust(log)


def _averages(weights: Floats, values: Floats, counts: Floats) -> tuple[Floats, Floats]:
    """Each step's weighted mean, and each trajectory's weight relative to the mean weight."""
    total = counts @ weights
    safe = np.where(total > 0.0, total, 1.0)
    shares = weights * (counts.sum() / safe)
    return np.asarray(counts @ (weights * values) / safe), np.asarray(shares)


def _systems(log: Log) -> tuple[Floats, Floats]:
    """Each trajectory's part of LSTD-Q: sum of phi (phi - gamma phi')^T, and of phi r."""
    size = log.trajectories[0].choices[0].features.shape[1]
    matrices = np.zeros((len(log), size, size))
    targets = np.zeros((len(log), size))
    for place, one in enumerate(log.trajectories):
        taken = np.array([choice.taken for choice in one.choices])
        ahead = np.zeros_like(taken)
        for step, choice in enumerate(one.choices[1:]):
            ahead[step] = choice.expected
        matrices[place] = taken.T @ (taken - log.gamma * ahead)
        targets[place] = [choice.reward for choice in one.choices] @ taken
    return matrices, targets


def _ridged(matrix: Floats) -> Floats:
    return matrix + RIDGE * np.eye(len(matrix))


def _crossfitted(log: Log, folds: int) -> tuple[Floats, Floats]:
    """Q of the acts taken and V of the states met, trajectories x steps, 0 after the end."""
    systems, targets = _systems(log)
    taken, expected = np.zeros_like(log.rewards), np.zeros_like(log.rewards)
    for inside in _folds(log.groups, folds):
        others = ~inside if not inside.all() else inside
        matrix = _ridged(systems[others].mean(axis=0))
        theta = np.linalg.solve(matrix, targets[others].mean(axis=0))
        for place in np.flatnonzero(inside).tolist():
            choices = log.trajectories[place].choices
            taken[place, : len(choices)] = _valued([c.taken for c in choices], theta)
            expected[place, : len(choices)] = _valued([c.expected for c in choices], theta)
    return taken, expected


def _valued(features: Sequence[Floats], theta: Floats) -> Floats:
    return np.asarray(np.array(features) @ theta)


def _folds(groups: NDArray[np.int64], folds: int) -> Sequence[NDArray[np.bool_]]:
    """Which trajectories are in each fold; a group is never torn."""
    number = groups % max(1, min(folds, int(groups.max()) + 1))
    return [number == fold for fold in sorted(set(number.tolist()))]
