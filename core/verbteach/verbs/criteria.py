"""Selection criteria: how much a candidate goal is wanted, judged by what speaks for it.

A criterion is one function of a goal's evidence. The plain ones are here, by
the names of She & Chai (2016); the regression is fitted (``regression``).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.application import Evidence
from verbteach.verbs.knowledge import Use
from verbteach.verbs.poll import Poll
from verbteach.world.fluents import Goal


class Criterion(Protocol):
    """Scores goals; what scores 0 or less is no candidate."""

    @property
    def name(self) -> str:
        """The criterion's name, as the command line knows it."""
        ...

    def score(self, evidence: Evidence) -> float:
        """How much the goal is wanted. Depends on nothing but ``evidence``."""
        ...


class Teller(Criterion, Protocol):
    """A criterion that is quick about all goals of a command at once."""

    def tally(self, poll: Poll) -> NDArray[np.float64]:
        """Every goal's score; the same as ``score`` one by one."""
        ...


@dataclass(frozen=True)
class Counting:
    """Demonstrations that gave the goal, of the uses that ``counts`` lets through.

    Each demonstration counts with the probability of the grounding it was
    bound with; equal goals add up.
    """

    name: str
    counts: Callable[[Use], bool]

    def score(self, evidence: Evidence) -> float:
        """The expected number of demonstrations that speak for the goal."""
        return sum(
            support.probability * sum(map(self.counts, support.uses))
            for support in evidence.supports
        )

    def tally(self, poll: Poll) -> NDArray[np.float64]:
        """Every goal's number."""
        return poll.counted(np.fromiter(map(self.counts, poll.uses), bool, len(poll.uses)))


@dataclass(frozen=True)
class Oracle:
    """The upper bound: ``judge`` knows how good a goal is, from 0 to 1."""

    judge: Callable[[Goal], float]
    name: str = "oracle"

    def score(self, evidence: Evidence) -> float:
        """What the judge says."""
        return self.judge(evidence.goal)


def whole_goal(use: Use) -> bool:
    """Whether the goal was all that the demonstration changed: memory alone."""
    return use.base


def least_goal(use: Use) -> bool:
    """Whether the demonstration kept nothing more general."""
    return use.leaf


def any_goal(use: Use) -> bool:
    """Every hypothesis counts."""
    return True


MOST_SPECIFIC = Counting("most_specific", whole_goal)
MOST_GENERAL = Counting("most_general", least_goal)
MOST_FREQUENT = Counting("most_frequent", any_goal)

PLAIN_CRITERIA: Mapping[str, Teller] = {
    criterion.name: criterion for criterion in (MOST_SPECIFIC, MOST_GENERAL, MOST_FREQUENT)
}
"""The criteria that need neither fitting nor the answer, by name."""
