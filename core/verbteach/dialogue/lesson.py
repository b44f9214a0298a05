"""A lesson: one command with how a teacher shows it and what it is meant to reach.

Demonstrations hold needless steps and by-products, so the goal is stated for
itself and is not just what the demonstration changed. Knows no file.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from verbteach.world.fluents import Goal
from verbteach.world.plan import Action


@dataclass(frozen=True)
class Lesson:
    """One thing to teach, starting from the scene as it is found.

    ``verb`` is the verb as a frame has it, its particle joined by a space.
    ``grounding`` maps each noun phrase, as the command says it and in that
    order, to the objects it means; several where it is plural. ``goal`` holds
    after ``demonstration``. ``teacher`` names the habit the demonstration
    follows; lessons of one teacher show things in one manner.
    """

    id: str
    scene: str
    command: str
    verb: str
    grounding: Mapping[str, tuple[str, ...]]
    demonstration: tuple[Action, ...]
    goal: Goal
    teacher: str = ""

    def __post_init__(self) -> None:
        if not self.demonstration:
            raise ValueError(f"{self.id}: a lesson shows at least one action")
        if not self.goal:
            raise ValueError(f"{self.id}: a lesson has a goal")
