"""Phrases of place go where the scene says, and nowhere else."""

from __future__ import annotations

import pytest
from hypothesis import given

from tests.language.rooms import looks, vocabulary
from tests.language.strategies import WORD_SALADS
from verbteach.language.attachment import attach, readings
from verbteach.language.frames import NounPhrase, VerbFrame
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.notation import write_frames
from verbteach.world.fluents import Fluent

DECIDED = {
    "the first place is where it is": (
        "put the mug on the table in the sink",
        "put(obj=mug[on:table]; in=sink)",
    ),
    "a single place is a goal even where it is there": (
        "put the mug on the table",
        "put(obj=mug; on=table)",
    ),
    "fetching takes no place": ("grab the pan on the table", "grab(obj=pan[on:table])"),
    "an unknown verb, and it is there": (
        "blorp the mug on the table",
        "blorp(obj=mug[on:table])",
    ),
    "an unknown verb, and it is not": ("blorp the pan on the table", "blorp(obj=pan; on=table)"),
    "where it is done": ("wash the mug in the sink", "wash(obj=mug; in=sink)"),
    "which one it is": ("heat the ramen in the cupboard", "heat(obj=ramen[in:cupboard])"),
    "three places": (
        "put the apple in the bowl on the counter in the fridge",
        "put(obj=apple[in:bowl[on:counter]]; in=fridge)",
    ),
}


def _read(text: str, room: Looks) -> VerbFrame:
    (frame,) = parse(text, room.lexicon, vocabulary(room))
    return frame


@pytest.mark.parametrize(("text", "expected"), DECIDED.values(), ids=DECIDED.keys())
def test_the_scene_decides(text: str, expected: str) -> None:
    room = looks()
    assert write_frames([attach(_read(text, room), room)]) == expected


def test_another_state_decides_otherwise() -> None:
    room = looks()
    gone = room.state - {Fluent("on", ("Mug_1", "Table_1"))}
    later = Looks(room.scene, gone | {Fluent("in", ("Mug_1", "Sink_1"))}, room.lexicon)
    assert write_frames([attach(_read("wash the mug in the sink", room), later)]) == (
        "wash(obj=mug[in:sink])"
    )


def _words_of(phrase: NounPhrase) -> list[str]:
    inner = [word for name, other in phrase.relations for word in (name, *_words_of(other))]
    return [*phrase.modifiers, phrase.head, *inner]


def _words(frame: VerbFrame) -> list[str]:
    return [w for a in frame.arguments for w in (a.role, *_words_of(a.phrase))]


@given(WORD_SALADS)
def test_readings_keep_every_word_in_order_and_the_frame_itself_first(text: str) -> None:
    for frame in parse(text):
        options = readings(frame)
        assert options[0] == frame
        assert 1 <= len(options) <= 17
        assert all(_words(option) == _words(frame) for option in options)
        assert attach(frame, looks()) in options
