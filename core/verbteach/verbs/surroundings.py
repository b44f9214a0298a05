"""What the verb learner knows of a scene beside its state: its things and what never changes.

Things are the objects that a hypothesis abstracts; every other word in a
fluent (the robot, a value such as ``Water``) is a constant and stays itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from verbteach.world.fluents import Literal, State
from verbteach.world.scene import Scene
from verbteach.world.task import Task


@dataclass(frozen=True)
class Surroundings:
    """``static`` predicates never change; ``affordances`` maps each thing to its affordance set.

    ``made`` and ``ended`` are the fluents that some action makes true or false;
    where they are not known, anything may change.
    """

    static: frozenset[str] = frozenset()
    affordances: Mapping[str, frozenset[str]] = field(default_factory=dict)
    made: State | None = field(default=None, compare=False)
    ended: State | None = field(default=None, compare=False)

    @classmethod
    def of(cls, scene: Scene) -> Surroundings:
        """Read a scene: its objects without the domain's constants are the things."""
        constants = scene.domain.constants
        things = sorted(o for o in scene.objects if o not in constants)
        return cls(scene.domain.static, {o: scene.affordances(o) for o in things})

    @classmethod
    def of_task(cls, task: Task) -> Surroundings:
        """Read a grounded task; equals the reading of a scene that it was grounded for."""
        constants = task.domain.constants
        things = {o: {type_} for o, type_ in sorted(task.objects.items()) if o not in constants}
        for predicate, args in sorted(task.static):
            if len(args) == 1 and args[0] in things:
                things[args[0]].add(predicate)
        marks = {o: frozenset(found) for o, found in things.items()}
        return cls(task.domain.static, marks, *task.changeable)

    def possible(self, literal: Literal) -> bool:
        """Whether some action could bring the literal about."""
        changes = self.made if literal.positive else self.ended
        return changes is None or literal.fluent in changes

    def alike(self, marks: frozenset[str]) -> tuple[str, ...]:
        """The things with exactly this affordance set, sorted."""
        return tuple(sorted(o for o, own in self.affordances.items() if own == marks))
