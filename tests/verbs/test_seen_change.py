from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.world import kitchenette
from verbteach.perception.belief import Belief
from verbteach.perception.noise import NoiseModel, perceive
from verbteach.verbs.change import StateChange
from verbteach.verbs.seen_change import observed_change, seen_change
from verbteach.world.fluents import State
from verbteach.world.plan import Action
from verbteach.world.simulator import run
from verbteach.world.task import Task


def task(seed: int) -> tuple[Task, State, np.random.Generator]:
    rng = np.random.default_rng(seed)
    things = kitchenette.objects((2, 1, 1, 1, 1))
    state = kitchenette.start(things, rng)
    domain = kitchenette.domain()
    return Task(domain, {**things, **domain.constants}, state), state, rng


def walked(grounded: Task, state: State, rng: np.random.Generator) -> tuple[list[Action], State]:
    actions: list[Action] = []
    bits = grounded.encode(state)
    for _ in range(4):
        fitting = [a for a in grounded.actions if a.applicable(bits)]
        chosen = fitting[int(rng.integers(len(fitting)))]
        actions.append(chosen.action)
        bits = chosen.result(bits)
    return actions, run(grounded, state, actions)[-1]


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000))
def test_with_perfect_eyes_the_change_is_seen_as_it_is(seed: int) -> None:
    grounded, state, rng = task(seed)
    actions, end = walked(grounded, state, rng)
    seen = seen_change(grounded, Belief.certain(state), Belief.certain(end), actions)
    assert seen.likely == StateChange.between(state, end, grounded.domain.static).literals


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000))
def test_nothing_that_changed_is_held_for_impossible(seed: int) -> None:
    grounded, state, rng = task(seed)
    actions, end = walked(grounded, state, rng)
    noise = NoiseModel.named("uniform")
    before, after = perceive(state, (), noise, rng), perceive(end, (), noise, rng)
    true = StateChange.between(state, end, grounded.domain.static).literals
    assert true <= seen_change(grounded, before, after, actions).table.keys()


def test_knowing_the_actions_beats_trusting_the_eyes() -> None:
    by_eye = by_model = 0
    noise = NoiseModel.named("std5")
    for seed in range(30):
        grounded, state, rng = task(seed)
        actions, end = walked(grounded, state, rng)
        before, after = perceive(state, (), noise, rng), perceive(end, (), noise, rng)
        true = StateChange.between(state, end, grounded.domain.static).literals
        looked = observed_change(before, after, sorted(grounded.fluents))
        by_eye += len(looked.likely ^ true)
        by_model += len(seen_change(grounded, before, after, actions).likely ^ true)
    assert by_model < by_eye / 2


def test_an_answer_settles_a_literal() -> None:
    grounded, state, rng = task(3)
    actions, end = walked(grounded, state, rng)
    noise = NoiseModel.named("uniform")
    before, after = perceive(state, (), noise, rng), perceive(end, (), noise, rng)
    seen = seen_change(grounded, before, after, actions)
    literal, _ = seen.chances[0]
    assert literal in seen.answered(literal, True).likely
    assert literal not in seen.answered(literal, False).likely
