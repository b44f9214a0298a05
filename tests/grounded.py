"""Rooms grounded once for all tests: most of what a short command or a short session does."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from unittest.mock import patch

from verbteach.world.fluents import State
from verbteach.world.planner import PlannerConfig, SearchPlanner, make_planner
from verbteach.world.relaxed import RelaxedTask
from verbteach.world.scene import Scene
from verbteach.world.task import Task

# By identity, which stays taken: what is kept holds the domain, and the task.
_tasks: dict[tuple[int, tuple[tuple[str, str], ...], State], Task] = {}
_relaxed: dict[int, tuple[Task, RelaxedTask]] = {}


class _Shared:
    """Stands for ``Task`` where scenes are made ready."""

    @staticmethod
    def from_scene(scene: Scene) -> Task:
        things = tuple((name, thing.type) for name, thing in scene.objects.items())
        key = (id(scene.domain), things, scene.initial)
        if key not in _tasks:
            _tasks[key] = Task.from_scene(scene)
        return _tasks[key]


@contextmanager
def rooms_grounded_once() -> Iterator[None]:
    """Settings that are made anew share their tasks; planners remember for themselves."""
    with (
        patch("verbteach_scenarios.settings.Task", _Shared),
        patch("verbteach_scenarios.settings.make_planner", _planner),
    ):
        yield


def _planner(task: Task, config: PlannerConfig) -> SearchPlanner:
    with patch("verbteach.world.planner.RelaxedTask", _relaxation):
        return make_planner(task, config)


def _relaxation(task: Task) -> RelaxedTask:
    if id(task) not in _relaxed:
        _relaxed[id(task)] = (task, RelaxedTask(task))
    return _relaxed[id(task)][1]
