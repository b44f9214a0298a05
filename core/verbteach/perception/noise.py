"""How unreliable the robot's eyes are: the noise models of She & Chai (2017), section 5.1.

A true fluent is seen with a confidence drawn from N(1, s^2) on [0, 1]. The
paper leaves open what "on [0, 1]" means, what a false fluent gets, and whether
two states are seen independently; every reading is a parameter here.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
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
    def named(cls, noise: str, reading: str = "literal") -> NoiseModel:
        """What ``noise`` describes, in a reading of ``READINGS``. Raises ``ValueError``.

        ``std3``: a level of ``LEVELS``. ``0.2``: a spread. ``std3,on=perfect,open=0.1``:
        fluents of the kinds ``on`` and ``open`` are seen otherwise than the rest.
        ``literal``: truncated, false fluents at 0. ``phantom``: clipped, with phantoms.
        """
        level, *kinds = (part.strip() for part in noise.split(","))
        if reading not in READINGS:
            raise ValueError(f"no noise reading {reading!r}; there are {', '.join(READINGS)}")
        phantom = reading == "phantom"
        return cls(_spread(level), phantom, phantom, spreads=_spreads(kinds))

    def check_kinds(self, predicates: Collection[str]) -> None:
        """Raise ``ValueError`` where a spread is for no predicate of these."""
        for predicate in sorted(set(self.spreads) - set(predicates)):
            has = ", ".join(sorted(predicates))
            raise ValueError(
                f"noise of {predicate!r}: no such kind of fluent here; there are {has}"
            )

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


def _spread(text: str) -> float:
    """The spread of a level's name, or a number's."""
    if text in LEVELS:
        return LEVELS[text]
    levels = f"there are {', '.join(LEVELS)}, or a spread such as 0.2"
    try:
        spread = float(text)
    except ValueError:
        raise ValueError(f"no noise level {text!r}; {levels}") from None
    if math.isnan(spread) or spread < 0:
        raise ValueError(f"noise {text}: a spread is 0 or more; {levels}")
    return spread


def _spreads(kinds: Sequence[str]) -> dict[str, float]:
    """The spread of each kind of fluent, of parts like ``on=0.1``; the kinds in their order."""
    found: dict[str, float] = {}
    for part in kinds:
        predicate, equals, level = (piece.strip() for piece in part.partition("="))
        if not (predicate and equals):
            raise ValueError(f"noise {part!r}: a kind of fluent and its level are put as on=0.1")
        if predicate in found:
            raise ValueError(f"noise of {predicate!r} is given twice")
        found[predicate] = _spread(level)
    return dict(sorted(found.items()))


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
