"""Can the planner reach what was demonstrated? A plan to each instance's whole change, run."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from verbteach.experiments.gold import whole_change
from verbteach.experiments.metrics import sji
from verbteach.verbs.change import StateChange
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Literal
from verbteach.world.plan import Plan, Planner
from verbteach.world.simulator import run
from verbteach.world.task import Task


class ReachKind(Enum):
    """How a plan to the whole change came out.

    ``EXACT``: it changed just that. ``NOTHING_CHANGED``: the demonstration
    ended as it began, which scores 0 whatever is done. ``NO_PLAN``: the
    planner found none. The others reach the change and change more:
    ``LEFT_IN_HAND`` leaves things in the hand that the demonstrator let go,
    ``LEFT_ON`` leaves, with or without that, something on, open or filled
    that was not so in the end, ``OTHER_WAY`` leaves things or the robot elsewhere.
    """

    EXACT = "exact"
    LEFT_IN_HAND = "left-in-hand"
    LEFT_ON = "left-on"
    OTHER_WAY = "other-way"
    NOTHING_CHANGED = "nothing-changed"
    NO_PLAN = "no-plan"


@dataclass(frozen=True)
class Reached:
    """An instance's plan to its whole change, scored against that change.

    ``surplus`` are the changes that the demonstration did not make, sorted.
    """

    instance: str
    sji: float
    kind: ReachKind
    surplus: tuple[Literal, ...] = ()


def reach(instance: Instance, task: Task, planner: Planner) -> Reached:
    """Plan to everything that the instance changed, and run the plan from its start."""
    gold = whole_change(instance, task)
    if not len(gold):
        return Reached(instance.id, 0.0, ReachKind.NOTHING_CHANGED)
    answer = planner.plan(instance.start, gold.literals)
    if not isinstance(answer, Plan):
        return Reached(instance.id, 0.0, ReachKind.NO_PLAN)
    end = run(task, instance.start, answer.actions)[-1]
    got = StateChange.between(instance.start, end, task.domain.static)
    surplus = tuple(sorted(got.literals - gold.literals))
    return Reached(instance.id, sji(gold, got), _kind(surplus), surplus)


def _kind(surplus: tuple[Literal, ...]) -> ReachKind:
    if not surplus:
        return ReachKind.EXACT
    left = {literal.fluent.predicate if literal.positive else "" for literal in surplus}
    if left == {"Grasping"}:
        return ReachKind.LEFT_IN_HAND
    return ReachKind.LEFT_ON if left <= {"Grasping", "state"} else ReachKind.OTHER_WAY
