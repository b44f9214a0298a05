"""Referring expressions: which objects a noun phrase means, and how to single one out.

Words are matched against names, attributes, states and relations. Nothing is
guessed: a phrase may fit no object or several, and then the robot asks.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import TypeAlias

from verbteach.language.frames import NounPhrase
from verbteach.language.looks import FIRST_NAME, Looks
from verbteach.language.words import ORDINALS

Candidates: TypeAlias = tuple[tuple[str, float], ...]
"""Object ids with how well the phrase fits them, the best first, then by id."""

_POINTERS = frozenset({"it", "this", "that"})
_PLURAL_POINTERS = frozenset({"them", "these", "those"})
_OTHER = frozenset({"other", "another"})
_NEAR_BEST = 0.3
_SECOND_SENSE = 0.25
_ABOUT_CONTENTS = frozenset({"with", "of"})


def refer(
    phrase: NounPhrase, looks: Looks, spoken: Sequence[str] = (), role: str = ""
) -> Candidates:
    """The objects that ``phrase`` may mean; empty where none fits.

    ``spoken`` are the objects spoken of before, the latest last, for "it" and
    "the other one". ``role`` tells "throw the beer" from "fill it with beer":
    one word for a thing and for what is in it means the thing unless the role
    asks for contents.
    """
    if phrase.head in _POINTERS | _PLURAL_POINTERS and not phrase.modifiers:
        latest = spoken if phrase.head in _PLURAL_POINTERS else spoken[-1:]
        return tuple((thing, FIRST_NAME) for thing in dict.fromkeys(latest))
    weights = {thing: _fit(thing, phrase, looks, spoken) for thing in looks.objects}
    if not any(weights.values()) and spoken:
        weights = {thing: _fit(thing, phrase, looks, ()) for thing in looks.objects}
    return _best(_sorted_out(weights, looks, role))


def _sorted_out(weights: dict[str, float], looks: Looks, role: str) -> dict[str, float]:
    """Things before contents of the same name; contents before things after "with" and "of"."""
    things = max((w for o, w in weights.items() if looks.is_thing(o)), default=0.0)
    contents = max((w for o, w in weights.items() if not looks.is_thing(o)), default=0.0)
    if not things or not contents:
        return weights
    behind = role in _ABOUT_CONTENTS
    if not behind and things < contents:
        return weights
    return {o: w * _SECOND_SENSE if looks.is_thing(o) == behind else w for o, w in weights.items()}


def _best(weights: dict[str, float]) -> Candidates:
    """Fits far behind the best one are chance: "pot" for a kettle where there is a pot."""
    top = max(weights.values(), default=0.0)
    near = [(thing, w) for thing, w in weights.items() if w > 0 and w >= _NEAR_BEST * top]
    return tuple(sorted(near, key=lambda row: (-row[1], row[0])))


def _fit(thing: str, phrase: NounPhrase, looks: Looks, spoken: Sequence[str]) -> float:
    marks = [m for m in phrase.modifiers if m not in _OTHER and m not in ORDINALS]
    others = _OTHER & {*phrase.modifiers, phrase.determiner}
    fit = _noun_fit(thing, phrase.head, marks, looks)
    if phrase.head == "one" and spoken:
        fit = _like_the_last(thing, marks, looks, spoken)
    if not fit or (others and thing in spoken):
        return 0.0
    return fit if _stands_in_relations(thing, phrase, looks) else 0.0


def _noun_fit(thing: str, head: str, marks: Sequence[str], looks: Looks) -> float:
    """The best split of modifiers and head into marks and a name: red | coffee mug."""
    for start in range(len(marks) + 1):
        fit = looks.fit(thing, " ".join([*marks[start:], head]))
        if fit and all(looks.has_mark(thing, mark) for mark in marks[:start]):
            return fit
    return 0.0


def _like_the_last(thing: str, marks: Sequence[str], looks: Looks, spoken: Sequence[str]) -> float:
    """As in "the other one": something with a name of what was spoken of last."""
    names = looks.objects[spoken[-1]].names[:1]
    return max((_noun_fit(thing, name, marks, looks) for name in names), default=0.0)


def _stands_in_relations(thing: str, phrase: NounPhrase, looks: Looks) -> bool:
    return all(
        any(looks.related(thing, preposition, other) for other, _ in refer(inner, looks))
        for preposition, inner in phrase.relations
    )


def distinguish(object_id: str, looks: Looks) -> str:
    """The shortest description that fits no other thing in the scene: "the red mug".

    Where nothing singles the object out, its name with the number of its id:
    "the mug 2".
    """
    thing = looks.objects.get(object_id)
    if thing is None:
        return object_id
    name = thing.names[0] if thing.names else object_id
    if not looks.is_thing(object_id):
        return f"the {name}"
    for description in _descriptions(object_id, name, looks):
        if _alone(object_id, description, looks):
            return _worded(description, looks)
    return f"the {name} {object_id.rpartition('_')[2]}"


_Description: TypeAlias = tuple[tuple[str, ...], str, tuple[str, str] | None]


def _descriptions(object_id: str, name: str, looks: Looks) -> Iterator[_Description]:
    attributes = looks.objects[object_id].attributes
    order = ("position", "colour", "material", "size")
    values = [attributes[kind].lower() for kind in order if kind in attributes]
    marks = [value for value in values if value not in name.split()]
    place = looks.place(object_id)
    yield (), name, None
    yield from (((mark,), name, None) for mark in marks)
    yield (), name, place
    yield from (((mark,), name, place) for mark in marks)
    for pair in combinations(reversed(marks), 2):
        yield pair, name, None
    for pair in combinations(reversed(marks), 2):
        yield pair, name, place


def _alone(object_id: str, description: _Description, looks: Looks) -> bool:
    marks, name, place = description
    return not any(
        other != object_id and looks.is_thing(other) and _fits(other, marks, name, place, looks)
        for other in looks.objects
    )


def _fits(
    other: str, marks: Sequence[str], name: str, place: tuple[str, str] | None, looks: Looks
) -> bool:
    if name not in looks.objects[other].names or not all(
        looks.has_mark(other, mark) for mark in marks
    ):
        return False
    return place is None or looks.related(other, *place)


def _worded(description: _Description, looks: Looks) -> str:
    marks, name, place = description
    told = " ".join(["the", *marks, name])
    if place is None:
        return told
    preposition, other = place
    return f"{told} {preposition} {distinguish(other, looks)}"
