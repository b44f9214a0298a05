"""What plans take for granted, checked by breaking it."""

from __future__ import annotations

import pytest

from verbteach.dialogue.setting import Setting
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Plan
from verbteach.world.reliance import foresight, taken_for_granted
from verbteach_scenarios.settings import make_settings


@pytest.fixture(scope="module")
def kitchen() -> Setting:
    return make_settings()("kitchen-1")


def test_a_plan_fails_or_goes_astray_only_where_what_it_relies_on_is_otherwise(
    kitchen: Setting,
) -> None:
    task, start = kitchen.task, kitchen.scene.initial
    goal = frozenset({Literal(next(f for f in task.fluents if f.predicate == "hot"))})
    answer = kitchen.planner.plan(start, goal)
    assert isinstance(answer, Plan)
    relied = taken_for_granted(task, start, answer.actions)
    assert relied
    ends = _end(kitchen, start, answer)
    for fluent in task.fluents:
        other = start ^ {fluent}
        if fluent not in relied and _end(kitchen, other, answer) is None:
            pytest.fail(f"{fluent} matters though the plan does not rely on it")
    assert ends is not None
    assert any(_end(kitchen, start ^ {fluent}, answer) is None for fluent in sorted(relied))


def _end(kitchen: Setting, state: frozenset[Fluent], plan: Plan) -> int | None:
    bits = kitchen.task.encode(state)
    for action in plan.actions:
        ground = kitchen.task.action(action)
        if ground is None or not ground.applicable(bits):
            return None
        bits = ground.result(bits)
    return bits


def test_what_an_action_brought_about_is_not_taken_for_granted(kitchen: Setting) -> None:
    task, start = kitchen.task, kitchen.scene.initial
    ground = next(g for g in task.actions if g.applicable(task.encode(start)) and g.add)
    once = taken_for_granted(task, start, (ground.action,))
    twice = taken_for_granted(task, start, (ground.action, ground.action))
    assert once <= twice
    assert not frozenset(task.named(ground.add)) & (twice - once)


def test_without_a_plan_nothing_is_foreseen(kitchen: Setting) -> None:
    nonsense = frozenset({Literal(Fluent("hot", ("Nowhere_1",)))})
    foreseen = foresight(kitchen.task, kitchen.planner)
    assert foreseen(kitchen.scene.initial, nonsense) is None
