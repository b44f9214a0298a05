"""Doing actions, and saying as data why one cannot be done."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.world import kitchenette, naive
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach.world.simulator import (
    InapplicableError,
    Unequal,
    UnknownAction,
    UnknownObject,
    Unmet,
    WrongNumber,
    WrongType,
    applicable,
    apply,
    explain,
    run,
)
from verbteach.world.task import Task

DOMAIN = kitchenette.domain()
OBJECTS = {**DOMAIN.constants, **kitchenette.objects((2, 1, 2, 1, 1))}
START = frozenset(
    {
        Fluent("hinged", ("Box_1",)),
        Fluent("on", ("Cup_1", "Shelf_1")),
        Fluent("in", ("Cup_2", "Box_1")),
        Fluent("enclosed", ("Cup_2",)),
    }
)
TASK = Task(DOMAIN, OBJECTS, START)


def act(text: str) -> Action:
    return Action.parse(text)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_states_and_reasons_agree_with_the_domain(seed: int) -> None:
    rng = np.random.default_rng(seed)
    start = kitchenette.start(OBJECTS, rng)
    task = Task(DOMAIN, OBJECTS, start)
    state = kitchenette.walk(task, start, int(rng.integers(12)), rng)
    ready = applicable(task, state)
    assert set(ready) == naive.applicable(DOMAIN, OBJECTS, state)
    for schema in DOMAIN.actions.values():
        for binding in naive.bindings(DOMAIN, OBJECTS, schema.parameters):
            action = Action(schema.name, tuple(binding.values()))
            assert (explain(task, state, action) == ()) == (action in ready)
    for action in ready:
        assert apply(task, state, action) == naive.apply(DOMAIN, OBJECTS, state, action)


def test_fluents_outside_the_task_stay() -> None:
    extra = Fluent("dusty", ("Shelf_1",))
    after = apply(TASK, START | {extra}, act("moveto Cup_1"))
    assert after == START | {extra, Fluent("near", ("Cup_1",))}


def test_a_run_stops_at_the_first_action_that_cannot_be_done() -> None:
    actions = [act("moveto Cup_1"), act("grasp Cup_1"), act("grasp Cup_2"), act("turn")]
    states = run(TASK, START, actions)
    assert len(states) == 3
    assert states[0] == START
    assert states[1] == apply(TASK, START, actions[0])
    assert states[2] == apply(TASK, states[1], actions[1])
    assert run(TASK, START, []) == [START]


@settings(max_examples=30, deadline=None)
@given(st.lists(st.sampled_from([g.action for g in TASK.actions]), max_size=8))
def test_a_run_is_one_application_after_another(actions: list[Action]) -> None:
    states = run(TASK, START, actions)
    for before, action, after in zip(states, actions, states[1:], strict=False):
        assert apply(TASK, before, action) == after
    if len(states) <= len(actions):
        assert explain(TASK, states[-1], actions[len(states) - 1]) != ()


def test_the_states_of_a_run_are_the_callers_own() -> None:
    actions = applicable(TASK, START)[:1]
    first = run(TASK, START, actions)
    first.clear()
    assert run(TASK, START, iter(actions)) == [START, apply(TASK, START, actions[0])]


@pytest.mark.parametrize(
    ("text", "obstacles"),
    [
        ("fly Cup_1", (UnknownAction("fly"),)),
        ("grasp", (WrongNumber("grasp", 1, 0),)),
        ("grasp Cup_7", (UnknownObject("Cup_7"),)),
        ("grasp Shelf_1", (WrongType("Shelf_1", "item", "fixture"),)),
        (
            "putin Shelf_1 Cup_7",
            (WrongType("Shelf_1", "item", "fixture"), UnknownObject("Cup_7")),
        ),
        (
            "grasp Cup_2",
            (
                Unmet(Literal(Fluent("near", ("Cup_2",)))),
                Unmet(Literal(Fluent("enclosed", ("Cup_2",)), positive=False)),
            ),
        ),
        (
            "open Box_2",
            (
                Unmet(Literal(Fluent("near", ("Box_2",)))),
                Unmet(Literal(Fluent("hinged", ("Box_2",))), static=True),
            ),
        ),
        (
            "puton Cup_1 Cup_1",
            (
                Unmet(Literal(Fluent("holding", ("Cup_1",)))),
                Unmet(Literal(Fluent("near", ("Cup_1",)))),
                Unequal("Cup_1", "Cup_1", positive=False),
            ),
        ),
    ],
)
def test_the_reason_is_told_as_data(text: str, obstacles: tuple[object, ...]) -> None:
    assert explain(TASK, START, act(text)) == obstacles
    with pytest.raises(InapplicableError) as caught:
        apply(TASK, START, act(text))
    assert caught.value.obstacles == obstacles
    assert caught.value.action == act(text)
