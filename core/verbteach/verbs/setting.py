"""What the verb learner knows of a scene beside its state: its things and what never changes.

Things are the objects that a hypothesis abstracts; every other word in a
fluent (the robot, a value such as ``Water``) is a constant and stays itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from verbteach.world.scene import Scene


@dataclass(frozen=True)
class Setting:
    """``static`` predicates never change; ``affordances`` maps each thing to its affordance set."""

    static: frozenset[str] = frozenset()
    affordances: Mapping[str, frozenset[str]] = field(default_factory=dict)

    @classmethod
    def of(cls, scene: Scene) -> Setting:
        """Read a scene: its objects without the domain's constants are the things."""
        constants = scene.domain.constants
        things = sorted(o for o in scene.objects if o not in constants)
        return cls(scene.domain.static, {o: scene.affordances(o) for o in things})

    def alike(self, marks: frozenset[str]) -> tuple[str, ...]:
        """The things with exactly this affordance set, sorted."""
        return tuple(sorted(o for o, own in self.affordances.items() if own == marks))
