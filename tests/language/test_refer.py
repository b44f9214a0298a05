"""Referring expressions in the bundled rooms: found, told apart, and never guessed."""

from __future__ import annotations

from functools import cache

import pytest

from verbteach.language.frames import NounPhrase
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.refer import distinguish, refer
from verbteach.world.fluents import Fluent
from verbteach_scenarios.lexicon_file import load_lexicon
from verbteach_scenarios.scenes import load_scene, scene_ids

ROOMS = scene_ids()


@cache
def looks(scene: str = "kitchen-1") -> Looks:
    found = load_scene(scene)
    return Looks(found, found.initial, load_lexicon())


def phrase(text: str, room: Looks) -> NounPhrase:
    vocabulary = [name for thing in room.objects.values() for name in thing.names]
    (frame,) = parse(f"take {text}", room.lexicon, vocabulary)
    return frame.phrases[0]


def meant(text: str, room: Looks | None = None, spoken: tuple[str, ...] = ()) -> list[str]:
    room = room or looks()
    return [thing for thing, _ in refer(phrase(text, room), room, spoken)]


@pytest.mark.parametrize("scene", ROOMS)
def test_what_singles_an_object_out_refers_back_to_it_alone(scene: str) -> None:
    room = looks(scene)
    for thing in room.objects:
        told = distinguish(thing, room)
        if told.rpartition(" ")[2].isdecimal():
            continue  # only its number tells it from its like
        found = refer(phrase(told, room), room)
        if room.is_thing(thing):
            assert found, told
            assert found[0][0] == thing, (told, found)
            others = [o for o, w in found[1:] if w == found[0][1] and room.is_thing(o)]
            assert not others, (told, found)


@pytest.mark.parametrize("scene", ROOMS)
def test_no_two_things_get_the_same_description(scene: str) -> None:
    room = looks(scene)
    told = [distinguish(thing, room) for thing in room.objects if room.is_thing(thing)]
    assert len(set(told)) == len(told)


@pytest.mark.parametrize(
    ("text", "objects"),
    [
        ("the blue mug", ["Mug_2"]),
        ("the mug on the table", ["Mug_1"]),
        ("the dirty mug", ["Mug_2"]),
        ("the red mug", ["Mug_1", "Mug_3"]),
        ("the kettle with water", ["Kettle_1"]),
        ("the left burner", ["Burner_1"]),
        ("the water", ["Water"]),
        ("the unicorn", []),
        ("the mug in the sink", []),
        ("a purple mug", []),
        ("the big pot", ["Pot_1", "Kettle_1"]),
        ("the thing next to the sink", ["Sponge_1"]),
    ],
)
def test_names_looks_states_contents_and_relations(text: str, objects: list[str]) -> None:
    assert meant(text) == objects


def test_pronouns_and_the_other_one_look_at_what_was_spoken_of() -> None:
    assert meant("it", spoken=("Mug_1", "Pot_1")) == ["Pot_1"]
    assert meant("them", spoken=("Mug_1", "Pot_1")) == ["Mug_1", "Pot_1"]
    assert meant("it") == []
    assert meant("the other one", spoken=("Mug_1",)) == ["Mug_2", "Mug_3"]
    assert meant("the blue one", spoken=("Mug_1",)) == ["Mug_2"]


def test_a_word_for_a_thing_and_for_its_contents_is_told_by_the_role() -> None:
    room = looks()
    beer = phrase("the beer", room)
    assert refer(beer, room)[0][0] == "Beer_1"
    assert refer(beer, room, (), "with")[0][0] == "Beer"


def test_a_relation_follows_the_world() -> None:
    room = looks()
    moved = room.state - {Fluent("on", ("Mug_1", "Table_1"))} | {Fluent("in", ("Mug_1", "Sink_1"))}
    later = Looks(room.scene, moved, room.lexicon)
    assert meant("the mug in the sink", later) == ["Mug_1"]
    assert meant("the mug on the table", later) == []
