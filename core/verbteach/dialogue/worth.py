"""What of a change or a goal is worth speaking of, and worth asking about.

Some facts are there for the planner (that a hand is taken), some come along
with whatever is done (where the robot stands), and that a thing has left one
place goes without saying where it has come to another.
"""

from __future__ import annotations

from collections.abc import Iterable

from verbteach.language.lexicon import Lexicon
from verbteach.perception.belief import Exclusivity
from verbteach.verbs.pool import PLACES
from verbteach.world.fluents import Goal, Literal

PLACED = Exclusivity((("In", 0), ("On", 0), ("in", 0), ("on", 0)))
"""A thing is in one other, or on one; it may be beside a third at the same time."""


def spoken(goal: Goal, lexicon: Lexicon) -> Goal:
    """Without what the robot keeps in mind for itself; all of it where that is all there is."""
    said = frozenset(one for one in goal if one.fluent.predicate not in lexicon.unspoken)
    return said or goal


def essential(goal: Goal, lexicon: Lexicon) -> Goal:
    """What may be meant: without what comes along with anything, unless nothing else is there."""
    said = spoken(goal, lexicon)
    meant = frozenset(one for one in said if one.fluent.predicate not in lexicon.incidental)
    return meant or said


def without_departures(literals: Iterable[Literal]) -> list[Literal]:
    """Without "no longer there" about a thing of which "now here" is said, in the order given."""
    listed = list(literals)
    arrived = {_placed(one) for one in listed if one.positive} - {None}
    return [one for one in listed if one.positive or _placed(one) not in arrived]


def _placed(literal: Literal) -> str | None:
    """The thing whose place the literal is about."""
    place, args = PLACES.get(literal.fluent.predicate), literal.fluent.args
    return None if place is None or place >= len(args) else args[place]
