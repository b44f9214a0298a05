"""How long the own planner takes for a plan, in the plain and the compiled way."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from verbteach.world import compiled
from verbteach.world.plan import Plan
from verbteach.world.planner import PlannerConfig, PlannerPath, SearchPlanner, make_planner
from verbteach_tui.bench.allowance import Allowance
from verbteach_tui.bench.clock import percentiles, timed
from verbteach_tui.bench.questions import Question

UNREMEMBERED = PlannerConfig(remembered=0)


def paths() -> tuple[PlannerPath, ...]:
    """The ways to plan that this installation has, the quickest last."""
    return ("plain", "compiled") if compiled.installed() else ("plain",)


def measure(
    questions: Sequence[Question],
    path: PlannerPath,
    done: Callable[[int], None],
    allowance: Allowance | None = None,
) -> dict[str, Any]:
    """Times of one call a question, tasks ready and nothing remembered from call to call.

    Where the allowance runs out, the questions asked by then are all there is.
    """
    planners: dict[int, SearchPlanner] = {}
    times, lengths = [], []
    for number, question in enumerate(questions, start=1):
        if allowance is not None and allowance.over():
            break
        key = id(question.task)
        if key not in planners:
            planners[key] = make_planner(question.task, UNREMEMBERED, path)
        planner = planners[key]
        spent, answer = timed(lambda: planner.plan(question.state, question.goal))  # noqa: B023
        times.append(spent)
        if isinstance(answer, Plan):
            lengths.append(len(answer.actions))
        done(number)
    return {
        **percentiles(times),
        "path": path,
        "questions": len(times),
        "solved": len(lengths),
        "steps": percentiles(lengths),
    }
