"""What questions cost and what success earns: the reward column of Table 2."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Rewards:
    """Prices by act name as (answered yes, answered otherwise); She & Chai (2017), Table 2."""

    prices: Mapping[str, tuple[float, float]] = field(
        default_factory=lambda: {
            "np_grd_whq": (-6.5, -6.5),
            "np_grd_ynq": (-1.0, -2.0),
            "env_pred_ynq": (-1.0, -2.0),
            "goal_pred_ynq": (-1.0, -2.0),
            "select_hypo": (100.0, -2.0),
            "bulk_np_grd_ynq": (-3.0, -6.0),
            "pred_change_ynq": (-1.0, -2.0),
            "include_fluent": (100.0, -2.0),
            "goal_relevant_ynq": (-1.0, -2.0),
        }
    )

    def of(self, act_name: str, *, positive: bool) -> float:
        """The reward of an act, given whether it was answered with yes; 0 for unpriced acts."""
        yes, otherwise = self.prices.get(act_name, (0.0, 0.0))
        return yes if positive else otherwise
