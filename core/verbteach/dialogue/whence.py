"""What is taken from somewhere is there: each of the two phrases tells what the other means."""

from __future__ import annotations

from collections.abc import Mapping

from verbteach.language.assembly import OBJECT
from verbteach.language.frames import VerbFrame
from verbteach.language.looks import Looks

SOURCES = frozenset({"from", "off", "off of", "out of", "from inside", "from on top of"})
Weights = Mapping[str, Mapping[str, float]]
"""For each phrase the objects that it may mean, weighted."""


def together(frame: VerbFrame, weights: Weights, looks: Looks) -> Weights:
    """Keep what is in or on one of the places that it is to be taken from, and those places.

    Where nothing is, all stays: the words may mean something else.
    """
    found = dict(weights)
    things = [a.phrase.text for a in frame.arguments if a.role == OBJECT]
    for source in (a.phrase.text for a in frame.arguments if a.role in SOURCES):
        within = {
            phrase: {thing: place for thing in found[phrase] if (place := _place(thing, looks))}
            for phrase in things
        }
        places = {p for own in within.values() for p in own.values()} & set(found[source])
        if not places:
            continue
        found[source] = {o: w for o, w in found[source].items() if o in places}
        for phrase, own in within.items():
            there = {o: w for o, w in found[phrase].items() if own.get(o) in places}
            found[phrase] = there or found[phrase]
    return found


def _place(thing: str, looks: Looks) -> str:
    """What the thing is in or on; empty where it is nowhere."""
    place = looks.place(thing)
    return place[1] if place else ""
