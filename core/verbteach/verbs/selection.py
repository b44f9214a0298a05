"""Choosing what to do: candidate goals in order, and the plan that most of them ask for."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum

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
    """How goals with the same plan make that plan's score."""

    SUM = "sum"
    BEST = "best"


@dataclass(frozen=True)
class SelectionParameters:
    """How a goal is chosen.

    ``planned``: at most that many goals are planned for, the best first, which
    bounds a turn; ``pooling`` is She & Chai's sum unless ``BEST``.
    """

    criterion: Criterion = MOST_GENERAL
    application: ApplicationParameters = field(default_factory=ApplicationParameters)
    planned: int = 24
    pooling: Pooling = Pooling.SUM


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
    """Goals that the command may mean, the most wanted first, ties in the goals' order.

    Empty where nothing is known of the frame.
    """
    parameters = parameters or SelectionParameters()
    return ranked(evidence(knowledge, situation, parameters.application), parameters.criterion)


def ranked(gathered: Sequence[Evidence], criterion: Criterion) -> tuple[GoalCandidate, ...]:
    """Score gathered evidence and sort it."""
    scored = [(criterion.score(one), one) for one in gathered]
    wanted = sorted(((s, e) for s, e in scored if s > 0), key=lambda row: (-row[0], row[1].key))
    total = sum(score for score, _ in wanted)
    return tuple(_candidate(one, score, score / total) for score, one in wanted)


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
    parameters = parameters or SelectionParameters()
    served: dict[Plan, list[GoalCandidate]] = defaultdict(list)
    for candidate in wanted[: parameters.planned]:
        answer = planner.plan(state, candidate.goal)
        if isinstance(answer, Plan) and answer.actions:
            served[answer].append(candidate)
    pooled = [
        Selection(found[0], plan, _pooled(found, parameters.pooling))
        for plan, found in served.items()
    ]
    # max keeps the first of equals, and plans were met in the candidates' order.
    return max(pooled, key=lambda selection: selection.score, default=None)


def _pooled(found: Sequence[GoalCandidate], pooling: Pooling) -> float:
    scores = [candidate.score for candidate in found]
    return sum(scores) if pooling is Pooling.SUM else max(scores)


def _candidate(one: Evidence, score: float, share: float) -> GoalCandidate:
    best = max(one.supports, key=lambda s: s.votes)
    return GoalCandidate(
        one.goal, score, share, best.node.literals, best.grounding, one.satisfied, one
    )
