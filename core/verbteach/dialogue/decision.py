"""How the robot chose an act: the candidates, their features and values, and the choice."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from verbteach.dialogue.acts import RobotAct


@dataclass(frozen=True)
class Candidate:
    """An act the robot could take, its named features and its value under the policy.

    ``value`` is Q(s, a) where the policy has one, else ``None``.
    """

    act: RobotAct
    features: Mapping[str, float]
    value: float | None = None


@dataclass(frozen=True)
class Decision:
    """One choice. ``propensity`` is the chosen act's probability under the policy."""

    candidates: tuple[Candidate, ...]
    chosen: int
    propensity: float = 1.0
    explored: bool = False
    reason: str = ""

    @property
    def act(self) -> RobotAct:
        """The act chosen."""
        return self.candidates[self.chosen].act
