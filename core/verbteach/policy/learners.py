"""Learners of linear Q-values behind one interface: told of each step, they keep weights.

One algorithm a class: SARSA(0) is Algorithm 1 of She & Chai (2017); true-online
SARSA(lambda) is van Seijen et al. (2016); the Bayesian learner is Kalman
temporal differences (Geist & Pietquin 2010) and acts by Thompson sampling;
LSPI is Lagoudakis & Parr (2003), refitted from a log.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

GAMMA, EPSILON, ETA = 0.99, 0.1, 0.01
"""The paper's discount, exploration and learning rate (section 5.1)."""

REWARD_SCALE = 0.01
"""Learners see rewards in hundreds, so that success is worth 1; it changes no policy."""


class Step(NamedTuple):
    """What was done and what came of it; ``following`` holds every next act's features."""

    taken: Floats
    reward: float
    following: Floats | None
    """Next candidates x features; none where the phase ended."""
    next_index: int = 0
    """Which of ``following`` was taken next."""
    situation: int = 0
    """Which of the situations practised on this was."""

    @property
    def next_taken(self) -> Floats | None:
        """The features of the act taken next."""
        return None if self.following is None else self.following[self.next_index]


class Learner(Protocol):
    """Learns from one step at a time."""

    @property
    def weights(self) -> Floats:
        """The weights as they are now."""
        ...

    def begin(self) -> None:
        """A dialogue begins."""
        ...

    def acting(self, rng: np.random.Generator) -> Floats:
        """The weights to act on in this dialogue."""
        ...

    def learn(self, step: Step) -> None:
        """Take one step in."""
        ...


@dataclass
class Sarsa:
    """SARSA(0), Algorithm 1: theta += eta * delta * phi."""

    size: int
    gamma: float = GAMMA
    rate: float = ETA

    def __post_init__(self) -> None:
        self.weights: Floats = np.zeros(self.size)

    def begin(self) -> None:
        """Nothing is carried over within a dialogue."""

    def acting(self, rng: np.random.Generator) -> Floats:
        """The weights themselves."""
        return self.weights

    def learn(self, step: Step) -> None:
        """Move towards the reward and what follows."""
        following = step.next_taken
        ahead = 0.0 if following is None else float(self.weights @ following)
        delta = step.reward + self.gamma * ahead - float(self.weights @ step.taken)
        self.weights = self.weights + self.rate * delta * step.taken


@dataclass
class TrueOnlineSarsa:
    """True-online SARSA(lambda) with a Dutch trace; the step size shrinks with the features' norm.

    ``rate`` is divided by the squared norm of the features' running mean, so
    that phases with more features need no other setting.
    """

    size: int
    gamma: float = GAMMA
    rate: float = 0.05
    decay: float = 0.9

    def __post_init__(self) -> None:
        self.weights: Floats = np.zeros(self.size)
        self.begin()

    def begin(self) -> None:
        """Forget the trace."""
        self._trace: Floats = np.zeros(self.size)
        self._old = 0.0

    def acting(self, rng: np.random.Generator) -> Floats:
        """The weights themselves."""
        return self.weights

    def learn(self, step: Step) -> None:
        """One update of van Seijen et al.'s algorithm."""
        taken, following = step.taken, step.next_taken
        rate = self.rate / max(1.0, float(taken @ taken))
        now = float(self.weights @ taken)
        ahead = 0.0 if following is None else float(self.weights @ following)
        delta = step.reward + self.gamma * ahead - now
        shrink = self.gamma * self.decay
        overlap = 1.0 - rate * shrink * float(self._trace @ taken)
        self._trace = shrink * self._trace + overlap * taken
        change = now - self._old
        self.weights = self.weights + rate * (delta + change) * self._trace - rate * change * taken
        self._old = ahead


@dataclass
class BayesianTD:
    """A Gaussian over weights, updated by Kalman temporal differences; acts on a sample of it.

    ``prior`` is the weights' variance to begin with, ``noise`` that of a
    one-step return, ``drift`` what is added at each step so that it can forget.
    ``thompson`` off acts on the mean.
    """

    size: int
    gamma: float = GAMMA
    prior: float = 1.0
    noise: float = 0.2
    drift: float = 0.0
    thompson: bool = True

    def __post_init__(self) -> None:
        self.weights: Floats = np.zeros(self.size)
        self.covariance: Floats = self.prior * np.eye(self.size)

    def begin(self) -> None:
        """Nothing is carried over within a dialogue."""

    def acting(self, rng: np.random.Generator) -> Floats:
        """A draw of the weights, by Thompson."""
        if not self.thompson:
            return self.weights
        root = np.linalg.cholesky(self.covariance + 1e-9 * np.eye(self.size))
        return np.asarray(self.weights + root @ rng.standard_normal(self.size))

    def learn(self, step: Step) -> None:
        """Condition on reward = (phi - gamma * phi') . theta + noise."""
        following = step.next_taken
        seen = step.taken if following is None else step.taken - self.gamma * following
        self.covariance = self.covariance + self.drift * np.eye(self.size)
        spread = self.covariance @ seen
        gain = spread / (float(seen @ spread) + self.noise)
        self.weights = self.weights + gain * (step.reward - float(seen @ self.weights))
        self.covariance = self.covariance - np.outer(gain, spread)
        self.covariance = 0.5 * (self.covariance + self.covariance.T)


def lspi(
    log: Sequence[Step],
    size: int,
    gamma: float = GAMMA,
    ridge: float = 0.0035,
    rounds: int = 20,
    situations: int = 0,
) -> Floats:
    """Refit weights from a log of steps, whoever acted: least-squares policy iteration.

    Each round evaluates the policy that is greedy for the last round's weights;
    it ends early when the weights stand still. ``ridge`` counts for each step of
    the log: a few hundred commands say little about two dozen weights, and
    hold more for new commands when they are held back. With ``situations`` each of them
    has a level of its own, that is fitted and then forgotten: how hard a
    command is says nothing about what to do, and is most of the variance.
    """
    weights = np.zeros(size + situations)
    taken = np.array([_levelled(step.taken, step, situations) for step in log])
    taken = taken.reshape(-1, size + situations)
    rewards = np.array([step.reward for step in log])
    held_back = ridge * len(log) * np.eye(len(weights))
    for _ in range(rounds):
        greedy = np.array([_greedy(step, weights[:size], situations) for step in log])
        matrix = taken.T @ (taken - gamma * greedy.reshape(taken.shape))
        new = np.linalg.solve(matrix + held_back, taken.T @ rewards)
        if np.abs(new - weights).max() < 1e-6:
            return np.asarray(new[:size])
        weights = new
    return np.asarray(weights[:size])


def _greedy(step: Step, weights: Floats, situations: int) -> Floats:
    if step.following is None:
        return np.zeros(len(weights) + situations)
    best = step.following[int((step.following @ weights).argmax())]
    return _levelled(best, step, situations)


def _levelled(features: Floats, step: Step, situations: int) -> Floats:
    """The features with the mark of their situation."""
    if not situations:
        return features
    return np.concatenate([features, np.arange(situations) == step.situation])
