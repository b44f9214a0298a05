"""All votes for a command's goals as arrays: cast once, counted by any weights and of any voters.

A vote's features hang on nothing but its demonstration and the situation. So
what fewer demonstrations say is a part of what more of them do, in the same
order, and sums over it are the same to the last digit as if the others had
never been asked.
"""

from __future__ import annotations

from collections.abc import Container, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.application import Block, Situation
from verbteach.verbs.features import features
from verbteach.verbs.knowledge import Use
from verbteach.world.fluents import Goal

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


class Wanted(NamedTuple):
    """A goal with its number in a poll and how much it is wanted."""

    number: int
    goal: Goal
    score: float


@dataclass(frozen=True, eq=False)
class Poll:
    """Votes by support and then by demonstration, for goals in the order of their first support.

    By vote: ``uses``, ``features`` (votes x ``NAMES``) and the number of the
    support. By support: the number of its goal and of its block, and its
    probability. ``turns``: the supports of some block do not have the same
    demonstrations, and come in the order of their first ones.
    """

    goals: tuple[Goal, ...]
    uses: tuple[Use, ...]
    features: Floats
    support_of: Ints
    goal_of: Ints
    block_of: Ints
    probabilities: Floats
    turns: bool

    @classmethod
    def of(cls, blocks: Iterable[Block], situation: Situation) -> Poll:
        """Ask everybody who supports a goal."""
        found = [block for block in blocks if block]
        supports = [support for block in found for _, support in block]
        numbers: dict[Goal, int] = {}
        known = [numbers.setdefault(g, len(numbers)) for block in found for g, _ in block]
        goal_of = np.array(known, dtype=np.int64)
        support_of = _numbered([len(support.uses) for support in supports])
        return cls(
            tuple(numbers),
            tuple([use for support in supports for use in support.uses]),
            features(numbers, supports, goal_of[support_of], support_of, situation),
            support_of,
            goal_of,
            _numbered([len(block) for block in found]),
            np.array([support.probability for support in supports]),
            any(row[1].uses != block[0][1].uses for block in found for row in block[1:]),
        )

    @cached_property
    def chances(self) -> Floats:
        """Each vote's probability: its support's."""
        return self.probabilities[self.support_of]

    @cached_property
    def goals_of(self) -> Ints:
        """The number of each vote's goal."""
        return self.goal_of[self.support_of]

    def among(self, voters: Container[str]) -> Poll:
        """The poll of these demonstrations only, as if nobody else had been asked."""
        asked = np.array([use.demonstration.id in voters for use in self.uses], dtype=bool)
        if asked.all():
            return self
        votes = np.flatnonzero(asked)
        supports, firsts, new = np.unique(
            self.support_of[votes], return_index=True, return_inverse=True
        )
        if self.turns:
            turn = self._turn(supports, votes[firsts])
            place = _places(turn)[new]
            order = np.argsort(place, kind="stable")
            supports, votes, new = supports[turn], votes[order], place[order]
        goals, firsts = np.unique(self.goal_of[supports], return_index=True)
        goals = goals[np.argsort(firsts)]
        number = np.zeros(len(self.goals), dtype=np.int64)
        number[goals] = np.arange(len(goals))
        return Poll(
            tuple([self.goals[goal] for goal in goals.tolist()]),
            tuple([self.uses[vote] for vote in votes.tolist()]),
            self.features[votes],
            new,
            number[self.goal_of[supports]],
            self.block_of[supports],
            self.probabilities[supports],
            self.turns,
        )

    def _turn(self, supports: Ints, firsts: Ints) -> Ints:
        """The order of the supports whose first votes are these."""
        keys = [
            (block, self.uses[vote])
            for block, vote in zip(self.block_of[supports].tolist(), firsts.tolist(), strict=True)
        ]
        return np.array(sorted(range(len(keys)), key=keys.__getitem__), dtype=np.int64)

    def by_goal(self, weights: Floats) -> Floats:
        """Votes' weights added up goal by goal, one after the other in the votes' order."""
        return _sums(self.goals_of, weights, len(self.goals))

    def counted(self, counts: NDArray[np.bool_]) -> Floats:
        """The expected number of votes for each goal, of those that ``counts`` lets through."""
        numbers = _sums(self.support_of, counts.astype(np.float64), len(self.probabilities))
        return _sums(self.goal_of, self.probabilities * numbers, len(self.goals))

    def ranked(self, scores: Floats, most: int | None = None) -> list[Wanted]:
        """At most that many goals that score more than 0, the best first, ties in their order."""
        known: list[float] = scores.tolist()
        order = sorted((i for i, own in enumerate(known) if own > 0), key=lambda i: -known[i])
        return [Wanted(number, self.goals[number], known[number]) for number in order[:most]]


def _numbered(sizes: list[int]) -> Ints:
    """The number of the part for each member of parts of these sizes."""
    return np.repeat(np.arange(len(sizes)), np.array(sizes, dtype=np.int64))


def _places(order: Ints) -> Ints:
    """Where each comes in an order."""
    places = np.empty_like(order)
    places[order] = np.arange(len(order))
    return places


def _sums(parts: Ints, values: Floats, count: int) -> Floats:
    """The values of each part added up from first to last, as ``sum`` adds them."""
    return np.asarray(np.bincount(parts, values, count), dtype=np.float64)
