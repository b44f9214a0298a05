"""A room to work in: what can be done there, planned there and seen there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from verbteach.verbs.setting import Setting
from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action, Planner
from verbteach.world.simulator import applicable, apply, run
from verbteach.world.task import Task


@dataclass(frozen=True)
class Workroom:
    """A grounded task with its planner, and what the learner knows of the things in it."""

    task: Task
    planner: Planner
    setting: Setting

    @classmethod
    def of(cls, task: Task, planner: Planner) -> Workroom:
        """Furnish the room of a task."""
        return cls(task, planner, Setting.of_task(task))

    def outcome(self, state: State, actions: Sequence[Action]) -> State:
        """Where the actions lead, up to the first that cannot be done."""
        return run(self.task, state, actions)[-1]

    def one_step_away(self, state: State) -> frozenset[Fluent]:
        """What some action that can be done in ``state`` would make true."""
        after = (apply(self.task, state, action) for action in applicable(self.task, state))
        return frozenset(fluent for one in after for fluent in one - state)


Workrooms: TypeAlias = Mapping[str, Workroom]
"""Workrooms by ``Instance.task_key``."""

PlannerMaker: TypeAlias = Callable[[Task], Planner]


def furnish(tasks: Mapping[str, Task], planner: PlannerMaker) -> dict[str, Workroom]:
    """Make a workroom of each task, by key."""
    return {key: Workroom.of(tasks[key], planner(tasks[key])) for key in sorted(tasks)}
