"""An independent planner of another make judges the plans, and whether there are any."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.world import kitchenette
from verbteach.world.domain import Domain
from verbteach.world.fluents import Goal, State
from verbteach.world.plan import FailureReason, Plan, PlanFailure
from verbteach.world.planner import PlannerConfig, SearchPlanner
from verbteach.world.task import Task
from verbteach_scenarios.pddl import domain_text, problem_text, read_domain, read_problem

kairos = pytest.importorskip("kairos", reason="kairos-planner has wheels for Linux only")

if TYPE_CHECKING:
    from kairos import Problem as Judged

HOUSEHOLD = Path(__file__).parents[2] / "scenarios/verbteach_scenarios/data/household"
SIZES = [(1, 1, 1, 1, 1), (3, 2, 2, 1, 2), (5, 4, 3, 2, 3), (12, 6, 4, 3, 4)]


class Judge:
    """Kairos, with the domain parsed once."""

    def __init__(self, domain: Domain) -> None:
        self.domain = domain
        self._parsed = kairos.parse_domain(domain_text(domain))

    def problem(self, task: Task, state: State, goal: Goal) -> Judged:
        text = problem_text("judged", self.domain, task.objects, state, goal)
        problem: Judged = kairos.parse_problem(text, self._parsed)
        return problem

    def accepts(self, problem: Judged, plan: Plan) -> bool:
        text = "".join(f"({action})\n" for action in plan.actions)
        return bool(kairos.validate(problem, kairos.parse_plan(text)).valid)

    def solves(self, problem: Judged) -> bool:
        found = kairos.Planner().solve(problem, timeout=3, anytime=False, search="ff", threads=1)
        return bool(found.status == kairos.Status.SOLVED)


def agree(judge: Judge, task: Task, state: State, goal: Goal, answer: Plan | PlanFailure) -> bool:
    """Whether the judge accepts a plan, or finds none where none is claimed to be."""
    problem = judge.problem(task, state, goal)
    if isinstance(answer, Plan):
        return judge.accepts(problem, answer)
    return answer.reason is FailureReason.BOUND or not judge.solves(problem)


@pytest.mark.parametrize("seed", range(20))
def test_on_random_problems(seed: int) -> None:
    rng = np.random.default_rng(1000 + seed)
    judge = Judge(kitchenette.domain())
    things = {**judge.domain.constants, **kitchenette.objects(SIZES[seed % len(SIZES)])}
    start = kitchenette.start(things, rng)
    task = Task(judge.domain, things, start)
    planner = SearchPlanner(task, PlannerConfig(expansions=300))
    plans = 0
    for number in range(20):
        state = kitchenette.walk(task, start, int(rng.integers(25)), rng)
        if number % 4:
            goal = kitchenette.reached_goal(task, state, rng, int(rng.integers(40)), 1 + number % 6)
        else:
            goal = kitchenette.goal(task, rng, 1 + number % 3)
        answer = planner.plan(state, goal)
        plans += isinstance(answer, Plan)
        assert agree(judge, task, state, goal, answer), (sorted(goal), answer)
    assert plans >= 14


def test_the_judge_refuses_a_wrong_plan() -> None:
    rng = np.random.default_rng(3)
    judge = Judge(kitchenette.domain())
    things = {**judge.domain.constants, **kitchenette.objects((3, 2, 2, 1, 2))}
    start = kitchenette.start(things, rng)
    task = Task(judge.domain, things, start)
    goal = kitchenette.reached_goal(task, start, rng, 60, 4)
    answer = SearchPlanner(task).plan(start, goal)
    assert isinstance(answer, Plan)
    assert len(answer.actions) > 1
    problem = judge.problem(task, start, goal)
    assert judge.accepts(problem, answer)
    for left_out in range(len(answer.actions)):
        kept = answer.actions[:left_out] + answer.actions[left_out + 1 :]
        assert not judge.accepts(problem, Plan(kept))


SCENES = [
    pytest.param(path, id=path.stem, marks=() if path.stem.endswith("-1") else pytest.mark.slow)
    for path in sorted(HOUSEHOLD.glob("*-*.pddl"))
]


@pytest.mark.parametrize("path", SCENES)
def test_in_the_household(path: Path) -> None:
    rng = np.random.default_rng(len(path.stem))
    judge = Judge(read_domain(HOUSEHOLD / "domain.pddl"))
    scene = read_problem(path, judge.domain)
    task = Task(judge.domain, scene.objects, scene.initial)
    planner = SearchPlanner(task)
    plans = 0
    for number in range(10):
        state = kitchenette.walk(task, scene.initial, int(rng.integers(30)), rng)
        goal = kitchenette.reached_goal(task, state, rng, int(rng.integers(1, 50)), 1 + number)
        answer = planner.plan(state, goal)
        plans += isinstance(answer, Plan)
        assert agree(judge, task, state, goal, answer), (sorted(goal), answer)
    assert plans >= 9  # of some hundred goals put together at random, one is out of the bound
