"""What the lab can be asked to do, as values that travel to the worker and into the results."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

TRAIN, COMPARE = "train", "compare"
KINDS = (TRAIN, COMPARE)
POLICIES = ("silent", "random", "split", "manual", "rl")
DIALOGUES = (100, 300, 600, 1100)
ROOMS: Mapping[str, tuple[str, ...]] = {
    "two rooms": ("kitchen-6", "living-room-6"),
    "four rooms": ("kitchen-5", "kitchen-6", "living-room-5", "living-room-6"),
}
SEEDS = tuple(range(10))


@dataclass(frozen=True)
class Job:
    """Train the two policies on the bundled lessons, or compare policies on some of them.

    ``dialogues`` are held to train each phase's policy. To compare, the rooms
    ``held_out`` are tested in and nothing is learned from them; ``share`` of the
    other lessons teach verbs.
    """

    kind: str = TRAIN
    noise: str = "std3"
    dialogues: int = 300
    seed: int = 0
    policies: tuple[str, ...] = POLICIES
    held_out: tuple[str, ...] = ROOMS["two rooms"]
    share: float = 0.5

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        return {**asdict(self), "policies": list(self.policies), "held_out": list(self.held_out)}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Job:
        """Read what :meth:`to_json` wrote."""
        lists = {name: tuple(data[name]) for name in ("policies", "held_out")}
        return cls(**{**data, **lists})
