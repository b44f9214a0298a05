"""The same question has the same answer in every process, whatever the order of hashing."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

CODE = """
import numpy as np
from tests.world import kitchenette
from verbteach.world.planner import make_planner
from verbteach.world.simulator import applicable
from verbteach.world.task import Task
domain = kitchenette.domain()
rng = np.random.default_rng(11)
things = {**domain.constants, **kitchenette.objects((5, 4, 3, 2, 3))}
start = kitchenette.start(things, rng)
task = Task(domain, things, start)
planner = make_planner(task, path="plain")
print(*map(str, task.fluents))
for _ in range(25):
    state = kitchenette.walk(task, start, int(rng.integers(20)), rng)
    goal = kitchenette.reached_goal(task, state, rng, 30, 5)
    print(planner.plan(state, goal))
    print(planner.plan(state, kitchenette.goal(task, rng, 2)))
    print(*applicable(task, state))
"""


def test_hash_seeds_change_nothing() -> None:
    said = [
        subprocess.run(
            [sys.executable, "-c", CODE],
            cwd=Path(__file__).parents[2],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("0", "1", "4242")
    ]
    assert said[0] == said[1] == said[2]
    assert said[0].count(b"Plan(") > 20
