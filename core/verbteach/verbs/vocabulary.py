"""The literals that a goal belief speaks of, numbered, and the goals made of them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from itertools import compress

from verbteach.world.fluents import Goal, Literal


class Vocabulary(tuple[Literal, ...]):
    """The literals of a pool, by number; they stay the same whatever is answered.

    So do their numbers and the goals made of them, which are therefore kept
    here: a goal's hash, that planners look it up by, is then computed once.
    """

    @cached_property
    def numbers(self) -> Mapping[Literal, int]:
        """The literals' numbers."""
        return {literal: number for number, literal in enumerate(self)}

    @cached_property
    def _goals(self) -> dict[bytes, Goal]:
        return {}

    def goal(self, row: bytes) -> Goal:
        """The literals of a row as a goal; each byte is 1 where its literal is in, or 0."""
        goal = self._goals.get(row)
        if goal is None:
            goal = self._goals[row] = frozenset(compress(self, row))
        return goal
