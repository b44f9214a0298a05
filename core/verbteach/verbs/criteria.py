"""Selection criteria: how much a candidate goal is wanted, judged by what speaks for it.

A criterion is one function of a goal's evidence. The plain ones are here, by
the names of She & Chai (2016); the regression is fitted (``regression``).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol

from verbteach.verbs.application import Evidence, Support
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


@dataclass(frozen=True)
class Counting:
    """Demonstrations that gave the goal, of the hypotheses that ``counts`` lets through.

    Each demonstration counts with the probability of the grounding it was
    bound with; equal goals add up.
    """

    name: str
    counts: Callable[[Support], bool]

    def score(self, evidence: Evidence) -> float:
        """The expected number of demonstrations that speak for the goal."""
        return sum(
            support.probability * len(support.demonstrations)
            for support in evidence.supports
            if self.counts(support)
        )


@dataclass(frozen=True)
class Oracle:
    """The upper bound: ``judge`` knows how good a goal is, from 0 to 1."""

    judge: Callable[[Goal], float]
    name: str = "oracle"

    def score(self, evidence: Evidence) -> float:
        """What the judge says."""
        return self.judge(evidence.goal)


def at_the_top(support: Support) -> bool:
    """Whether no more specific hypothesis is linked to this one."""
    return not support.frame.specific[support.node.literals]


def at_the_bottom(support: Support) -> bool:
    """Whether no more general hypothesis is linked to this one."""
    return not support.node.general


def anywhere(support: Support) -> bool:
    """Every hypothesis counts."""
    return support.node.frequency > 0


MOST_SPECIFIC = Counting("most_specific", at_the_top)
MOST_GENERAL = Counting("most_general", at_the_bottom)
MOST_FREQUENT = Counting("most_frequent", anywhere)

PLAIN_CRITERIA: Mapping[str, Criterion] = {
    criterion.name: criterion for criterion in (MOST_SPECIFIC, MOST_GENERAL, MOST_FREQUENT)
}
