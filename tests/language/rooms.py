"""Bundled rooms as the tests of this room see them, and noun phrases as the grammar reads them."""

from __future__ import annotations

from functools import cache

from verbteach.language.frames import NounPhrase
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.refer import refer
from verbteach_scenarios.lexicon_file import load_lexicon
from verbteach_scenarios.scenes import load_scene


@cache
def looks(scene: str = "kitchen-1") -> Looks:
    """A bundled scene as it starts."""
    found = load_scene(scene)
    return Looks(found, found.initial, load_lexicon())


def vocabulary(room: Looks) -> tuple[str, ...]:
    """The names of everything in the room."""
    return tuple(name for thing in room.objects.values() for name in thing.names)


def phrase(text: str, room: Looks | None = None) -> NounPhrase:
    """``text`` as the object of a verb."""
    room = room or looks()
    (frame,) = parse(f"take {text}", room.lexicon, vocabulary(room))
    return frame.phrases[0]


def meant(
    text: str,
    room: Looks | None = None,
    spoken: tuple[str, ...] = (),
    listed: tuple[str, ...] = (),
) -> list[str]:
    """The objects that ``text`` means, the best first."""
    room = room or looks()
    return [thing for thing, _ in refer(phrase(text, room), room, spoken, listed=listed)]
