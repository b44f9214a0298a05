"""The base hypothesis of a demonstration, and its generalisations by planner pruning.

She & Chai (2016): fluents are taken away from the base one at a time; a
smaller goal is kept only if the planner's plan for it is the plan for the
base, and what is below a rejected goal is rejected without planning.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from enum import Enum

from verbteach.verbs.change import ObjectSet, StateChange, Touch, restrict, things_of
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Goal, Literal, State
from verbteach.world.necessity import steps_needed
from verbteach.world.plan import Action, Plan, PlanFailure, Planner
from verbteach.world.task import Task


@dataclass(frozen=True)
class LearningParameters:
    """How a demonstration becomes hypotheses.

    ``too_many``: this many changed fluents (after ``object_set``'s choice) or
    more are taken for noise and give no hypothesis (She & Chai 2016: 10).
    ``touch``: a fluent is about the chosen things when any of its things is
    one, or only when every one is; the papers leave it open. ``prune`` off
    keeps every subset of the base. ``generalise_confirmed`` also takes fluents
    away from a goal that a teacher confirmed; the papers know no such goal.

    A base of more fluents than ``exhaustive`` is not planned for over and over
    while somebody waits: of its smaller goals only those with one fluent less
    are; one smaller still is kept if it needs as much of the base's plan as the
    base does. None plans for all, as the papers do.
    """

    object_set: ObjectSet = ObjectSet.ALL
    touch: Touch = Touch.ANY
    too_many: int = 10
    prune: bool = True
    generalise_confirmed: bool = False
    exhaustive: int | None = None


class NoHypothesisReason(Enum):
    """Why a demonstration teaches nothing."""

    NOTHING_CHANGED = "nothing_changed"
    TOO_MANY_CHANGED = "too_many_changed"
    NO_PLAN = "no_plan"


@dataclass(frozen=True)
class NoHypothesis:
    """A demonstration without a hypothesis: the reason, and in ``detail`` what it concerns."""

    reason: NoHypothesisReason
    detail: str = ""


@dataclass(frozen=True)
class Shown:
    """A demonstration as the robot saw it: believed ``start`` and ``end``, and the actions.

    ``goal`` is one that the teacher gave or corrected: it replaces the change.
    """

    start: State
    actions: tuple[Action, ...]
    end: State
    goal: Goal | None = None


@dataclass(frozen=True)
class Learner:
    """What learning needs beside the demonstration; without its ``task`` all is planned for."""

    planner: Planner
    surroundings: Surroundings
    parameters: LearningParameters = field(default_factory=LearningParameters)
    task: Task | None = None


@dataclass(frozen=True)
class GoalHypothesis:
    """A ground goal and the plan to it from the demonstration's start."""

    goal: Goal
    plan: Plan


def base_hypothesis(
    shown: Shown, arguments: Sequence[str], learner: Learner
) -> GoalHypothesis | NoHypothesis:
    """The conjunction of what changed over the chosen object set, or the goal that was given."""
    if shown.goal is not None:
        return planned_hypothesis(shown.goal, shown.start, learner.planner)
    surroundings, parameters = learner.surroundings, learner.parameters
    changed = StateChange.between(shown.start, shown.end, surroundings.static).literals
    things = things_of(parameters.object_set, arguments, shown.actions, shown.end, surroundings)
    goal = restrict(changed, things, surroundings, parameters.touch)
    if not goal:
        return NoHypothesis(NoHypothesisReason.NOTHING_CHANGED)
    if len(goal) >= parameters.too_many:
        return NoHypothesis(NoHypothesisReason.TOO_MANY_CHANGED, f"{len(goal)} fluents")
    return planned_hypothesis(goal, shown.start, learner.planner)


def planned_hypothesis(goal: Goal, start: State, planner: Planner) -> GoalHypothesis | NoHypothesis:
    """The goal with its plan; none if it already holds or no plan reaches it."""
    answer = planner.plan(start, goal)
    if isinstance(answer, PlanFailure):
        return NoHypothesis(NoHypothesisReason.NO_PLAN, answer.detail or answer.reason.value)
    if not answer.actions:
        return NoHypothesis(NoHypothesisReason.NOTHING_CHANGED, "the goal holds already")
    return GoalHypothesis(goal, answer)


def generalisations(base: GoalHypothesis, start: State, learner: Learner) -> tuple[Goal, ...]:
    """The base and its kept subsets, specific to general, in a fixed order; never the empty goal.

    Plans at most once for each subset, fewer the more is rejected early.
    """
    fluents = tuple(sorted(base.goal))
    level = [(1 << len(fluents)) - 1]
    found = [base.goal]
    keeps = _planned(base, start, learner)
    while level:
        smaller = _below(level, len(fluents))
        level = []
        for mask in smaller:
            goal = frozenset(_members(fluents, mask))
            if keeps(goal):
                level.append(mask)
                found.append(goal)
        if _is_large(base, learner):
            keeps = _needing_the_plan(base, start, learner)
    return tuple(found)


def _is_large(base: GoalHypothesis, learner: Learner) -> bool:
    """Whether planning for every subset would take too long."""
    most = learner.parameters.exhaustive
    return learner.parameters.prune and most is not None and len(base.goal) > most


def _planned(base: GoalHypothesis, start: State, learner: Learner) -> Callable[[Goal], bool]:
    """Keeps a goal whose own plan is the base's."""
    if not learner.parameters.prune:
        return lambda goal: True
    return lambda goal: learner.planner.plan(start, goal) == base.plan


def _needing_the_plan(
    base: GoalHypothesis, start: State, learner: Learner
) -> Callable[[Goal], bool]:
    """Keeps a goal that needs as many steps of the base's plan as the base."""
    task = learner.task
    if task is None:
        return _planned(base, start, learner)
    steps = steps_needed(task, start, base.plan, base.goal)
    return lambda goal: steps_needed(task, start, base.plan, goal) >= steps


def _members(fluents: Sequence[Literal], mask: int) -> Iterator[Literal]:
    return (fluent for bit, fluent in enumerate(fluents) if mask >> bit & 1)


def _below(level: Sequence[int], width: int) -> list[int]:
    """Masks one of ``width`` fluents smaller, all of whose supersets on this level were kept."""
    kept = frozenset(level)
    bits = [1 << i for i in range(width)]
    smaller = {mask ^ bit for mask in level for bit in bits if mask & bit and mask != bit}
    return sorted(
        (m for m in smaller if all(m & bit or m | bit in kept for bit in bits)), reverse=True
    )
