"""The gold sequence of an instance: what a plan's actions are compared with.

One change can be brought about in many orders, and a demonstrator's is as good
as the planner's. So where the planner reaches the whole change with as many
actions as the demonstration has, its order stands for both (She & Chai 2016).
"""

from __future__ import annotations

from verbteach.verbs.change import StateChange
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import satisfied
from verbteach.world.plan import Action, Plan, Planner
from verbteach.world.simulator import run
from verbteach.world.task import Task


def whole_change(instance: Instance, task: Task) -> StateChange:
    """Return everything that the demonstration changed."""
    return StateChange.between(instance.start, instance.end, task.domain.static)


def gold_sequence(instance: Instance, task: Task, planner: Planner) -> tuple[Action, ...]:
    """Return the planner's sequence where it is as long as the demonstration, else that one."""
    change = whole_change(instance, task).literals
    answer = planner.plan(instance.start, change)
    if not isinstance(answer, Plan) or len(answer.actions) != len(instance.gold):
        return instance.gold
    reached = satisfied(change, run(task, instance.start, answer.actions)[-1])
    return answer.actions if reached else instance.gold
