"""How the robot chose an act: the candidates, their features and values, and the choice."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from verbteach.dialogue.acts import RobotAct


@dataclass(frozen=True)
class Candidate:
    """An act the robot could take, its named features and its value under the policy.

    ``value`` is Q(s, a) where the policy has one, else ``None``; ``shares`` are
    then the features' parts of it, weight times feature, which sum to it.
    """

    act: RobotAct
    features: Mapping[str, float]
    value: float | None = None
    shares: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Decision:
    """One choice. ``propensity`` is the chosen act's probability under the policy.

    ``weights`` is the digest of the weights that gave the values, where the policy has any.
    """

    candidates: tuple[Candidate, ...]
    chosen: int
    propensity: float = 1.0
    explored: bool = False
    reason: str = ""
    weights: str = ""

    @property
    def act(self) -> RobotAct:
        """The act chosen."""
        return self.candidates[self.chosen].act
