"""What a plan takes for granted: the fluents on whose truth at the start its course hangs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import TypeAlias

from verbteach.world.fluents import Fluent, Goal, State
from verbteach.world.plan import Action, Plan, Planner
from verbteach.world.task import Task

Foresight: TypeAlias = Callable[[State, Goal], frozenset[Fluent] | None]
"""Tells what the robot would take for granted if it pursued a goal from a state.

None where it cannot tell: it has no plan, or cannot plan.
"""


def taken_for_granted(task: Task, state: State, actions: Sequence[Action]) -> frozenset[Fluent]:
    """The fluents that the actions need, true or false, or bring about because they do not hold.

    What an action before has settled does not count. Conditions count where
    their effect comes about. Actions that the task does not have need nothing.
    """
    bits, touched, needed = task.encode(state), 0, 0
    for ground in filter(None, map(task.action, actions)):
        needs = ground.needs_true | ground.needs_false
        for when in ground.conditional:
            if bits & when.needs_true == when.needs_true and not bits & when.needs_false:
                needs |= when.needs_true | when.needs_false
        add, delete = ground.changes(bits)
        needed |= (needs | (add & ~bits)) & ~touched
        touched |= add | delete
        bits = (bits & ~delete) | add
    return frozenset(task.named(needed))


def foresight(task: Task, planner: Planner) -> Foresight:
    """Foresee by planning; what was foreseen last is remembered."""

    @lru_cache(maxsize=512)
    def foreseen(state: State, goal: Goal) -> frozenset[Fluent] | None:
        answer = planner.plan(state, goal)
        return taken_for_granted(task, state, answer.actions) if isinstance(answer, Plan) else None

    return foreseen


def nothing_foreseen(state: State, goal: Goal) -> None:
    """Tell nothing: for whoever cannot plan."""
