"""What a demonstration let go of stands for what the robot holds now.

Who is told to put it down, to fill it or to bring it handles the thing in the
hand, whatever the noun phrases are taken for. So a change that lets go of a
thing which is not held is offered for the held thing as well.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.lifting import rename
from verbteach.world.fluents import Literal, State

Bools = NDArray[np.bool_]

HOLDING: Mapping[str, int] = {"Grasping": 1, "grasping": 1}
"""Predicates that say what is held, with the argument that is the thing."""


class Handed(NamedTuple):
    """Rows (which x literals) with those for the held things added at the end.

    ``source`` is the row that each added one was made from, and ``possible``
    the share of it that could be brought about with the held thing.
    """

    literals: list[Literal]
    bound: Bools
    source: NDArray[np.int64]
    possible: NDArray[np.float64]


@lru_cache(maxsize=128)
def held_things(state: State) -> tuple[str, ...]:
    """What is held where ``state`` is believed, sorted.

    A state is met again with each memory of demonstrations.
    """
    return tuple(sorted(f.args[HOLDING[f.predicate]] for f in state if f.predicate in HOLDING))


def speaking_of(literals: Sequence[Literal], things: Sequence[str]) -> Bools:
    """Which literals speak of one of the things."""
    wanted = frozenset(things)
    return np.array([not wanted.isdisjoint(one.fluent.args) for one in literals], dtype=bool)


def handed(
    literals: Sequence[Literal],
    bound: Bools,
    held: Sequence[str],
    possible: Callable[[Literal], bool],
) -> Handed:
    """Add the rows that let go of something else, as they are for each thing in the hand.

    ``bound`` (rows x literals) says which literals a row has. What is not
    ``possible`` for the held thing is left out of its row.
    """
    index = {literal: column for column, literal in enumerate(literals)}
    rows: list[Bools] = []
    sources: list[NDArray[np.int64]] = []
    shares: list[NDArray[np.float64]] = []
    for thing in held:
        about = bound[:, speaking_of(literals, [thing])].any(1)
        for column, released in _let_go(literals, held):
            source = np.flatnonzero(bound[:, column] & ~about)
            moved = _instead(literals, released, thing, possible, index)
            row, share = _renamed(bound[source], moved, len(index))
            rows.append(row)
            sources.append(source)
            shares.append(share)
    wider = np.zeros((len(bound) + sum(map(len, rows)), len(index)), dtype=bool)
    first = 0
    for part in (bound, *rows):
        wider[first : first + len(part), : part.shape[1]] = part
        first += len(part)
    return Handed(
        list(index),
        wider,
        np.concatenate([np.zeros(0, np.int64), *sources]),
        np.concatenate([np.zeros(0), *shares]),
    )


def _let_go(literals: Sequence[Literal], held: Sequence[str]) -> list[tuple[int, str]]:
    """The columns that say a thing is let go, of things that are not held.

    In the literals' order, not the columns': those hang on what turned up before.
    """
    return [
        (column, fluent.args[HOLDING[fluent.predicate]])
        for column, (fluent, positive) in sorted(enumerate(literals), key=lambda row: row[1])
        if not positive
        and fluent.predicate in HOLDING
        and fluent.args[HOLDING[fluent.predicate]] not in held
    ]


def _renamed(
    rows: Bools, moved: Mapping[int, int | None], width: int
) -> tuple[Bools, NDArray[np.float64]]:
    """Rows with some columns moved to others or left out, and the share of each that is left."""
    wider = np.zeros((len(rows), width), dtype=bool)
    wider[:, : rows.shape[1]] = rows
    wider[:, list(moved)] = False
    for old, new in moved.items():
        if new is not None:
            wider[:, new] |= rows[:, old]
    lost = rows[:, [old for old, new in moved.items() if new is None]].sum(1)
    return wider, 1.0 - lost / np.maximum(1, rows.sum(1))


def _instead(
    literals: Sequence[Literal],
    released: str,
    thing: str,
    possible: Callable[[Literal], bool],
    index: dict[Literal, int],
) -> dict[int, int | None]:
    """Where literals are once the held thing stands in them, by column; None where none can be."""
    moved: dict[int, int | None] = {}
    for column, literal in enumerate(literals):
        if released in literal.fluent.args:
            (other,) = rename((literal,), {released: thing})
            moved[column] = index.setdefault(other, len(index)) if possible(other) else None
    return moved
