"""Which hypothesis a robot with a teacher prefers: the confirmed ones, then the most general.

She & Chai (2016) know no confirmation; without any this is their most general
criterion.
"""

from __future__ import annotations

from dataclasses import dataclass

from verbteach.verbs.application import Evidence, Support


@dataclass(frozen=True)
class Confirmed:
    """Each demonstration that kept nothing more general counts 1, each confirmation ``weight``.

    Confirmations are goals that a teacher read back as right, or executions of
    a goal that a teacher judged right. All count with the grounding's probability.
    """

    weight: float = 4.0
    name: str = "confirmed"

    def score(self, evidence: Evidence) -> float:
        """The weighted number of demonstrations and confirmations that speak for the goal."""
        return sum(self._worth(support) for support in evidence.supports)

    def _worth(self, support: Support) -> float:
        leaf = 0 if support.node.general else len(support.demonstrations)
        return support.probability * (leaf + self.weight * support.node.confirmed)
