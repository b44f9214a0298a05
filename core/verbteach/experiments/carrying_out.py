"""How the robot of the experiments carries a command out: which plan it takes, and its scores.

Hypotheses are whole changes, by-products included, and so is what a plan
brings about. So the goals thought best are planned for, and the plan is taken
whose outcome, not whose goal, is most like what is meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import NamedTuple

from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.experiments.metrics import ied
from verbteach.experiments.simulated_human import SimulatedHuman
from verbteach.experiments.workroom import Workroom
from verbteach.world.caution import careful
from verbteach.world.fluents import Goal
from verbteach.world.plan import Action, Plan

COMPARED, TRIED = 4, 6
"""So many of the best goals are compared; where none of them has a plan, so many are tried."""


@dataclass(frozen=True)
class Carried:
    """How a command was carried out: the plan and its two scores."""

    plan: tuple[Action, ...]
    ied: float
    sji: float


class _Way(NamedTuple):
    goal: Goal
    actions: tuple[Action, ...]


def carry_out(inquiry: ExecutionInquiry, human: SimulatedHuman, gold: Sequence[Action]) -> Carried:
    """Plan on what is believed and run the plan in the true world.

    The plan ends at the first action that cannot be done.
    """
    plan = chosen_plan(inquiry, human.room)
    return Carried(plan, ied(gold, plan), human.score(plan))


def chosen_plan(inquiry: ExecutionInquiry, room: Workroom) -> tuple[Action, ...]:
    """The plan whose outcome is expected to be most like what is meant; empty where there is none.

    Among equals that of the better goal.
    """
    ways = list(_ways(inquiry, room))
    if not ways:
        return ()
    best = _best(inquiry, room, ways)
    if not inquiry.parameters.caution:
        return best.actions
    return careful(
        room.task,
        room.planner,
        inquiry.believed,
        best.goal,
        best.actions,
        inquiry.belief.__getitem__,
        inquiry.parameters.caution,
    )


def _ways(inquiry: ExecutionInquiry, room: Workroom) -> Iterator[_Way]:
    """The best goals that take an action to reach, with their plans."""
    found = 0
    for rank, (goal, _) in enumerate(islice(inquiry.pool.ranked_goals(), TRIED)):
        if found and rank >= COMPARED:
            break
        answer = room.planner.plan(inquiry.believed, goal)
        if isinstance(answer, Plan) and answer.actions:
            found += 1
            yield _Way(goal, answer.actions)


def _best(inquiry: ExecutionInquiry, room: Workroom, ways: Sequence[_Way]) -> _Way:
    if len({way.actions for way in ways}) == 1:
        return ways[0]
    outcomes = [room.changed(inquiry.believed, way.actions).literals for way in ways]
    likenesses = inquiry.pool.likenesses(outcomes)
    best, _ = max(zip(ways, likenesses, strict=True), key=lambda pair: round(pair[1], 9))
    return best
