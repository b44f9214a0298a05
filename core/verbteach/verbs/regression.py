"""The fitted criterion: how much each demonstration's vote for a goal counts.

She & Chai (2016) fit a regression on a development fifth of the training
clauses and sum its scores over the goals of a plan; there many small goals
outvote a good one. Here a vote counts exp(weights . features), a plan's share
is its votes' share of all votes, and the weights are those whose shares expect
the best SJI on the development commands: adding a vote to one plan takes from
the others. Each command weighs the same, however many goals it has.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import exp
from operator import mul
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.application import Evidence
from verbteach.verbs.features import NAMES, votes
from verbteach.verbs.poll import Poll

_Array = NDArray[np.float64]


class Judged(NamedTuple):
    """The votes of a development command with the SJI that their goals came to.

    ``features`` are votes x ``NAMES``; ``voters`` are the demonstrations' ids.
    """

    features: _Array
    probabilities: _Array
    rewards: _Array
    voters: tuple[str, ...]

    @classmethod
    def of(cls, poll: Poll, rewards: Mapping[int, float]) -> Judged:
        """The votes for the goals with a reward, given by number, goal by goal in their order."""
        place = np.full(len(poll.goals), len(rewards))
        place[list(rewards)] = range(len(rewards))
        places = place[poll.goals_of]
        votes = np.argsort(places, kind="stable")[: np.count_nonzero(places < len(rewards))]
        return cls(
            poll.features[votes],
            poll.chances[votes],
            np.array(list(rewards.values()))[places[votes]],
            tuple([poll.uses[vote].demonstration.id for vote in votes.tolist()]),
        )

    def among(self, voters: Container[str]) -> Judged:
        """The votes of these demonstrations only."""
        asked = [index for index, voter in enumerate(self.voters) if voter in voters]
        if len(asked) == len(self.voters):
            return self
        own = tuple([self.voters[index] for index in asked])
        return Judged(self.features[asked], self.probabilities[asked], self.rewards[asked], own)


@dataclass(frozen=True)
class FittingParameters:
    """``ridge`` penalises squared weights, against a mean SJI; the ascent is Adam's."""

    ridge: float = 0.02
    steps: int = 100
    rate: float = 0.1


@dataclass(frozen=True)
class Regression:
    """Weights for ``NAMES``; all zero is the same as most frequent."""

    weights: tuple[float, ...] = (0.0,) * len(NAMES)
    name: str = "regression"

    def score(self, evidence: Evidence) -> float:
        """The goal's votes, each with its weight."""
        return sum(v.probability * exp(_dot(self.weights, v.features)) for v in votes(evidence))

    def tally(self, poll: Poll) -> _Array:
        """Every goal's score; the same as ``score`` one by one."""
        heights = np.zeros(len(poll.uses))
        # Feature by feature, and the platform's exp: digits hang on no processor's vectors.
        for weight, feature in zip(self.weights, poll.features.T, strict=True):
            heights += weight * feature
        counts = np.array([exp(height) for height in heights.tolist()])
        return poll.by_goal(poll.chances * counts)

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, weights by feature."""
        return {"weights": dict(zip(NAMES, self.weights, strict=True))}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Regression:
        """Read weights; raise ``ValueError`` unless they are for exactly the features known."""
        weights = data.get("weights")
        if not isinstance(weights, Mapping) or set(weights) != set(NAMES):
            raise ValueError(f"weights are needed for exactly these features: {', '.join(NAMES)}")
        return cls(tuple(float(weights[name]) for name in NAMES))


def fit(commands: Sequence[Judged], parameters: FittingParameters | None = None) -> Regression:
    """Fit to the votes of development commands, of goals that have a plan.

    Commands whose votes all came to the same say nothing and are left out.
    """
    telling = [judged for judged in commands if len(set(judged.rewards.tolist())) > 1]
    if not telling:
        return Regression()
    weights = _Development(telling).ascend(parameters or FittingParameters())
    return Regression(tuple(round(float(weight), 6) for weight in weights))


class _Development:
    """The development votes as arrays; sums are numpy's own, so that threads change nothing."""

    def __init__(self, commands: Sequence[Judged]) -> None:
        self.features: _Array = np.concatenate([judged.features for judged in commands])
        self.offsets: _Array = np.log(np.concatenate([j.probabilities for j in commands]))
        self.rewards: _Array = np.concatenate([judged.rewards for judged in commands])
        lengths = [len(judged.rewards) for judged in commands]
        self.starts = np.cumsum([0, *lengths[:-1]])
        self.lengths = np.array(lengths)

    def ascend(self, parameters: FittingParameters) -> _Array:
        """Adam's ascent from zero, a fixed number of steps."""
        weights = np.zeros(len(NAMES))
        mean, square = np.zeros_like(weights), np.zeros_like(weights)
        for step in range(1, parameters.steps + 1):
            slope = self._slope(weights) - 2 * parameters.ridge * weights
            mean, square = 0.9 * mean + 0.1 * slope, 0.999 * square + 0.001 * slope**2
            steep = np.sqrt(square / (1 - 0.999**step)) + 1e-8
            weights = weights + parameters.rate * (mean / (1 - 0.9**step)) / steep
        return weights

    def _slope(self, weights: _Array) -> _Array:
        """The gradient of the expected SJI, averaged over commands."""
        heights = np.einsum("ij,j->i", self.features, weights) + self.offsets
        highest = np.maximum.reduceat(heights, self.starts)
        masses = np.exp(heights - np.repeat(highest, self.lengths))
        shares = masses / np.repeat(np.add.reduceat(masses, self.starts), self.lengths)
        expected = np.add.reduceat(shares * self.rewards, self.starts)
        pull = shares * (self.rewards - np.repeat(expected, self.lengths))
        slope: _Array = np.einsum("ij,i->j", self.features, pull) / len(self.lengths)
        return slope


def _dot(weights: tuple[float, ...], features: tuple[float, ...]) -> float:
    products: Iterable[float] = map(mul, weights, features)
    return sum(products)
