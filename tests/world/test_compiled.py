"""The compiled search finds the very plans of the plain one, and never makes anyone wait."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from tests.world import kitchenette
from verbteach.world import compiled
from verbteach.world.fluents import Goal, State
from verbteach.world.plan import Plan, PlanFailure
from verbteach.world.planner import (
    AutoEngine,
    PlainEngine,
    PlannerConfig,
    SearchPlanner,
    make_planner,
)
from verbteach.world.refinement import EncodedGoal, refined
from verbteach.world.relaxed import RelaxedTask
from verbteach.world.search import Exhausted, SearchLimits, Steps
from verbteach.world.task import GroundAction, Task

DOMAIN = kitchenette.domain()
needs_numba = pytest.mark.skipif(not compiled.installed(), reason="the extra 'fast' is missing")


def problems(
    counts: tuple[int, ...], seed: int, number: int
) -> tuple[Task, list[tuple[State, Goal]]]:
    """Reached goals, random goals (often out of reach) and goals that want a thing in hand."""
    rng = np.random.default_rng(seed)
    things = {**DOMAIN.constants, **kitchenette.objects(counts)}
    start = kitchenette.start(things, rng)
    task = Task(DOMAIN, things, start)
    asked: list[tuple[State, Goal]] = []
    for i in range(number):
        state = kitchenette.walk(task, start, int(rng.integers(30)), rng)
        reached = kitchenette.reached_goal(task, state, rng, int(rng.integers(5, 40)), 1 + i % 6)
        asked.append((state, reached if i % 3 else kitchenette.goal(task, rng, 1 + i % 4)))
    return task, asked


@needs_numba
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(24))
def test_plans_and_failures_are_identical(seed: int) -> None:
    sizes = [(1, 1, 1, 1, 1), (3, 2, 2, 2, 2), (8, 6, 4, 3, 3), (16, 8, 6, 4, 4)]
    task, asked = problems(sizes[seed % 4], seed, number=20)
    config = PlannerConfig(expansions=(0, 1, 60, 400)[seed // 4 % 4], boost=(0, 5, 1000)[seed % 3])
    plain, fast = (make_planner(task, config, path) for path in ("plain", "compiled"))
    answers = [plain.plan(*question) for question in asked]
    assert [fast.plan(*question) for question in asked] == answers


@needs_numba
@pytest.mark.slow
def test_the_problems_above_hold_plans_and_both_failures() -> None:
    answers: list[Plan | PlanFailure] = []
    for seed in range(4):
        task, asked = problems((3, 2, 2, 2, 2), seed, number=30)
        fast = make_planner(task, PlannerConfig(expansions=60), "compiled")
        answers += [fast.plan(*question) for question in asked]
    assert len({a.reason for a in answers if isinstance(a, PlanFailure)}) == 2
    assert max(len(a.actions) for a in answers if isinstance(a, Plan)) > 5


def padded(task: Task, bits: int, plan: Plan, rng: np.random.Generator) -> list[GroundAction]:
    """The plan with actions at random places, of which those stay that can be done."""
    numbers = [ground.index for action in plan.actions if (ground := task.action(action))]
    for extra in rng.integers(len(task.actions), size=12).tolist():
        numbers.insert(int(rng.integers(len(numbers) + 1)), extra)
    steps = []
    for step in (task.actions[number] for number in numbers):
        if step.applicable(bits):
            steps.append(step)
            bits = step.result(bits)
    return steps


def after(bits: int, steps: Sequence[GroundAction]) -> int:
    for step in steps:
        bits = step.result(bits)
    return bits


@needs_numba
@pytest.mark.slow
def test_padded_plans_are_refined_alike() -> None:
    task, asked = problems((3, 2, 2, 2, 2), seed=3, number=60)
    planner = make_planner(task, PlannerConfig(expansions=400), "compiled")
    from verbteach.world import kernel

    array = compiled.laid_out(kernel, task, RelaxedTask(task))
    rng = np.random.default_rng(3)
    changed = 0
    for state, goal in asked:
        answer, bits = planner.plan(state, goal), task.encode(state)
        steps = padded(task, bits, answer, rng) if isinstance(answer, Plan) else []
        masks = [sum(task.bit[x.fluent] for x in goal if x.positive is p) for p in (True, False)]
        wanted = EncodedGoal(*masks)
        if not steps or not wanted.holds(after(bits, steps)):
            continue
        numbers = np.array([step.index for step in steps])
        row = compiled.state_row(bits, compiled.words(task))
        goal_numbers = np.array(RelaxedTask(task).propositions(goal))
        plain = [step.index for step in refined(bits, steps, wanted)]
        assert kernel.refined(array, row, numbers, goal_numbers).tolist() == plain
        changed += plain != numbers.tolist()
    assert changed > 10


@needs_numba
@pytest.mark.slow
def test_one_compilation_serves_every_task() -> None:
    task, asked = problems((1, 1, 1, 1, 1), seed=5, number=3)
    fast = make_planner(task, path="compiled")
    for question in asked:
        fast.plan(*question)
    from verbteach.world import kernel

    assert len(kernel.search.signatures) == 1  # type: ignore[attr-defined]


@needs_numba
@pytest.mark.slow
def test_torn_compiled_code_on_the_disk_is_made_anew(tmp_path: Path) -> None:
    assert compiled.warm_up()
    from verbteach.world import kernel

    folder = tmp_path / "world_0"
    source = Path(kernel.search.stats.cache_path)  # type: ignore[attr-defined]
    shutil.copytree(
        source, folder, ignore=lambda _, names: [n for n in names if "kernel." not in n]
    )
    code = "from verbteach.world import compiled, kernel; print(kernel.search.stats.cache_path)"
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    run = [sys.executable, "-c", code]
    place = Path(
        subprocess.run(
            run, env=environment, capture_output=True, check=True, text=True
        ).stdout.strip()
    )
    folder.rename(place)
    for index in place.glob("kernel.search-*.nbi"):
        index.write_bytes(index.read_bytes()[:40])
    code = "from verbteach.world import compiled; print(compiled.warm_up())"
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, check=True, text=True
    )
    assert done.stdout.strip() == "True"


def test_nothing_is_compiled_or_imported_unasked() -> None:
    code = (
        "import sys\n"
        "from tests.world import kitchenette\n"
        "from verbteach.world.fluents import Literal\n"
        "from verbteach.world.planner import make_planner\n"
        "from verbteach.world.task import Task\n"
        "task = Task(kitchenette.domain(), {}, frozenset())\n"
        "print(make_planner(task).plan(frozenset(), frozenset({Literal.parse('(running)')})))\n"
        "assert 'numba' not in sys.modules\n"
    )
    root = Path(__file__).parent.parent.parent
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=root, capture_output=True, check=True, text=True
    )
    assert "turn" in done.stdout


class _Ready:
    """Stands in for the compiled search and tells that it was asked."""

    asked = 0

    def __init__(self, task: Task, relaxed: RelaxedTask) -> None:
        self._plain = PlainEngine(task, relaxed)

    def search(self, bits: int, goal: tuple[int, ...], limits: SearchLimits) -> Steps | Exhausted:
        _Ready.asked += 1
        return self._plain.search(bits, goal, limits)


def test_the_compiled_search_takes_over_once_it_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    task, asked = problems((1, 1, 1, 1, 1), seed=7, number=2)
    automatic = make_planner(task, PlannerConfig(remembered=0))
    assert isinstance(automatic.engine, AutoEngine)
    monkeypatch.setattr(compiled, "available", lambda: False)
    first = automatic.plan(*asked[1])
    monkeypatch.setattr(compiled, "CompiledEngine", _Ready)
    monkeypatch.setattr(compiled, "available", lambda: True)
    assert automatic.plan(*asked[1]) == first
    assert _Ready.asked == 1


def test_asking_for_what_is_not_installed_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "_kernel", None)
    monkeypatch.setattr(compiled, "find_spec", lambda _: None)
    assert not compiled.warm_up()
    with pytest.raises(RuntimeError, match="fast"):
        make_planner(Task(DOMAIN, {}, frozenset()), path="compiled")
    task = Task(DOMAIN, {}, frozenset())
    assert isinstance(make_planner(task).plan(frozenset(), frozenset()), Plan)
    assert isinstance(make_planner(task, path="plain"), SearchPlanner)
