"""Careful plans, checked by breaking what was doubted."""

from __future__ import annotations

import pytest

from verbteach.dialogue.setting import Setting
from verbteach.world.caution import LONGER, careful, leads_to
from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action, Plan
from verbteach.world.reliance import taken_for_granted
from verbteach_scenarios.settings import make_settings


@pytest.fixture(scope="module")
def kitchen() -> Setting:
    return make_settings()("kitchen-1")


def _goals(kitchen: Setting) -> list[tuple[Goal, tuple[Action, ...]]]:
    found = []
    for fluent in kitchen.task.fluents:
        goal = frozenset({Literal(fluent)})
        if fluent.predicate in {"hot", "on", "in"} and fluent not in kitchen.scene.initial:
            answer = kitchen.planner.plan(kitchen.scene.initial, goal)
            if isinstance(answer, Plan) and len(answer.actions) > 1:
                found.append((goal, answer.actions))
    return found[:12]


def test_a_sure_robot_keeps_its_plan(kitchen: Setting) -> None:
    for goal, plan in _goals(kitchen):
        start = kitchen.scene.initial
        kept = careful(kitchen.task, kitchen.planner, start, goal, plan, lambda f: 1.0, 0.99)
        assert kept == plan


def test_a_careful_plan_reaches_the_goal_whether_the_doubtful_fact_holds_or_not(
    kitchen: Setting,
) -> None:
    task, start, spared = kitchen.task, kitchen.scene.initial, 0
    for goal, plan in _goals(kitchen):
        for fact in sorted(taken_for_granted(task, start, plan) & start - task.static):
            sureness = dict.fromkeys(task.fluents, 1.0) | {fact: 0.6}
            safe = careful(
                task, kitchen.planner, start, goal, plan, sureness.__getitem__, sure=0.99
            )
            assert leads_to(task, start, safe, goal)
            assert len(safe) <= len(plan) + LONGER
            if safe != plan:
                spared += 1
                assert leads_to(task, start - {fact}, safe, goal)
                assert not leads_to(task, start - {fact}, plan, goal) or len(safe) <= len(plan)
    assert spared


def test_an_action_that_is_not_there_leads_nowhere(kitchen: Setting) -> None:
    goal = frozenset({Literal(Fluent("hot", ("Nowhere_1",)))})
    assert not leads_to(kitchen.task, kitchen.scene.initial, (), goal)
    assert leads_to(kitchen.task, kitchen.scene.initial, (), frozenset())
