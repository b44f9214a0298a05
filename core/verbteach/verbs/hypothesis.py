"""The base hypothesis of a demonstration, and its generalisations by planner pruning.

She & Chai (2016): fluents are taken away from the base one at a time; a
smaller goal is kept only if the planner's plan for it is the plan for the
base, and what is below a rejected goal is rejected without planning.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from enum import Enum

from verbteach.verbs.change import ObjectSet, StateChange, Touch, restrict, things_of
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Goal, Literal, State
from verbteach.world.plan import Action, Plan, PlanFailure, Planner


@dataclass(frozen=True)
class LearningParameters:
    """How a demonstration becomes hypotheses.

    ``too_many``: this many changed fluents (after ``object_set``'s choice) or
    more are taken for noise and give no hypothesis (She & Chai 2016: 10).
    ``touch``: a fluent is about the chosen things when any of its things is
    one, or only when every one is; the papers leave it open. ``prune`` off
    keeps every subset of the base. ``generalise_confirmed`` also takes fluents
    away from a goal that a teacher confirmed; the papers know no such goal.
    """

    object_set: ObjectSet = ObjectSet.ALL
    touch: Touch = Touch.ANY
    too_many: int = 10
    prune: bool = True
    generalise_confirmed: bool = False


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
    """What learning needs beside the demonstration."""

    planner: Planner
    surroundings: Surroundings
    parameters: LearningParameters = field(default_factory=LearningParameters)


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


def generalisations(
    base: GoalHypothesis, start: State, planner: Planner, prune: bool = True
) -> tuple[Goal, ...]:
    """The base and its kept subsets, specific to general, in a fixed order; never the empty goal.

    Plans at most once for each subset, fewer the more is rejected early.
    """
    fluents = tuple(sorted(base.goal))
    level = [(1 << len(fluents)) - 1]
    found = [base.goal]
    while level:
        smaller = _below(level, len(fluents))
        level = []
        for mask in smaller:
            goal = frozenset(_members(fluents, mask))
            if not prune or planner.plan(start, goal) == base.plan:
                level.append(mask)
                found.append(goal)
    return tuple(found)


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
