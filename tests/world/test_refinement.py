"""Needless steps go, steps stand near their use, and nothing that matters is lost."""

from __future__ import annotations

import numpy as np
import pytest

from tests.world import kitchenette
from verbteach.world.fluents import Fluent, Goal, Literal, State, satisfied
from verbteach.world.plan import Action
from verbteach.world.refinement import EncodedGoal, refined, without_needless
from verbteach.world.simulator import run
from verbteach.world.task import GroundAction, Task
from verbteach_scenarios.pddl import parse_domain

DOMAIN = kitchenette.domain()
SMALL = {**DOMAIN.constants, **kitchenette.objects((3, 2, 2, 1, 2))}

# As in the corpus: the robot stays near whatever it went to, and holds any number of things.
LOOSE = parse_domain(
    """(define (domain loose) (:types item)
    (:predicates (near ?x - item) (held ?x - item) (on ?x ?y - item) (lit ?x - item))
    (:action moveto :parameters (?x - item) :effect (near ?x))
    (:action grasp :parameters (?x - item) :precondition (near ?x)
      :effect (and (held ?x) (not (near ?x))))
    (:action keep :parameters (?x ?y - item) :precondition (and (held ?x) (near ?y))
      :effect (and (on ?x ?y) (not (held ?x))))
    (:action light :parameters (?x - item) :precondition (near ?x) :effect (lit ?x)))"""
)


def encoded(task: Task, goal: Goal) -> EncodedGoal:
    return EncodedGoal(
        task.encode(frozenset(x.fluent for x in goal if x.positive)),
        task.encode(frozenset(x.fluent for x in goal if not x.positive)),
    )


def steps(task: Task, *texts: str) -> list[GroundAction]:
    found = [task.action(Action.parse(text)) for text in texts]
    return [ground for ground in found if ground is not None]


def told(plan: list[GroundAction]) -> list[str]:
    return [str(step.action) for step in plan]


def goal_of(*texts: str) -> Goal:
    return frozenset(Literal.parse(text) for text in texts)


def test_each_move_comes_to_stand_before_its_use() -> None:
    task = Task(LOOSE, {"A": "item", "B": "item"}, frozenset())
    plan = steps(task, "moveto B", "moveto A", "grasp A", "keep A B")
    assert told(refined(0, plan, encoded(task, goal_of("(on A B)")))) == [
        "moveto A",
        "grasp A",
        "moveto B",
        "keep A B",
    ]


def test_one_purpose_after_another() -> None:
    task = Task(LOOSE, dict.fromkeys("ABT", "item"), frozenset())
    texts = ["moveto T", "moveto A", "moveto B", "grasp A", "grasp B", "keep A T", "keep B T"]
    goal = goal_of("(on A T)", "(on B T)")
    assert told(refined(0, steps(task, *texts), encoded(task, goal))) == [
        "moveto A",
        "grasp A",
        "moveto T",
        "keep A T",
        "moveto B",
        "grasp B",
        "keep B T",
    ]


def test_steps_that_do_not_serve_the_goal_go() -> None:
    task = Task(LOOSE, dict.fromkeys("ABC", "item"), frozenset())
    texts = ["moveto C", "moveto A", "grasp A", "light C", "moveto B", "moveto B", "keep A B"]
    goal = encoded(task, goal_of("(on A B)"))
    kept = told(without_needless(0, steps(task, *texts), goal))
    assert kept == ["moveto A", "grasp A", "moveto B", "keep A B"]


def test_an_order_that_cannot_be_carried_out_is_not_taken() -> None:
    """With the robot near one thing only, going first to the stove would lose the cup."""
    state = frozenset({Fluent("on", ("Cup_1", "Shelf_1"))})
    task = Task(DOMAIN, SMALL, state)
    texts = ["moveto Cup_1", "grasp Cup_1", "moveto Stove_1", "puton Cup_1 Stove_1"]
    texts += ["light Stove_1", "moveto Tap_1", "turn"]
    goal = goal_of("(hot Cup_1)", "(running)")
    plan = refined(task.encode(state), steps(task, *texts), encoded(task, goal))
    assert told(plan) == texts


def wandering(task: Task, state: State, rng: np.random.Generator) -> list[GroundAction]:
    """A long random way, most of it needless."""
    bits = task.encode(state)
    way = []
    for _ in range(40):
        ready = [a for a in task.actions if a.applicable(bits)]
        way.append(ready[rng.integers(len(ready))])
        bits = way[-1].result(bits)
    return way


@pytest.mark.parametrize("seed", range(60))
def test_what_remains_runs_reaches_the_goal_and_cannot_lose_a_step(seed: int) -> None:
    rng = np.random.default_rng(seed)
    start = kitchenette.start(SMALL, rng)
    task = Task(DOMAIN, SMALL, start)
    way = wandering(task, start, rng)
    after = run(task, start, [step.action for step in way])[-1]
    changed = sorted(after ^ start)
    picked = rng.choice(len(changed), size=min(3, len(changed)), replace=False)
    goal = frozenset(Literal(changed[i], changed[i] in after) for i in picked)
    plan = refined(task.encode(start), way, encoded(task, goal))
    assert len(plan) < len(way)
    kept = [step.action for step in plan]
    states = run(task, start, kept)
    assert len(states) == len(kept) + 1
    assert satisfied(goal, states[-1])
    for left_out in range(len(kept)):
        shorter = kept[:left_out] + kept[left_out + 1 :]
        states = run(task, start, shorter)
        assert len(states) <= len(shorter) or not satisfied(goal, states[-1])
