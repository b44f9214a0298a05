"""How much of a plan a goal needs."""

from __future__ import annotations

from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Plan
from verbteach.world.refinement import EncodedGoal, without_needless
from verbteach.world.task import Task


def steps_needed(task: Task, state: State, plan: Plan, goal: Goal) -> int:
    """How many steps of ``plan``, run from ``state``, are left when those needless for ``goal`` go.

    The plan reaches the goal and is one of the task's. Plans nothing, and so is quick.
    """
    true = false = 0
    for fluent, positive in goal:
        bit = task.bit.get(fluent, 0)  # what no action touches needs no step
        true, false = (true | bit, false) if positive else (true, false | bit)
    steps = [ground for ground in map(task.action, plan.actions) if ground is not None]
    return len(without_needless(task.encode(state), steps, EncodedGoal(true, false)))
