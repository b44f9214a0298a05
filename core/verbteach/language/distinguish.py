"""From an object to words: the shortest description that singles it out in its scene.

Every description is checked by ``refer``: what the robot calls a thing is what
it would understand, were it said back.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations

from verbteach.language.frames import NounPhrase
from verbteach.language.looks import Looks
from verbteach.language.morphology import article
from verbteach.language.refer import refer

_ORDER = ("size", "colour", "material")
"""How adjectives stand in English: a small red plastic mug."""
_TELLING = ("position", "colour", "material", "size")
"""Which attribute is tried first to tell a thing from its like."""


@dataclass(frozen=True)
class _Description:
    marks: tuple[str, ...]
    name: str
    place: tuple[str, str] | None = None
    contents: str = ""


def distinguish(object_id: str, looks: Looks, among: Sequence[str] = ()) -> str:
    """The shortest description that fits no other thing: "the red mug".

    ``among`` are the things to tell it from, all of the scene if empty. Where
    nothing singles it out, its name with the number of its id: "the mug 2". An
    id that the scene lacks comes back as it is.
    """
    return _distinguished(object_id, looks, tuple(among))


@lru_cache(maxsize=1 << 12)
def _distinguished(object_id: str, looks: Looks, among: tuple[str, ...]) -> str:
    thing = looks.objects.get(object_id)
    if thing is None:
        return object_id
    name = thing.names[0] if thing.names else object_id
    if not looks.is_thing(object_id):
        return f"the {name}"
    for description in _descriptions(object_id, name, looks):
        if _alone(object_id, description, looks, among):
            return _worded(description, looks, among)
    return f"the {name} {object_id.rpartition('_')[2]}"


def distinguish_by_looks(object_id: str, looks: Looks) -> str:
    """The same without where the thing is, which may be what is being told: "the red mug".

    Where nothing but its place singles it out, its name alone.
    """
    told = distinguish(object_id, looks)
    if looks.place(object_id) is None or not looks.is_thing(object_id):
        return told
    name = _name(object_id, looks)
    placeless = (d for d in _descriptions(object_id, name, looks) if d.place is None)
    alone = (d for d in placeless if _alone(object_id, d, looks, ()))
    return next((_worded(d, looks, ()) for d in alone), f"the {name}")


def glimpse(object_id: str, looks: Looks) -> str:
    """What a camera sees of the object without knowing its name: "a silver object on the table"."""
    attributes = looks.objects[object_id].attributes
    marks = [attributes[kind].lower() for kind in ("size", "colour") if kind in attributes]
    seen = " ".join([*marks, "object"])
    place = looks.place(object_id)
    told = f"{article(seen)} {seen}"
    return f"{told} {place[0]} {distinguish(place[1], looks)}" if place else told


def _descriptions(object_id: str, name: str, looks: Looks) -> Iterator[_Description]:
    """Descriptions from the shortest to the longest, the more natural of equal ones first."""
    attributes = looks.objects[object_id].attributes
    values = {kind: attributes[kind].lower() for kind in _TELLING if kind in attributes}
    marks = [value for value in values.values() if value not in name.split()]
    pairs = [_in_order(pair, values) for pair in combinations(marks, 2)]
    place = looks.place(object_id)
    yield _Description((), name)
    yield from (_Description((mark,), name) for mark in marks)
    yield from (_Description((), other) for other in looks.objects[object_id].names[1:])
    if place:
        yield _Description((), name, place)
    yield from (_Description(pair, name) for pair in pairs)
    yield from (_Description((), name, None, content) for content in looks.holds(object_id))
    yield from (_Description((state,), name) for state in looks.states(object_id))
    if place:
        yield from (_Description((mark,), name, place) for mark in marks)
        yield from (_Description(pair, name, place) for pair in pairs)


def _in_order(pair: tuple[str, str], values: dict[str, str]) -> tuple[str, ...]:
    ranks = {value: _ORDER.index(kind) for kind, value in values.items() if kind in _ORDER}
    return tuple(sorted(pair, key=lambda mark: ranks.get(mark, -1)))


def _alone(object_id: str, description: _Description, looks: Looks, among: Sequence[str]) -> bool:
    found = refer(_phrase(description, looks), looks)
    best = [thing for thing, weight in found if weight == found[0][1]]
    if among:
        best = [thing for thing in best if thing in among or thing == object_id]
    return best == [object_id]


def _phrase(description: _Description, looks: Looks) -> NounPhrase:
    """The description as the grammar would read it."""
    outer, of, inner = description.name.partition(" of ")
    *before, head = outer.replace("'s ", " ").lower().split(" ")
    relations = [("of", _named(inner))] if of else []
    if description.place:
        preposition, other = description.place
        relations.append((preposition, _named(_name(other, looks))))
    if description.contents:
        relations.append(("with", _named(_name(description.contents, looks))))
    modifiers = (*description.marks, *before)
    return NounPhrase(description.name, head, modifiers, "the", relations=tuple(relations))


def _named(name: str) -> NounPhrase:
    *before, head = name.lower().replace("'s ", " ").split(" ")
    return NounPhrase(name, head, tuple(before))


def _name(object_id: str, looks: Looks) -> str:
    names = looks.objects[object_id].names
    return names[0] if names else object_id


def _worded(description: _Description, looks: Looks, among: Sequence[str]) -> str:
    told = " ".join(["the", *description.marks, description.name])
    if description.contents:
        return f"{told} with {_name(description.contents, looks)}"
    if description.place is None:
        return told
    preposition, other = description.place
    return f"{told} {preposition} {distinguish(other, looks)}"
