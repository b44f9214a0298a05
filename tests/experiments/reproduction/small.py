"""A reproduction small enough for tests, in the test kitchen; its rows are made once."""

from __future__ import annotations

from functools import lru_cache

from tests.experiments.interactive_room import KEY, bench, task
from verbteach.experiments.evaluation import Grounds
from verbteach.experiments.interactive_protocol import Config
from verbteach.experiments.interactive_training import TrainingParameters
from verbteach.experiments.reproduction.design import Design
from verbteach.experiments.reproduction.laboratory import Laboratory
from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.reproduction.sweep import sweep
from verbteach.world.planner import PlannerConfig, SearchPlanner
from verbteach.world.task import Task as GroundedTask

BASE = Config(groups=2, training=TrainingParameters(dialogues=60, warm=20))


def planner(grounded: GroundedTask) -> SearchPlanner:
    return SearchPlanner(grounded, PlannerConfig(500))


@lru_cache(maxsize=1)
def laboratory() -> Laboratory:
    return Laboratory(bench(), Grounds((), {KEY: task()}, planner))


def design(**changes: object) -> Design:
    parts: dict[str, object] = {"runs": 2, "groups": 3, "base": BASE, **changes}
    return Design(laboratory().environments, **parts)  # type: ignore[arg-type]


@lru_cache(maxsize=1)
def rows() -> dict[str, Row]:
    """Table 5 and Figure 5 at one noise level, by key."""
    tasks = design(targets=("table5", "figure5")).sections()["main"]
    return sweep(tasks, laboratory().row)
