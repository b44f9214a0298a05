"""Random problems over the small test domain, from a generator that is passed in."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path

import numpy as np

from verbteach.world.domain import Domain
from verbteach.world.fluents import Fluent, Goal, Literal, State
from verbteach.world.task import Task
from verbteach_scenarios.pddl import read_domain

PATH = Path(__file__).parent / "data" / "kitchenette.pddl"

KINDS = (("Cup", "cup"), ("Food", "food"), ("Box", "box"), ("Stove", "stove"), ("Shelf", "fixture"))


@lru_cache(maxsize=1)
def domain() -> Domain:
    """The domain, read once."""
    return read_domain(PATH)


def objects(counts: tuple[int, ...]) -> dict[str, str]:
    """So many cups, foods, boxes, stoves and shelves."""
    return {
        f"{stem}_{i + 1}": kind
        for (stem, kind), count in zip(KINDS, counts, strict=True)
        for i in range(count)
    }


def start(things: Mapping[str, str], rng: np.random.Generator) -> State:
    """Every item somewhere, the hand empty, boxes hinged but for some that stay as they are."""
    facts: set[Fluent] = set()
    items = [name for name, kind in things.items() if kind in ("cup", "food")]
    boxes = [name for name, kind in things.items() if kind == "box"]
    places = [name for name, kind in things.items() if kind in ("stove", "fixture")] + ["Sink_1"]
    for box in boxes:
        facts |= {Fluent("hinged", (box,))} if rng.random() < 0.8 else set()
        facts |= {Fluent("open", (box,))} if rng.random() < 0.4 else set()
    for item in items:
        if boxes and rng.random() < 0.4:
            box = boxes[rng.integers(len(boxes))]
            facts.add(Fluent("in", (item, box)))
            if Fluent("open", (box,)) not in facts:
                facts.add(Fluent("enclosed", (item,)))
        else:
            facts.add(Fluent("on", (item, places[rng.integers(len(places))])))
    return frozenset(facts)


def walk(task: Task, state: State, steps: int, rng: np.random.Generator) -> State:
    """The state after ``steps`` random actions, every kind of action as likely as another."""
    bits = task.encode(state)
    for _ in range(steps):
        choices = [a for a in task.actions if a.applicable(bits)]
        names = sorted({a.action.name for a in choices})
        name = names[rng.integers(len(names))]
        fitting = [a for a in choices if a.action.name == name]
        bits = fitting[rng.integers(len(fitting))].result(bits)
    return task.decode(bits)


def goal(task: Task, rng: np.random.Generator, size: int) -> Goal:
    """``size`` random literals, a third of them negative; often contradictory or unreachable."""
    picked = rng.choice(len(task.fluents), size=min(size, len(task.fluents)), replace=False)
    return frozenset(Literal(task.fluents[i], bool(rng.random() > 0.34)) for i in picked)


def reached_goal(task: Task, state: State, rng: np.random.Generator, steps: int, size: int) -> Goal:
    """Some of what changes along a random walk, so that it can be reached."""
    after = walk(task, state, steps, rng)
    changed = sorted(after ^ state)
    if not changed:
        return frozenset()
    picked = rng.choice(len(changed), size=min(size, len(changed)), replace=False)
    return frozenset(Literal(changed[i], changed[i] in after) for i in picked)
