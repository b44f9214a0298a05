"""How unreliable the robot's eyes are: the noise models of She & Chai (2017), section 5.1.

A true fluent is seen with a confidence drawn from N(1, s^2) on [0, 1]. The
paper leaves open what "on [0, 1]" means, what a false fluent gets, and whether
two states are seen independently; every reading is a parameter here.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from statistics import NormalDist

import numpy as np

from verbteach.perception.belief import Belief, Exclusivity
from verbteach.world.fluents import Fluent, State

PERFECT, STD3, STD5, UNIFORM = 0.0, 0.3, 0.5, math.inf
LEVELS: Mapping[str, float] = {
    "perfect": PERFECT,
    "std3": STD3,
    "std5": STD5,
    "uniform": UNIFORM,
}
READINGS = ("literal", "phantom")


@dataclass(frozen=True)
class NoiseModel:
    """A sensor.

    ``spread`` is the s of N(1, s^2): 0 sees the truth, ``UNIFORM`` sees a
    uniform draw. ``spreads`` sets it apart for single predicates; 0 there for
    those that are known, such as what a thing affords.
    ``clipped`` draws are moved into [0, 1], otherwise they are drawn from the
    truncated distribution. With ``phantoms`` a false fluent that could be true
    is seen with one minus such a draw, otherwise with 0. With ``shared`` a
    fluent true in both of two states has one confidence in both (two looks at
    the same thing fail alike), otherwise the states are seen independently.
    """

    spread: float = PERFECT
    clipped: bool = False
    phantoms: bool = False
    shared: bool = False
    spreads: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for spread in (self.spread, *self.spreads.values()):
            if math.isnan(spread) or spread < 0:
                raise ValueError(f"a spread is 0 or more, not {spread}")

    @classmethod
    def named(cls, level: str, reading: str = "literal") -> NoiseModel:
        """A level of ``LEVELS`` in a reading of ``READINGS``. Raises ``ValueError`` for others.

        ``literal``: truncated, false fluents at 0. ``phantom``: clipped, with
        phantoms.
        """
        if level not in LEVELS:
            raise ValueError(f"no noise level {level!r}; there are {', '.join(LEVELS)}")
        if reading not in READINGS:
            raise ValueError(f"no noise reading {reading!r}; there are {', '.join(READINGS)}")
        phantom = reading == "phantom"
        return cls(LEVELS[level], clipped=phantom, phantoms=phantom)

    def with_spreads(self, spreads: Mapping[str, float]) -> NoiseModel:
        """The same sensor, with these predicates seen otherwise."""
        return replace(self, spreads={**self.spreads, **spreads})

    @property
    def exact(self) -> bool:
        """Whether everything is seen as it is."""
        return not any((self.spread, *self.spreads.values()))

    def confidence(self, predicate: str, uniform: float) -> float:
        """The confidence of a true fluent, from one uniform draw in [0, 1)."""
        spread = self.spreads.get(predicate, self.spread)
        if spread == PERFECT:
            return 1.0
        if math.isinf(spread):
            return uniform
        return _clipped(spread, uniform) if self.clipped else _truncated(spread, uniform)


def perceive(
    state: State,
    candidates: Iterable[Fluent],
    noise: NoiseModel,
    rng: np.random.Generator,
    exclusive: tuple[Exclusivity, ...] = (),
) -> Belief:
    """Look at ``state`` once.

    ``candidates`` are the fluents that could be true: phantoms come from
    these. One uniform draw is taken for each fluent, in the fluents' order,
    and none by eyes that see everything.
    """
    if noise.exact:
        return Belief.certain(state, exclusive)
    looked_at = sorted(state | frozenset(candidates) if noise.phantoms else state)
    draws = rng.random(len(looked_at)).tolist()
    seen = {}
    for fluent, uniform in zip(looked_at, draws, strict=True):
        confidence = noise.confidence(fluent.predicate, uniform)
        seen[fluent] = confidence if fluent in state else 1.0 - confidence
    return Belief.of(seen, exclusive)


def perceive_both(
    states: tuple[State, State],
    candidates: Iterable[Fluent],
    noise: NoiseModel,
    rng: np.random.Generator,
    exclusive: tuple[Exclusivity, ...] = (),
) -> tuple[Belief, Belief]:
    """Look before and after a demonstration, independently unless ``noise.shared``."""
    possible = frozenset(candidates)
    before, after = (perceive(state, possible, noise, rng, exclusive) for state in states)
    if not noise.shared:
        return before, after
    changed = states[0] ^ states[1]
    same = {fluent: c for fluent, c in before.items() if fluent not in changed}
    other = {fluent: c for fluent, c in after.items() if fluent in changed}
    return before, Belief.of({**same, **other}, exclusive)


def _clipped(spread: float, uniform: float) -> float:
    return min(1.0, max(0.0, _truncation(spread)[0].inv_cdf(_inside(uniform))))


def _truncated(spread: float, uniform: float) -> float:
    normal, low, high = _truncation(spread)
    drawn = normal.inv_cdf(_inside(low + uniform * (high - low)))
    return min(1.0, max(0.0, drawn))


@lru_cache(maxsize=64)
def _truncation(spread: float) -> tuple[NormalDist, float, float]:
    """The distribution, and what lies below 0 and below 1 of it: the same for every fluent."""
    normal = NormalDist(1.0, spread)
    return normal, normal.cdf(0.0), normal.cdf(1.0)


def _inside(probability: float) -> float:
    """The open interval that the inverse needs; 0 itself can be drawn."""
    return min(max(probability, 1e-300), 1.0 - 1e-16)
