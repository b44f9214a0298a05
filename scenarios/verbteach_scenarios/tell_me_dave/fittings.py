"""What an object's name says about it: whose part it is, what it switches, what shows in it.

The corpus lists objects with affordance marks and nothing else; that the knob
``StoveKnob_2`` belongs to ``Stove`` and lights ``StoveFire2`` is in the names
alone. The rules here are about kinds of names, never about one document, so
that they also fit a room with objects that were not seen before.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from verbteach.world.fluents import Fluent

Marks = Mapping[str, Sequence[str]]
"""Object id to its affordance marks, as a document's object list gives them."""

_NUMBER = re.compile(r"_\d+$")
_BUTTONS = {
    "ChannelUpButton": "channel-up",
    "ChannelDownButton": "channel-down",
    "VolumeUpButton": "louder",
    "VolumeDownButton": "softer",
}
"""A television's buttons that are no toggles, with the relation they stand in to it."""

_TOGGLES = {"Microwave": "MicrowaveIsOn", "Fridge": "WaterDispenserIsOpen"}
"""What the one ``Button`` of an appliance switches."""

_INGREDIENTS = {"Ramen": "Ramen", "BoiledEgg": "Egg", "Salt": "Salt"}
_HELPINGS = {"IceCreamScoop": "IceCream"}
_HIDDEN = {"Bowl": None, "Kettle": ("Egg",)}
"""Kinds in which contents do not show (None: none do), as the traces have it."""

SCOOPFUL = "Scoop"
CHANNELS = tuple(f"Channel{number}" for number in range(1, 7))
CONTENTS = ("Water", "Coffee", "Chocolate", "Vanilla", "IceCream", "Ramen", "Egg", "Salt")


def kind(object_id: str) -> str:
    """The name without its number: ``Mug`` for ``Mug_1``."""
    return _NUMBER.sub("", object_id)


def hosts(objects: Iterable[str]) -> dict[str, str]:
    """Each part with what it is a part of: ``FridgeButton`` of ``Fridge``.

    A part's name is its host's name with a capitalised word appended; the
    longest such host counts, so that the remote's buttons belong to the remote.
    """
    known = frozenset(objects)
    found = {}
    for part in sorted(known):
        ends = (end for end in range(len(part) - 1, 0, -1) if part[end].isupper())
        host = next((part[:end] for end in ends if part[:end] in known), None)
        if host is not None:
            found[part] = host
    return found


def fittings(objects: Marks) -> frozenset[Fluent]:
    """The static facts of a room: affordance marks, and what follows from the names."""
    return frozenset(_facts(objects))


def _facts(objects: Marks) -> Iterator[Fluent]:
    part_of = hosts(objects)
    for thing, marks in objects.items():
        yield from (Fluent(mark, (thing,)) for mark in marks)
        yield from _contents(thing, marks)
    yield from _discs(objects)
    for part, host in part_of.items():
        yield from _part(part, host, objects, part_of)
    yield from _doors(objects, part_of)
    for here, there in zip(CHANNELS, CHANNELS[1:] + CHANNELS[:1], strict=True):
        yield Fluent("next", (here, there))


def _contents(thing: str, marks: Sequence[str]) -> Iterator[Fluent]:
    own = kind(thing)
    if own in _INGREDIENTS and "IsAddable" in marks:
        yield Fluent("ingredient", (thing, _INGREDIENTS[own]))
    if own in _HELPINGS:
        yield Fluent("helping", (thing, _HELPINGS[own]))
    for content in (_HIDDEN.get(own, ()) or CONTENTS) if own in _HIDDEN else ():
        yield Fluent("hides", (thing, content))


def _discs(objects: Marks) -> Iterator[Fluent]:
    for disc in (o for o in objects if kind(o) == "Cd"):
        for player in (o for o in objects if kind(o) == "Xbox"):
            yield Fluent("fits", (disc, player))


def _part(part: str, host: str, objects: Marks, part_of: Mapping[str, str]) -> Iterator[Fluent]:
    """What a knob or a button does. Those of a thing in the hand are worked while holding it."""
    word = kind(part[len(host) :])
    if word == "Knob":
        yield Fluent("turned-at", (part, host))
        yield from _knob(part, host)
    if word.endswith("Button"):
        held = "IsGraspable" in objects[host]
        device = part_of.get(host, host) if held else host
        yield Fluent("pressed-with" if held else "pressed-at", (part, host))
        yield from _button(part, word, device)


def _knob(knob: str, host: str) -> Iterator[Fluent]:
    number = knob.rpartition("_")[2]
    if number.isdigit():
        yield Fluent("switches", (knob, host, f"{kind(host)}Fire{number}"))
    else:
        yield Fluent("switches", (knob, knob, "TapIsOn"))
        yield Fluent("taps", (knob, host))


def _button(button: str, word: str, device: str) -> Iterator[Fluent]:
    if word in _BUTTONS:
        yield Fluent(_BUTTONS[word], (button, device))
    if word == "PowerButton":
        yield Fluent("switches", (button, device, "IsOn"))
    if word == "Button":
        value = _TOGGLES.get(kind(device), "IsOn")
        yield Fluent("switches", (button, device, value))
        if value == "WaterDispenserIsOpen":
            yield Fluent("dispenses", (button, value))


def _doors(objects: Marks, part_of: Mapping[str, str]) -> Iterator[Fluent]:
    """Doors are parts (``FridgeLeftDoor``); with one ``Door`` or none, the whole is opened."""
    doored = set()
    for door, host in part_of.items():
        word = door[len(host) :]
        if word.endswith("Door"):
            doored.add(host)
            yield from _door(door, host, f"{word}IsOpen")
            if word == "Door":
                yield from _door(host, host, "DoorIsOpen")
    for thing, marks in objects.items():
        if kind(thing).startswith("BagOf"):
            yield Fluent("opened-with", (thing, thing))
            yield Fluent("opens", (thing, thing, "IsOpen"))
        if "Openable" in marks and thing not in doored:
            yield from _door(thing, thing, "DoorIsOpen")
        elif "IsPlaceableIn" in marks and thing not in doored:
            yield Fluent("doorless", (thing,))


def _door(door: str, host: str, value: str) -> Iterator[Fluent]:
    yield Fluent("opened-at", (door, host))
    yield Fluent("opens", (door, host, value))
    yield Fluent("door-of", (host, value))
    if value == "DoorIsOpen" and kind(host) in _TOGGLES:
        yield Fluent("ends", (door, host, _TOGGLES[kind(host)]))
    if value == "LeftDoorIsOpen":
        yield Fluent("ends", (door, host, "WaterDispenserIsOpen"))
