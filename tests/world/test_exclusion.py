"""What is said to exclude each other never holds together in any state that can be reached."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from tests.world import kitchenette
from verbteach.world.exclusion import Exclusions
from verbteach.world.fluents import Fluent, Goal, Literal, State
from verbteach.world.plan import Action, FailureReason, Plan, PlanFailure
from verbteach.world.planner import PlainEngine, PlannerConfig, SearchPlanner
from verbteach.world.relaxed import RelaxedTask
from verbteach.world.search import Exhausted, SearchLimits, Steps
from verbteach.world.task import Task

DOMAIN = kitchenette.domain()
TINY = {**DOMAIN.constants, **kitchenette.objects((1, 0, 1, 1, 0))}
SMALL = {**DOMAIN.constants, **kitchenette.objects((2, 1, 1, 1, 1))}


def reachable(task: Task, bits: int) -> set[int]:
    found, waiting = {bits}, [bits]
    while waiting:
        here = waiting.pop()
        for action in task.actions:
            if action.applicable(here) and (there := action.result(here)) not in found:
                found.add(there)
                waiting.append(there)
    return found


def fluent(text: str) -> Fluent:
    return Fluent.parse(text)


def wanted(*texts: str) -> Goal:
    return frozenset(Literal(fluent(text)) for text in texts)


@pytest.mark.parametrize("seed", range(12))
def test_no_pair_is_ever_reached(seed: int) -> None:
    start = kitchenette.start(TINY, np.random.default_rng(seed))
    task = Task(DOMAIN, TINY, start)
    exclusions, bits = Exclusions(task), task.encode(start)
    met = reachable(task, bits)
    for one, other in combinations(task.bit.values(), 2):
        if exclusions.pair(bits, one | other) is not None:
            assert not any(state & one and state & other for state in met)


@pytest.mark.parametrize(
    ("one", "other", "excluded"),
    [
        ("(on Cup_1 Shelf_1)", "(on Cup_1 Stove_1)", True),
        ("(on Cup_1 Shelf_1)", "(in Cup_1 Box_1)", True),
        ("(holding Cup_1)", "(on Cup_1 Shelf_1)", True),
        ("(on Cup_1 Shelf_1)", "(on Cup_2 Shelf_1)", False),
        ("(near Cup_1)", "(on Cup_1 Shelf_1)", False),
        ("(hot Cup_1)", "(on Cup_1 Stove_1)", False),
    ],
)
def test_a_thing_is_in_one_place(one: str, other: str, excluded: bool) -> None:
    start = frozenset({fluent("(on Cup_2 Shelf_1)")})
    task = Task(DOMAIN, SMALL, start)
    both = task.bit[fluent(one)] | task.bit[fluent(other)]
    pair = Exclusions(task).pair(task.encode(start), both)
    assert (pair is not None) == excluded
    assert pair is None or set(pair) == {fluent(one), fluent(other)}


def test_nothing_is_concluded_from_a_start_that_cannot_be() -> None:
    places = frozenset({fluent("(on Cup_1 Shelf_1)"), fluent("(on Cup_1 Stove_1)")})
    task = Task(DOMAIN, SMALL, frozenset())
    bits = task.encode(places)
    assert Exclusions(task).pair(bits, bits) is None
    goal = wanted("(on Cup_1 Shelf_1)", "(on Cup_1 Stove_1)", "(near Cup_2)")
    answer = SearchPlanner(task).plan(places, goal)
    assert answer == Plan((Action("moveto", ("Cup_2",)),))


class Counting(PlainEngine):
    """Counts how often it is asked."""

    asked = 0

    def search(self, bits: int, goal: tuple[int, ...], limits: SearchLimits) -> Steps | Exhausted:
        self.asked += 1
        return super().search(bits, goal, limits)


def world() -> tuple[Task, State]:
    state = frozenset({fluent("(on Cup_1 Shelf_1)"), fluent("(on Cup_2 Shelf_1)")})
    return Task(DOMAIN, SMALL, state), state


def test_contradictions_are_named_and_searched_for_once_at_most() -> None:
    task, state = world()
    engine = Counting(task, RelaxedTask(task))
    planner = SearchPlanner(task, PlannerConfig(expansions=50), engine)
    first = planner.plan(state, wanted("(holding Cup_1)", "(on Cup_1 Stove_1)"))
    assert first == PlanFailure(
        FailureReason.UNREACHABLE, "(holding Cup_1) with (on Cup_1 Stove_1)"
    )
    second = wanted("(in Cup_2 Box_1)", "(on Cup_2 Stove_1)", "(wet Cup_1)")
    before = engine.asked
    answer = planner.plan(state, second)
    assert engine.asked == before
    assert SearchPlanner(task, PlannerConfig(expansions=50)).plan(state, second) == answer
