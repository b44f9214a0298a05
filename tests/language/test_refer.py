"""Referring expressions in the bundled rooms: found by every kind of word, never guessed."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.language.rooms import looks, meant, phrase
from tests.language.strategies import WORD_SALADS
from verbteach.language.frames import NounPhrase
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.refer import Verdict, refer, verdict
from verbteach.world.fluents import Fluent
from verbteach_scenarios.scenes import load_scene

MEANT = {
    "an id": ("mug_2", ["Mug_2"]),
    "a colour": ("the blue mug", ["Mug_2"]),
    "a place": ("the mug on the table", ["Mug_1"]),
    "a relative clause": ("the mug that is on the table", ["Mug_1"]),
    "not a place": ("the mug that is not on the table", ["Mug_2", "Mug_3"]),
    "a state": ("the dirty mug", ["Mug_2"]),
    "the opposite of a state": ("the clean mug", ["Mug_1", "Mug_3"]),
    "many": ("the red mug", ["Mug_1", "Mug_3"]),
    "contents": ("the kettle with water", ["Kettle_1"]),
    "full of": ("the kettle full of water", ["Kettle_1"]),
    "a position": ("the left burner", ["Burner_1"]),
    "a position behind": ("the burner on the left", ["Burner_1"]),
    "the thing at a position": ("the knob on the right", ["StoveKnob_2"]),
    "a substance": ("the water", ["Water"]),
    "a thing and its contents": ("the beer", ["Beer_1"]),
    "a kind of object": ("a yellow object", ["Cereal_1", "Ramen_1", "Sponge_1"]),
    "a size": ("the big pot", ["Pot_1", "Kettle_1"]),
    "the largest": ("the smallest mug", ["Mug_3"]),
    "next to": ("the thing next to the sink", ["Sponge_1"]),
    "the one next to": ("the one next to the sink", ["Sponge_1"]),
    "a number": ("mug 2", ["Mug_2"]),
    "a count": ("two mugs", ["Mug_1", "Mug_2", "Mug_3"]),
    "mine": ("my blue mug", ["Mug_2"]),
    "a name with of": ("the box of cereal", ["Cereal_1"]),
    "a name in two words": ("the cooking pot", ["Pot_1", "Kettle_1"]),
    "a possessive name": ("the child's mug", ["Mug_3"]),
    "unheard of": ("the unicorn", []),
    "nowhere": ("the mug in the sink", []),
    "no such colour": ("a purple mug", []),
}


@pytest.mark.parametrize(("text", "objects"), MEANT.values(), ids=MEANT.keys())
def test_names_looks_states_contents_and_relations(text: str, objects: list[str]) -> None:
    assert sorted(meant(text)) == sorted(objects)


def test_synonyms_fit_less_well_than_names() -> None:
    found = dict(refer(phrase("the cup"), looks()))
    assert found["Mug_1"] > found["Glass_1"]


def test_pronouns_and_the_other_one_look_at_what_was_spoken_of() -> None:
    assert meant("it", spoken=("Mug_1", "Pot_1")) == ["Pot_1"]
    assert meant("them", spoken=("Mug_1", "Pot_1")) == ["Mug_1", "Pot_1"]
    assert meant("it") == []
    assert meant("the other one", spoken=("Mug_1",)) == ["Mug_2", "Mug_3"]
    assert meant("another mug", spoken=("Mug_1",)) == ["Mug_2", "Mug_3"]
    assert meant("the blue one", spoken=("Mug_1",)) == ["Mug_2"]
    assert meant("the one on the counter", spoken=("Mug_1",)) == ["Mug_2"]
    assert meant("the other window", spoken=("Window_1",)) == []


def test_ordinals_pick_from_what_was_offered() -> None:
    offered = ("Mug_3", "Mug_1", "Mug_2")
    assert meant("the second one", spoken=("Mug_1",), listed=offered) == ["Mug_1"]
    assert meant("the last mug", listed=offered) == ["Mug_2"]
    assert meant("the fifth mug", listed=offered) == []
    assert len(meant("the second mug")) == 3


def test_what_somebody_holds() -> None:
    room = looks()
    holding = Looks(room.scene, room.state | {Fluent("grasping", ("Robot", "Mug_3"))}, room.lexicon)
    assert meant("the thing you are holding", holding) == ["Mug_3"]
    assert meant("the mug that i am holding", holding) == []


def test_a_word_for_a_thing_and_for_its_contents_is_told_by_the_role() -> None:
    room = looks()
    beer = phrase("the beer", room)
    assert refer(beer, room)[0][0] == "Beer_1"
    assert refer(beer, room, (), "with")[0][0] == "Beer"


def test_an_amount_leaves_the_contents_in_play() -> None:
    room = looks()
    some = phrase("some beer", room)
    assert [thing for thing, _ in refer(some, room)] == ["Beer_1", "Beer"]
    assert verdict(some, refer(some, room)) is Verdict.ONE
    assert refer(some, room, (), "with")[0][0] == "Beer"
    assert meant("some beers") == ["Beer_1"]
    assert meant("some mugs") == ["Mug_1", "Mug_2", "Mug_3"]


def test_things_with_names_in_the_plural_are_found() -> None:
    room = Looks(load_scene("living-room-1"), load_scene("living-room-1").initial, looks().lexicon)
    assert "Cartoons" in meant("the cartoons", room)
    assert "Chips_1" in meant("the chips", room)
    assert meant("the pillows", room) == ["Pillow_1", "Pillow_2", "Pillow_3", "Pillow_4"]
    assert meant("the cartoon", room) == []


def test_a_relation_follows_the_world() -> None:
    room = looks()
    moved = room.state - {Fluent("on", ("Mug_1", "Table_1"))} | {Fluent("in", ("Mug_1", "Sink_1"))}
    later = Looks(room.scene, moved, room.lexicon)
    assert meant("the mug in the sink", later) == ["Mug_1"]
    assert meant("the mug on the table", later) == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("the unicorn", Verdict.NONE),
        ("the blue mug", Verdict.ONE),
        ("the pot", Verdict.ONE),
        ("the mug", Verdict.UNCLEAR),
        ("the mugs", Verdict.SEVERAL),
        ("both knobs", Verdict.SEVERAL),
        ("every plate", Verdict.SEVERAL),
    ],
)
def test_empty_and_many_are_told_apart(text: str, expected: Verdict) -> None:
    said = phrase(text)
    assert verdict(said, refer(said, looks())) is expected


@given(WORD_SALADS, st.lists(st.sampled_from(["Mug_1", "Pot_1", "gone"]), max_size=3))
def test_any_phrase_gives_ranked_objects_of_the_scene(text: str, spoken: list[str]) -> None:
    room = looks()
    for frame in parse(text):
        for argument in frame.arguments:
            found = refer(argument.phrase, room, spoken, argument.role)
            assert list(found) == sorted(found, key=lambda row: (-row[1], row[0]))
            assert all(thing in room.objects and weight > 0 for thing, weight in found)
            verdict(argument.phrase, found)


def test_the_lexicon_may_be_empty() -> None:
    room = looks()
    bare = Looks(room.scene, room.state, type(room.lexicon)())
    assert [o for o, _ in refer(NounPhrase("mug", "mug", ("blue",)), bare)] == ["Mug_2"]
