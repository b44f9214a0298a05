"""Plans run, reach their goals, agree with exhaustive search, and fail with a reason."""

from __future__ import annotations

import numpy as np
import pytest

from tests.world import kitchenette, naive
from verbteach.world.fluents import Fluent, Goal, Literal, State, satisfied
from verbteach.world.plan import FailureReason, Plan, PlanFailure, Planner
from verbteach.world.planner import PlannerConfig, SearchPlanner
from verbteach.world.simulator import run
from verbteach.world.task import Task

DOMAIN = kitchenette.domain()
TINY = {**DOMAIN.constants, **kitchenette.objects((1, 0, 1, 1, 0))}
SMALL = {**DOMAIN.constants, **kitchenette.objects((3, 2, 2, 1, 2))}


def lit(text: str) -> Literal:
    return Literal.parse(text)


def goal_of(*texts: str) -> Goal:
    return frozenset(lit(text) for text in texts)


def check(task: Task, state: State, goal: Goal, answer: Plan | PlanFailure) -> None:
    assert isinstance(answer, Plan)
    states = run(task, state, answer.actions)
    assert len(states) == len(answer.actions) + 1
    assert satisfied(goal, states[-1])


@pytest.mark.parametrize("seed", range(60))
def test_solvable_exactly_where_exhaustive_search_says_so(seed: int) -> None:
    rng = np.random.default_rng(seed)
    start = kitchenette.start(TINY, rng)
    task = Task(DOMAIN, TINY, start)
    goal = kitchenette.goal(task, rng, size=1 + seed % 4)
    answer = SearchPlanner(task, PlannerConfig(expansions=100_000)).plan(start, goal)
    shortest = naive.shortest(DOMAIN, TINY, start, goal)
    if shortest is None:
        assert isinstance(answer, PlanFailure)
        assert answer.reason is FailureReason.UNREACHABLE
    else:
        check(task, start, goal, answer)
        assert isinstance(answer, Plan)
        assert len(answer.actions) <= 2 * len(shortest) + 1


@pytest.mark.parametrize("seed", range(60))
def test_what_a_walk_reached_is_planned_from_any_state(seed: int) -> None:
    rng = np.random.default_rng(seed)
    start = kitchenette.start(SMALL, rng)
    task = Task(DOMAIN, SMALL, start)
    planner: Planner = SearchPlanner(task)
    for _ in range(4):
        start = kitchenette.walk(task, start, 10, rng)
        goal = kitchenette.reached_goal(task, start, rng, steps=25, size=4)
        check(task, start, goal, planner.plan(start, goal))


def world(*facts: str) -> tuple[Task, State]:
    state = frozenset(Fluent.parse(f) for f in (*facts, "(hinged Box_1)"))
    return Task(DOMAIN, SMALL, state), state


def texts(answer: Plan | PlanFailure) -> list[str]:
    assert isinstance(answer, Plan)
    return [str(action) for action in answer.actions]


def test_a_goal_that_holds_needs_no_action() -> None:
    task, state = world("(running)")
    assert texts(SearchPlanner(task).plan(state, goal_of("(running)", "(not (busy))"))) == []
    assert texts(SearchPlanner(task).plan(state, frozenset())) == []


def test_negative_goals_and_toggles() -> None:
    task, state = world("(running)", "(wet Cup_1)", "(on Cup_1 Table_1)")
    answer = SearchPlanner(task).plan(state, goal_of("(not (running))"))
    assert texts(answer) == ["moveto Tap_1", "turn"]


def test_a_conditional_effect_is_used() -> None:
    task, state = world("(on Cup_1 Stove_1)", "(near Cup_2)")
    answer = SearchPlanner(task).plan(state, goal_of("(hot Cup_1)"))
    assert texts(answer) == ["moveto Stove_1", "light Stove_1"]


def test_closed_boxes_are_opened_and_closed_again() -> None:
    task, state = world("(in Cup_1 Box_1)", "(enclosed Cup_1)")
    goal = goal_of("(on Cup_1 Shelf_1)", "(not (open Box_1))")
    answer = SearchPlanner(task).plan(state, goal)
    check(task, state, goal, answer)
    assert len(texts(answer)) <= 9


@pytest.mark.parametrize(
    ("literal", "reason", "detail"),
    [
        ("(flying Cup_1)", FailureReason.UNKNOWN_FLUENT, "(flying Cup_1)"),
        ("(on Cup_1)", FailureReason.UNKNOWN_FLUENT, "(on Cup_1)"),
        ("(on Cup_77 Shelf_1)", FailureReason.UNKNOWN_FLUENT, "(on Cup_77 Shelf_1)"),
        ("(hot Shelf_1)", FailureReason.UNKNOWN_FLUENT, "(hot Shelf_1)"),
        ("(not (flying Cup_1))", FailureReason.UNKNOWN_FLUENT, "(flying Cup_1)"),
        ("(hinged Box_2)", FailureReason.UNREACHABLE, "(hinged Box_2)"),
        ("(not (hinged Box_1))", FailureReason.UNREACHABLE, "(not (hinged Box_1))"),
        ("(open Box_2)", FailureReason.UNREACHABLE, "(open Box_2)"),
        ("(not (near Cup_1))", FailureReason.UNREACHABLE, "(not (near Cup_1))"),
    ],
)
def test_failures_name_their_reason(literal: str, reason: FailureReason, detail: str) -> None:
    task, state = world()
    goal = goal_of("(near Cup_1)", literal)
    assert SearchPlanner(task).plan(state, goal) == PlanFailure(reason, detail)


def test_static_facts_count_as_the_task_has_them() -> None:
    task, state = world()
    believed = state - {Fluent("hinged", ("Box_1",))}
    answer = SearchPlanner(task).plan(believed, goal_of("(hinged Box_1)", "(open Box_1)"))
    assert texts(answer) == ["moveto Box_1", "open Box_1"]


def test_the_bound_is_kept_and_named() -> None:
    task, state = world("(on Cup_1 Shelf_1)", "(on Cup_2 Shelf_1)")
    goal = goal_of("(holding Cup_1)", "(holding Cup_2)")
    answer = SearchPlanner(task, PlannerConfig(expansions=50)).plan(state, goal)
    assert answer == PlanFailure(FailureReason.BOUND, "50 states judged")


def test_answers_are_remembered_up_to_the_limit() -> None:
    task, state = world()
    planner = SearchPlanner(task, PlannerConfig(remembered=2))
    goals = [goal_of(f"(near {name})") for name in ("Cup_1", "Cup_2", "Cup_3")]
    first = planner.plan(state, goals[0])
    planner.plan(state, goals[1])
    assert planner.plan(state, goals[0]) is first
    planner.plan(state, goals[2])
    assert planner.plan(state, goals[0]) is first
    again = planner.plan(state, goals[1])
    assert planner.plan(state, goals[0]) == first
    assert planner.plan(state, goals[1]) == again
