"""Which plan is taken, held against trying every goal that was compared."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import pytest

from tests.experiments.interactive_room import bench
from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.experiments.carrying_out import COMPARED, carry_out, chosen_plan
from verbteach.experiments.interactive_bench import IN_ONE_PLACE
from verbteach.experiments.interactive_protocol import Config, run
from verbteach.experiments.simulated_human import SimulatedHuman
from verbteach.experiments.workroom import Workroom
from verbteach.world.plan import Plan

CONFIG = Config(policy="silent", groups=2)


def met(**changes: object) -> list[tuple[ExecutionInquiry, SimulatedHuman]]:
    """Every command of the small bench, before anything was asked."""
    found: list[tuple[ExecutionInquiry, SimulatedHuman]] = []
    config = replace(CONFIG, **changes)  # type: ignore[arg-type]
    run(bench(), config, witness=lambda command: found.append((command.start, command.human)))
    return found


def expected(inquiry: ExecutionInquiry, room: Workroom, answer: object) -> float:
    if not isinstance(answer, Plan) or not answer.actions:
        return -1.0
    outcome = room.changed(inquiry.believed, answer.actions).literals
    pool, value = inquiry.pool, 0.0
    for row, chance in zip(pool.truths, pool.probabilities.tolist(), strict=True):
        wanted = pool.goal(row)
        value += chance * len(outcome & wanted) / len(outcome | wanted)
    return value


def test_no_goal_that_was_compared_has_an_outcome_more_like_what_is_meant() -> None:
    for inquiry, human in met():
        plan = chosen_plan(inquiry, human.room)
        goals = [goal for goal, _ in islice(inquiry.pool.ranked_goals(), COMPARED)]
        answers = [human.room.planner.plan(inquiry.believed, goal) for goal in goals]
        values = [expected(inquiry, human.room, answer) for answer in answers]
        if max(values, default=-1.0) < 0.0:
            continue
        taken = expected(inquiry, human.room, Plan(plan))
        assert taken == pytest.approx(max(values), abs=1e-5)


def test_a_command_that_means_nothing_known_has_no_plan() -> None:
    inquiry, human = met()[0]
    nothing = replace(inquiry, pool=replace(inquiry.pool, truths=inquiry.pool.truths[:0]))
    assert chosen_plan(nothing, human.room) == ()
    assert carry_out(nothing, human, ()).sji == 0.0


def test_only_eyes_that_see_phantoms_make_the_robot_careful() -> None:
    assert {one.parameters.caution for one, _ in met(noise="std5")} == {0.0}
    careful = met(noise="std5", reading="phantom")
    assert {one.parameters.caution for one, _ in careful} == {bench().parameters.caution}


def test_only_eyes_that_see_phantoms_weigh_where_a_thing_is() -> None:
    assert {one.belief.exclusive for one, _ in met(noise="std5")} == {()}
    for inquiry, _ in met(noise="std5", reading="phantom"):
        where = [IN_ONE_PLACE.group(fluent) for fluent in inquiry.belief.believed()]
        things = [thing for thing in where if thing is not None]
        assert len(things) == len(set(things))
