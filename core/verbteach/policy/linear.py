"""Q(s, a) = theta . phi(s, a): named weights for one phase, and the policy that acts on them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue.decision import Candidate, Decision

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class FeatureSpace:
    """The features of a phase, in order."""

    names: tuple[str, ...]

    @cached_property
    def index(self) -> Mapping[str, int]:
        """Each name's place."""
        return {name: place for place, name in enumerate(self.names)}

    def matrix(self, candidates: Sequence[Candidate]) -> Floats:
        """Candidates x features. Raises ``KeyError`` for a feature that the phase does not have."""
        index = self.index
        found = np.zeros((len(candidates), len(self.names)))
        for row, candidate in enumerate(candidates):
            for name, value in candidate.features.items():
                found[row, index[name]] = value
        return found


@dataclass(frozen=True)
class Weights:
    """The weights of one phase, by feature name."""

    space: FeatureSpace
    values: tuple[float, ...]

    @classmethod
    def zero(cls, space: FeatureSpace) -> Weights:
        """What nothing has been learned into."""
        return cls(space, (0.0,) * len(space.names))

    @cached_property
    def vector(self) -> Floats:
        """The values as an array, in the features' order."""
        return np.array(self.values)

    def to_json(self) -> dict[str, float]:
        """Weights by name."""
        return dict(zip(self.space.names, self.values, strict=True))

    @classmethod
    def from_json(cls, space: FeatureSpace, data: Mapping[str, Any]) -> Weights:
        """Read weights; raise ``ValueError`` unless they are for exactly these features."""
        unknown = sorted(set(data) ^ set(space.names))
        if unknown:
            raise ValueError(f"the weights are for other features: {', '.join(unknown)}")
        return cls(space, tuple(float(data[name]) for name in space.names))


@dataclass(frozen=True)
class LinearPolicy:
    """Takes the act with the highest Q, or with probability ``epsilon`` any."""

    weights: Weights
    epsilon: float = 0.0
    name: str = "rl"
    asks: ClassVar[bool] = True

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Choose; the decision holds every act's Q and the chosen one's propensity."""
        values = self.weights.space.matrix(candidates) @ self.weights.vector
        best = int(values.argmax())
        explored = bool(self.epsilon) and rng.random() < self.epsilon
        chosen = int(rng.integers(len(candidates))) if explored else best
        even = self.epsilon / len(candidates)
        valued = tuple(
            Candidate(one.act, one.features, value, one.shares)
            for one, value in zip(candidates, values.tolist(), strict=True)
        )
        propensity = even + (1.0 - self.epsilon) * (chosen == best)
        return Decision(valued, chosen, propensity, explored and chosen != best)
