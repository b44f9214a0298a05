"""Choosing what to do: candidate goals in order, and the plan that most of them ask for."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from itertools import combinations
from typing import Protocol, TypeVar

from verbteach.verbs.agreement import agreement
from verbteach.verbs.application import (
    ApplicationParameters,
    Evidence,
    Situation,
    evidence,
)
from verbteach.verbs.criteria import MOST_GENERAL, Criterion
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.lifting import Lifted
from verbteach.world.fluents import Goal, Literal, State
from verbteach.world.plan import Plan, Planner


class Pooling(Enum):
    """How goals make a plan's score.

    ``SUM`` adds up those with the same plan (She & Chai 2016), ``BEST`` takes
    their best. ``CONSENSUS`` sums all goals' scores, each in the measure in
    which its plan agrees with this one: the plan that is expected to be most
    nearly right, where people disagree about what the verb asks for.
    """

    SUM = "sum"
    BEST = "best"
    CONSENSUS = "consensus"


@dataclass(frozen=True)
class SelectionParameters:
    """How a goal is chosen.

    ``planned``: at most that many goals are planned for, the best first, which
    bounds a turn; ``pooling`` is She & Chai's sum unless set otherwise.
    """

    criterion: Criterion = MOST_GENERAL
    application: ApplicationParameters = field(default_factory=ApplicationParameters)
    planned: int = 24
    pooling: Pooling = Pooling.SUM


class Scored(Protocol):
    """A goal with how much it is wanted."""

    @property
    def goal(self) -> Goal:
        """What is to hold."""
        ...

    @property
    def score(self) -> float:
        """How much it is wanted."""
        ...


_W = TypeVar("_W", bound=Scored)


@dataclass(frozen=True)
class GoalCandidate:
    """A goal the command may mean.

    ``score`` is the criterion's, ``share`` the same normalised over all
    candidates. ``hypothesis`` and ``grounding`` are those that speak for the
    goal most; ``satisfied`` is the share of its fluents that hold already;
    ``evidence`` has the rest.
    """

    goal: Goal
    score: float
    share: float
    hypothesis: Lifted
    grounding: tuple[str, ...]
    satisfied: float
    evidence: Evidence

    @property
    def key(self) -> tuple[Literal, ...]:
        """The goal, sorted."""
        return self.evidence.key


@dataclass(frozen=True)
class Selection:
    """What the robot would do: the plan, its pooled score, and the best goal it serves."""

    candidate: GoalCandidate
    plan: Plan
    score: float


def candidates(
    knowledge: VerbKnowledge,
    situation: Situation,
    parameters: SelectionParameters | None = None,
) -> tuple[GoalCandidate, ...]:
    """Goals that the command may mean, the most wanted first, ties as in ``evidence``.

    Empty where nothing is known of the frame.
    """
    parameters = parameters or SelectionParameters()
    return ranked(evidence(knowledge, situation, parameters.application), parameters.criterion)


def ranked(
    gathered: Sequence[Evidence], criterion: Criterion, most: int | None = None
) -> tuple[GoalCandidate, ...]:
    """Score gathered evidence and sort it; among equals the order stays.

    Of more than ``most`` candidates the rest is left out.
    """
    scored = [(criterion.score(one), one) for one in gathered]
    wanted = sorted((row for row in scored if row[0] > 0), key=lambda row: -row[0])
    total = sum(score for score, _ in wanted)
    return tuple(_candidate(one, score, score / total) for score, one in wanted[:most])


def select(
    wanted: Sequence[GoalCandidate],
    state: State,
    planner: Planner,
    parameters: SelectionParameters | None = None,
) -> Selection | None:
    """The best non-empty plan: goals with the same plan pool their scores.

    ``wanted`` comes from ``candidates``. None where no goal has a plan, or all
    hold already.
    """
    found = best_plan(wanted, state, planner, parameters)
    return None if found is None else Selection(*found)


def best_plan(
    wanted: Sequence[_W],
    state: State,
    planner: Planner,
    parameters: SelectionParameters | None = None,
) -> tuple[_W, Plan, float] | None:
    """As ``select``, of any scored goals: the best goal that the plan serves, it, and its score."""
    parameters = parameters or SelectionParameters()
    served: dict[Plan, list[_W]] = defaultdict(list)
    for candidate in wanted[: parameters.planned]:
        answer = planner.plan(state, candidate.goal)
        if isinstance(answer, Plan) and answer.actions:
            served[answer].append(candidate)
    scores = _pooled(served, parameters.pooling)
    # max keeps the first of equals, and plans were met in the candidates' order.
    best = max(served, key=lambda plan: scores[plan], default=None)
    return None if best is None else (served[best][0], best, scores[best])


def _pooled(served: Mapping[Plan, Sequence[Scored]], pooling: Pooling) -> dict[Plan, float]:
    if pooling is Pooling.BEST:
        return {plan: found[0].score for plan, found in served.items()}
    sums = {plan: sum(one.score for one in found) for plan, found in served.items()}
    return sums if pooling is Pooling.SUM else _agreed(sums)


def _agreed(sums: Mapping[Plan, float]) -> dict[Plan, float]:
    """Each plan's score with the others' in the measure of their agreement."""
    scores = dict(sums)
    for one, other in combinations(sums, 2):
        alike = agreement(one.actions, other.actions)
        scores[one] += alike * sums[other]
        scores[other] += alike * sums[one]
    return scores


def _candidate(one: Evidence, score: float, share: float) -> GoalCandidate:
    best = max(one.supports, key=lambda s: s.votes)
    return GoalCandidate(
        one.goal, score, share, best.node.literals, best.grounding, one.satisfied, one
    )
