"""What a demonstration changed, and which of it a hypothesis may speak about.

She & Chai (2016): the base hypothesis is the conjunction of changed fluents
over one of four object sets.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cached_property

from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Fluent, Goal, Literal, State
from verbteach.world.plan import Action


@dataclass(frozen=True)
class StateChange:
    """Fluents true only afterwards (``added``) and only before (``removed``)."""

    added: frozenset[Fluent] = frozenset()
    removed: frozenset[Fluent] = frozenset()

    @classmethod
    def between(cls, start: State, end: State, static: frozenset[str] = frozenset()) -> StateChange:
        """Compare two states, leaving out the predicates in ``static``."""
        return cls(
            frozenset(f for f in end - start if f.predicate not in static),
            frozenset(f for f in start - end if f.predicate not in static),
        )

    @cached_property
    def literals(self) -> Goal:
        """The change as a goal: what was added must hold, what was removed must not."""
        return frozenset(
            {Literal(f) for f in self.added} | {Literal(f, False) for f in self.removed}
        )

    def __len__(self) -> int:
        return len(self.added) + len(self.removed)


class ObjectSet(Enum):
    """Which things a base hypothesis may speak about."""

    ARGUMENT_ONLY = "argument-only"
    MANIPULATED = "manipulated"
    ARGUMENT_RELATED = "argument-related"
    ALL = "all"


class Touch(Enum):
    """When a fluent speaks about a set of things: one of its things is in it, or every one."""

    ANY = "any"
    EVERY = "every"


def things_of(
    object_set: ObjectSet,
    arguments: Iterable[str],
    actions: Sequence[Action],
    end: State,
    surroundings: Surroundings,
) -> frozenset[str]:
    """The things in ``object_set``; ``actions`` and ``end`` are the demonstration's.

    A constant that the command speaks of ("boil the water") is a thing too.
    """
    chosen = frozenset(arguments)
    things = frozenset(surroundings.affordances) | chosen
    if object_set is ObjectSet.ALL:
        return things
    if object_set is ObjectSet.MANIPULATED:
        handled = frozenset(word for action in actions for word in action.args)
        return (handled & things) | (chosen - frozenset(surroundings.affordances))
    if object_set is ObjectSet.ARGUMENT_RELATED:
        beside = (f.args for f in end if chosen.intersection(f.args))
        return chosen | (frozenset(word for args in beside for word in args) & things)
    return chosen


def restrict(goal: Goal, things: frozenset[str], surroundings: Surroundings, touch: Touch) -> Goal:
    """The literals of ``goal`` about ``things``; a literal about no thing at all stays out."""
    kept = []
    for literal in goal:
        own = [w for w in literal.fluent.args if w in surroundings.affordances or w in things]
        inside = [word in things for word in own]
        if (all(inside) if touch is Touch.EVERY else any(inside)) and own:
            kept.append(literal)
    return frozenset(kept)
