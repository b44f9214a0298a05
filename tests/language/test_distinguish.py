"""What the robot calls a thing is what it understands, whatever the world has come to."""

from __future__ import annotations

import numpy as np
import pytest

from tests.language.rooms import looks, phrase
from verbteach.language.distinguish import distinguish, distinguish_by_looks, glimpse
from verbteach.language.looks import Looks
from verbteach.language.refer import refer
from verbteach.world.simulator import applicable, apply
from verbteach.world.task import Task
from verbteach_scenarios.scenes import scene_ids

ROOMS = scene_ids()


def _things(room: Looks) -> list[str]:
    return [thing for thing in room.objects if room.is_thing(thing)]


def _refers_back(room: Looks) -> None:
    for thing in _things(room):
        told = distinguish(thing, room)
        found = refer(phrase(told, room), room)
        assert found, told
        assert [o for o, weight in found if weight == found[0][1]] == [thing], told


@pytest.mark.parametrize("scene", ROOMS)
def test_a_description_refers_back_to_its_object_alone(scene: str) -> None:
    _refers_back(looks(scene))


@pytest.mark.slow
@pytest.mark.parametrize("scene", ROOMS)
def test_it_still_does_after_things_have_happened(scene: str) -> None:
    room = looks(scene)
    task = Task.from_scene(room.scene)
    state, draws = room.state, np.random.default_rng(7)
    for step in range(40):
        actions = applicable(task, state)
        state = apply(task, state, actions[draws.integers(len(actions))])
        if step % 20 == 19:
            _refers_back(Looks(room.scene, state, room.lexicon))


@pytest.mark.parametrize("scene", ROOMS)
def test_no_two_things_get_the_same_description(scene: str) -> None:
    room = looks(scene)
    told = [distinguish(thing, room) for thing in _things(room)]
    assert len(set(told)) == len(told)


def test_by_looks_alone_a_place_is_never_told() -> None:
    room = looks()
    assert distinguish("Mug_1", room) == "the mug on the table"
    assert distinguish_by_looks("Mug_1", room) == "the red ceramic mug"
    for thing in _things(room):
        assert " on the " not in distinguish_by_looks(thing, room)
        assert " in the " not in distinguish_by_looks(thing, room)


def test_the_shortest_description_wins() -> None:
    room = looks()
    assert distinguish("Fridge_1", room) == "the fridge"
    assert distinguish("Mug_2", room) == "the blue mug"
    assert distinguish("Mug_3", room) == "the plastic mug"
    assert distinguish("Mug_1", room) == "the mug on the table"


def test_among_few_less_has_to_be_said() -> None:
    room = looks()
    assert distinguish("Mug_1", room, ["Mug_1", "Mug_2"]) == "the red mug"
    assert distinguish("Mug_1", room, ["Pot_1"]) == "the mug"


def test_values_and_strangers_have_words_too() -> None:
    room = looks()
    assert distinguish("Water", room) == "the water"
    assert distinguish("Nowhere_9", room) == "Nowhere_9"


def test_a_glimpse_names_no_kind() -> None:
    room = looks()
    assert glimpse("Kettle_1", room) == "a large silver object on the counter"
    assert glimpse("Apple_1", room).startswith("a ")
    assert "apple" not in glimpse("Apple_1", room)
