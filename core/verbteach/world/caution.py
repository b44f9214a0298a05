"""Plans that rely on less: where one takes something doubtful for granted, a safer is sought.

A robot that believes it is beside the stove, and is wrong, fails at its first
action; going there first costs one action and cannot fail.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from verbteach.world.fluents import Fluent, Goal, State
from verbteach.world.plan import Action, Plan, Planner
from verbteach.world.reliance import taken_for_granted
from verbteach.world.task import Task

LONGER = 2
"""So many more actions it may cost not to rely on a fact."""
_ROUNDS = 6


def careful(
    task: Task,
    planner: Planner,
    state: State,
    goal: Goal,
    actions: Sequence[Action],
    confidence: Callable[[Fluent], float],
    sure: float,
) -> tuple[Action, ...]:
    """A plan to ``goal`` that also works where doubtful facts of ``state`` do not hold.

    Facts believed with less than ``sure`` are doubted one by one, the most
    doubtful first. A way found for a state without one takes the plan's place if
    it leads to the goal from ``state`` as well and is at most ``LONGER`` longer.
    """
    plan, doubted, tried = tuple(actions), state, set[Fluent]()
    for _ in range(_ROUNDS):
        hinges = taken_for_granted(task, doubted, plan) & doubted
        open_ones = [f for f in hinges - tried - task.static if confidence(f) < sure]
        if not open_ones:
            break
        fact = min(open_ones, key=lambda f: (confidence(f), f))
        tried.add(fact)
        other = planner.plan(doubted - {fact}, goal)
        if not isinstance(other, Plan) or not 0 < len(other.actions) <= len(plan) + LONGER:
            continue
        if leads_to(task, state, other.actions, goal):
            plan, doubted = other.actions, doubted - {fact}
    return plan


def leads_to(task: Task, state: State, actions: Sequence[Action], goal: Goal) -> bool:
    """Whether every action can be done in its turn, and the goal holds at the end."""
    bits = task.encode(state)
    for action in actions:
        ground = task.action(action)
        if ground is None or not ground.applicable(bits):
            return False
        bits = ground.result(bits)
    end = task.decode(bits)
    return all(literal.holds(end) for literal in goal)
