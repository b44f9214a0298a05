"""Whether a scene file's own goal, if it has one, can be reached from its start."""

from __future__ import annotations

import re
from pathlib import Path

from verbteach.world.fluents import Goal
from verbteach.world.plan import PlanFailure
from verbteach.world.scene import Scene
from verbteach_scenarios.errors import SceneFileError


def check_goal(scene: Scene, goal: Goal, path: Path, text: str) -> None:
    """Raise ``SceneFileError`` at the goal's line if no plan reaches it; an empty goal is none."""
    if not goal:
        return
    from verbteach.world.planner import SearchPlanner  # noqa: PLC0415 - only for such files
    from verbteach.world.task import Task  # noqa: PLC0415

    answer = SearchPlanner(Task.from_scene(scene)).plan(scene.initial, goal)
    if isinstance(answer, PlanFailure):
        said = " ".join(str(literal) for literal in sorted(goal))
        why = f"{answer.reason.value} {answer.detail}".strip()
        reason = f"its goal {said} cannot be reached from its start ({why})"
        raise SceneFileError(path, _goal_line(text), reason)


def _goal_line(text: str) -> int:
    lines = enumerate(text.splitlines(), start=1)
    return next((number for number, line in lines if re.search(r"^[^;]*:goal\b", line)), 0)
