"""Logged choices as arrays: what was offered, taken and earned, and what the other policy would do.

A trajectory is one phase of one dialogue under the policy that was logged. It
knows nothing of acts, sessions or files.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Choice:
    """One choice among candidates.

    ``features``: candidates x features. ``chosen`` is the row taken,
    ``propensity`` its probability under the policy that was logged, ``reward``
    what was earned until the next choice, ``target`` the evaluated policy's
    probability of each candidate.
    """

    features: Floats
    chosen: int
    propensity: float
    reward: float
    target: Floats

    @property
    def ratio(self) -> float:
        """How much likelier the evaluated policy takes the act that was taken."""
        return float(self.target[self.chosen]) / self.propensity

    @cached_property
    def taken(self) -> Floats:
        """The features of the act taken."""
        return np.asarray(self.features[self.chosen])

    @cached_property
    def expected(self) -> Floats:
        """The features expected under the evaluated policy."""
        return np.asarray(self.target @ self.features)


@dataclass(frozen=True)
class Trajectory:
    """Choices from a phase's first to its last, at least one; ``group`` names the person."""

    choices: tuple[Choice, ...]
    group: str = ""


@dataclass(frozen=True)
class Log:
    """Trajectories as tables of trajectories x steps; beyond a trajectory's end nothing happens.

    ``gamma`` is the discount by step.
    """

    trajectories: tuple[Trajectory, ...]
    gamma: float = 0.99

    def __len__(self) -> int:
        return len(self.trajectories)

    @property
    def horizon(self) -> int:
        """The length of the longest trajectory, in choices."""
        return max(len(one.choices) for one in self.trajectories)

    @cached_property
    def discounts(self) -> Floats:
        """What a reward counts, by step: ``gamma ** t``."""
        return np.asarray(self.gamma ** np.arange(self.horizon))

    @cached_property
    def rewards(self) -> Floats:
        """Trajectories x steps; 0 after the end."""
        return self._table([[c.reward for c in one.choices] for one in self.trajectories], 0.0)

    @cached_property
    def weights(self) -> Floats:
        """The product of the ratios up to and with each step; it stands still after the end."""
        ratios = [[c.ratio for c in one.choices] for one in self.trajectories]
        return np.asarray(np.cumprod(self._table(ratios, 1.0), axis=1))

    @cached_property
    def outside(self) -> float:
        """How likely the evaluated policy would leave what was logged.

        That is where the logged policy took its act for certain and the
        evaluated one takes another: what comes of that is in no log.
        """
        left = [[_leaving(c) for c in one.choices] for one in self.trajectories]
        before = np.ones_like(self.weights)
        before[:, 1:] = self.weights[:, :-1]
        return float((before * self._table(left, 0.0)).sum(axis=1).mean())

    @cached_property
    def returns(self) -> Floats:
        """What each trajectory earned, discounted."""
        return np.asarray(self.rewards @ self.discounts)

    @cached_property
    def groups(self) -> NDArray[np.int64]:
        """The number of each trajectory's group; a nameless one is a group of its own."""
        names = [one.group or f"\0{i}" for i, one in enumerate(self.trajectories)]
        number = {name: place for place, name in enumerate(sorted(set(names)))}
        return np.array([number[name] for name in names])

    @property
    def effective_size(self) -> float:
        """How many trajectories of the evaluated policy these are worth: (sum w)^2 / sum w^2."""
        last = self.weights[:, -1]
        squares = float(last @ last)
        return float(last.sum()) ** 2 / squares if squares > 0.0 else 0.0

    @property
    def mean_weight(self) -> float:
        """About 1 where the logged policy could take whatever the evaluated one would."""
        return float(self.weights[:, -1].mean())

    def _table(self, rows: Sequence[Sequence[float]], rest: float) -> Floats:
        table = np.full((len(rows), self.horizon), rest)
        for place, row in enumerate(rows):
            table[place, : len(row)] = row
        return table


def _leaving(choice: Choice) -> float:
    return 1.0 - float(choice.target[choice.chosen]) if choice.propensity == 1.0 else 0.0
