"""How a rate is spread over people, from few answers of each: Beta-Bernoulli with shrinkage.

The Beta is the most probable one under the beta-binomial likelihood of all
people's counts and a weak prior, so that a rate nobody showed is small but
never nothing, and a few people are not taken for all alike. A person's own
rate is then drawn towards the others' the more, the less they have answered.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from verbteach_sessions.people.population import Beta

Floats = NDArray[np.float64]


class Count(NamedTuple):
    """One person: did it ``times`` of ``of`` times."""

    times: int
    of: int


@dataclass(frozen=True)
class Prior:
    """What is thought before any answer.

    The mean rate has a Beta(``rare``, ``common``) density. The concentration
    a + b is log-normal around ``alike`` with ``spread`` in its logarithm.
    """

    rare: float = 1.25
    common: float = 2.0
    alike: float = 12.0
    spread: float = 1.0


def fit(counts: Sequence[Count], prior: Prior | None = None) -> Beta:
    """The most probable Beta; without counts the prior's. Searched on a grid, ever finer."""
    chosen = prior or Prior()
    tails = _tails(counts)
    centre, reach = np.array([-1.0, np.log(chosen.alike)]), np.array([6.0, 4.0])
    for _ in range(6):
        logits = centre[0] + reach[0] * _STEPS
        logs = centre[1] + reach[1] * _STEPS
        means, sizes = np.meshgrid(1.0 / (1.0 + np.exp(-logits)), np.exp(logs), indexing="ij")
        score = _likelihood(tails, means * sizes, (1.0 - means) * sizes)
        score += _prior(chosen, means, np.log(sizes))
        row, column = np.unravel_index(int(score.argmax()), score.shape)
        centre = np.array([logits[row], logs[column]])
        reach = reach / 4.0
    mean, size = float(1.0 / (1.0 + np.exp(-centre[0]))), float(np.exp(centre[1]))
    return Beta(mean * size, (1.0 - mean) * size)


_STEPS = np.linspace(-1.0, 1.0, 21)


def _tails(counts: Sequence[Count]) -> tuple[Floats, Floats, Floats]:
    """How many people did it, left it, and were asked, more than j times; by j."""
    did = [one.times for one in counts]
    left = [one.of - one.times for one in counts]
    return _above(did), _above(left), _above([one.of for one in counts])


def _above(values: Sequence[int]) -> Floats:
    found = np.zeros(max(values, default=0))
    for value in values:
        found[:value] += 1.0
    return found


def _likelihood(tails: tuple[Floats, Floats, Floats], a: Floats, b: Floats) -> Floats:
    """The log of the beta-binomial likelihood, as sums over rising factorials (Minka 2000)."""
    did, left, asked = tails
    return _rising(did, a) + _rising(left, b) - _rising(asked, a + b)


def _rising(tail: Floats, start: Floats) -> Floats:
    steps = np.arange(len(tail))
    return np.asarray(np.log(start[..., None] + steps) @ tail)


def _prior(prior: Prior, means: Floats, sizes: Floats) -> Floats:
    density = (prior.rare - 1.0) * np.log(means) + (prior.common - 1.0) * np.log1p(-means)
    away = (sizes - np.log(prior.alike)) / prior.spread
    return np.asarray(density - 0.5 * away**2)
