"""A small collection of instances in the test kitchen, and a bench to experiment on."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from tests.world import kitchenette
from verbteach.experiments.interactive_bench import Bench, BenchParameters
from verbteach.experiments.workroom import furnish
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Fluent, Goal, Literal, State
from verbteach.world.plan import Plan
from verbteach.world.planner import PlannerConfig, SearchPlanner
from verbteach.world.simulator import run
from verbteach.world.task import Task

THINGS = kitchenette.objects((2, 1, 1, 1, 1))
KEY = "kitchenette"


@lru_cache(maxsize=1)
def task() -> Task:
    domain = kitchenette.domain()
    static = frozenset({Fluent("hinged", ("Box_1",))})
    return Task(domain, {**THINGS, **domain.constants}, static)


def wanted(verb: str, cup: str) -> Goal:
    if verb == "wash":
        return frozenset({Literal(Fluent("wet", (cup,))), Literal(Fluent("running"), False)})
    if verb == "heat":
        return frozenset({Literal(Fluent("hot", (cup,)))})
    return frozenset({Literal(Fluent("in", (cup, "Box_1")))})


def instance(environment: int, number: int, verb: str, planner: SearchPlanner) -> Instance | None:
    rng = np.random.default_rng([environment, number])
    state: State = kitchenette.start(THINGS, np.random.default_rng(environment))
    state = (state - {Fluent("hinged", ("Box_1",))}) | task().static
    cup = f"Cup_{1 + int(rng.integers(2))}"
    answer = planner.plan(state, wanted(verb, cup))
    if not isinstance(answer, Plan) or not answer.actions:
        return None
    both = ("Cup_1", "Cup_2")
    return Instance(
        id=f"{environment:02d}-{number:02d}-{verb}",
        group=f"document-{environment}-{number}",
        environment=f"room-{environment}",
        verb=verb,
        phrases=("cup",),
        candidates=(both,),
        grounding=(cup,),
        start=state,
        actions=answer.actions,
        end=run(task(), state, answer.actions)[-1],
        goal=None,
        task_key=KEY,
    )


@lru_cache(maxsize=1)
def instances() -> tuple[Instance, ...]:
    planner = SearchPlanner(task(), PlannerConfig(expansions=2000))
    found = (
        instance(environment, number, verb, planner)
        for environment in range(6)
        for number in range(3)
        for verb in ("wash", "heat", "stow")
    )
    return tuple(sorted((one for one in found if one is not None), key=lambda one: one.id))


def bench(parameters: BenchParameters | None = None) -> Bench:
    rooms = furnish({KEY: task()}, lambda grounded: SearchPlanner(grounded, PlannerConfig(500)))
    return Bench(instances(), rooms, parameters or BenchParameters())
