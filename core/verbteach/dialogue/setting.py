"""What the robot needs to be somewhere: the scene, its grounded task, a planner and the words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

from verbteach.language.agreement import SecondReader
from verbteach.language.lexicon import Lexicon
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.plan import Planner
from verbteach.world.scene import Scene
from verbteach.world.task import Task


class UnknownSceneError(LookupError):
    """No scene has this name; the message lists those that there are."""


class UnknownObjectError(LookupError):
    """No object of the scene has this id; the message says which are near it."""


@dataclass(frozen=True)
class Setting:
    """A scene made ready: grounded once, with the planner that works on it.

    With a ``second`` reader the robot asks before it acts on a command that the
    two read differently.
    """

    scene: Scene
    task: Task
    planner: Planner
    lexicon: Lexicon
    second: SecondReader | None = None

    @cached_property
    def vocabulary(self) -> tuple[str, ...]:
        """The nouns for what is in the scene, sorted."""
        return tuple(sorted({n for thing in self.scene.objects.values() for n in thing.names}))

    @cached_property
    def surroundings(self) -> Surroundings:
        """What the verb learner knows of the scene."""
        return Surroundings.of_task(self.task)


# Raises UnknownSceneError. Handed to the robot, which opens no file itself.
Settings: TypeAlias = Callable[[str], Setting]
