"""The grounded task means what the domain means."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.world import kitchenette, naive
from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action
from verbteach.world.scene import Scene, SceneObject
from verbteach.world.simulator import apply
from verbteach.world.task import Task
from verbteach_scenarios.pddl import parse_domain

DOMAIN = kitchenette.domain()
OBJECTS = {**DOMAIN.constants, **kitchenette.objects((2, 1, 2, 1, 1))}
seeds = st.integers(0, 2**32 - 1)


def random_world(seed: int) -> tuple[Task, State, np.random.Generator]:
    rng = np.random.default_rng(seed)
    start = kitchenette.start(OBJECTS, rng)
    task = Task(DOMAIN, OBJECTS, start)
    return task, kitchenette.walk(task, start, int(rng.integers(12)), rng), rng


@settings(max_examples=60, deadline=None)
@given(seeds)
def test_the_same_actions_can_be_done_as_by_the_domain_itself(seed: int) -> None:
    task, state, _ = random_world(seed)
    bits = task.encode(state)
    done = [ground.action for ground in task.actions if ground.applicable(bits)]
    assert len(done) == len(set(done))
    assert set(done) == naive.applicable(DOMAIN, OBJECTS, state)


@settings(max_examples=60, deadline=None)
@given(seeds)
def test_actions_do_what_the_domain_says(seed: int) -> None:
    task, state, _ = random_world(seed)
    bits = task.encode(state)
    for ground in task.actions:
        if ground.applicable(bits):
            expected = naive.apply(DOMAIN, OBJECTS, state, ground.action)
            assert task.decode(ground.result(bits)) == expected
            assert apply(task, state, ground.action) == expected


@settings(deadline=None)
@given(seeds)
def test_encoding_and_decoding_are_each_other_reversed(seed: int) -> None:
    task, state, rng = random_world(seed)
    assert task.decode(task.encode(state)) == state
    bits = int.from_bytes(rng.bytes(len(task.fluents) // 8 + 1), "little")
    bits &= (1 << len(task.fluents)) - 1
    assert task.encode(task.decode(bits)) == bits


def test_order_is_that_of_schemas_then_names_however_objects_come() -> None:
    start = kitchenette.start(OBJECTS, np.random.default_rng(3))
    task = Task(DOMAIN, OBJECTS, start)
    other = Task(DOMAIN, dict(reversed(OBJECTS.items())), start)
    assert task.actions == other.actions
    assert task.fluents == other.fluents == tuple(sorted(task.fluents))
    schemas = list(DOMAIN.actions)
    keys = [(schemas.index(g.action.name), g.action.args) for g in task.actions]
    assert keys == sorted(keys)
    assert [g.index for g in task.actions] == list(range(len(task.actions)))


def test_grounding_prunes_on_static_facts_and_equality_alone() -> None:
    start = frozenset({Fluent("hinged", ("Box_1",)), Fluent("open", ("Box_2",))})
    task = Task(DOMAIN, OBJECTS, start)
    assert task.action(Action("open", ("Box_1",))) is not None
    assert task.action(Action("open", ("Box_2",))) is None
    assert task.action(Action("puton", ("Cup_1", "Cup_1"))) is None
    assert task.action(Action("puton", ("Cup_1", "Cup_2"))) is not None
    assert task.action(Action("putin", ("Cup_1", "Box_1"))) is not None
    assert task.action(Action("fly", ())) is None


def test_static_facts_of_a_state_are_not_changed_by_what_is_asked() -> None:
    task = Task(DOMAIN, OBJECTS, frozenset({Fluent("hinged", ("Box_1",))}))
    assert task.static == {Fluent("hinged", ("Box_1",))}
    assert task.decode(task.encode(frozenset({Fluent("running")}))) == {
        Fluent("hinged", ("Box_1",)),
        Fluent("running"),
    }


@pytest.mark.parametrize(
    ("fluent", "known"),
    [
        (Fluent("on", ("Cup_1", "Shelf_1")), True),
        (Fluent("hinged", ("Box_1",)), True),
        (Fluent("on", ("Shelf_1", "Cup_1")), False),
        (Fluent("on", ("Cup_1",)), False),
        (Fluent("on", ("Cup_9", "Shelf_1")), False),
        (Fluent("under", ("Cup_1", "Shelf_1")), False),
    ],
)
def test_fluents_of_the_domain_are_told_from_others(fluent: Fluent, known: bool) -> None:
    assert Task(DOMAIN, OBJECTS, frozenset()).is_fluent(fluent) == known


def test_a_scene_is_grounded_with_its_own_objects_and_facts() -> None:
    start = frozenset({Fluent("hinged", ("Box_1",)), Fluent("running")})
    things = {name: SceneObject(name, kind) for name, kind in OBJECTS.items()}
    task = Task.from_scene(Scene("k", "kitchen", "A kitchen", DOMAIN, things, start))
    assert task.actions == Task(DOMAIN, OBJECTS, start).actions


CLASHES = """
(define (domain clashes) (:types thing) (:constants A B - thing)
  (:predicates (p) (q) (r ?x - thing) (s))
  (:action keep :parameters () :precondition (p) :effect (and (p) (not (p))))
  (:action both :parameters () :effect (and (when (p) (q)) (when (s) (not (q)))))
  (:action swap :parameters () :effect (and (when (p) (and (q) (not (p))))
                                            (when (q) (and (p) (not (q))))))
  (:action never :parameters () :precondition (and (p) (not (p))) :effect (q))
  (:action spread :parameters (?x ?y - thing)
    :precondition (and (= ?x ?y) (not (r A))) :effect (forall (?z - thing)
      (when (not (= ?z ?x)) (and (r ?z) (not (r ?x))))))
  (:action flip :parameters (?x - thing) :precondition (r ?x)
    :effect (and (when (r ?x) (not (r ?x))) (when (and (r ?x) (p)) (q))
                 (when (not (r ?x)) (s)))))
"""


def test_deletes_come_before_adds_and_conditions_see_the_old_state() -> None:
    domain = parse_domain(CLASHES)
    task = Task(domain, {}, frozenset())
    assert task.action(Action("never")) is None
    atoms = [Fluent("p"), Fluent("q"), Fluent("s"), Fluent("r", ("A",)), Fluent("r", ("B",))]
    for number in range(2 ** len(atoms)):
        state = frozenset(a for i, a in enumerate(atoms) if number >> i & 1)
        bits = task.encode(state)
        ready = {g.action for g in task.actions if g.applicable(bits)}
        assert ready == naive.applicable(domain, domain.constants, state)
        for action in sorted(ready):
            ground = task.action(action)
            assert ground is not None
            expected = naive.apply(domain, domain.constants, state, action)
            assert task.decode(ground.result(bits)) == expected
            assert apply(task, state, ground.action) == expected
