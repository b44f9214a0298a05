"""Which policy is ahead of which, and whether that is more than chance.

Comparisons are paired on the same runs and test commands; signs of whole
documents are permuted, and Holm's correction is over all comparisons of a table.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

from verbteach.experiments.figures import Observation
from verbteach.experiments.reproduction.curves import asking
from verbteach.experiments.reproduction.design import MATCHED
from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.reproduction.tables import EXECUTION_KINDS, LEARNING_KINDS, SCORES, cells
from verbteach.experiments.sight import stream
from verbteach.experiments.significance import holm, paired_permutation

FLIPS = 10_000


@dataclass(frozen=True)
class Comparison:
    """``policy`` against ``other``: means of ``value``, and Holm's p.

    ``improvement`` is the difference as a share of the other's, as in the
    paper's Table 4; none where the other's is 0.
    """

    policy: str
    other: str
    noise: str
    value: str
    mine: float
    theirs: float
    p: float

    @property
    def difference(self) -> float:
        """Positive where ``policy`` has more."""
        return self.mine - self.theirs

    @property
    def improvement(self) -> float | None:
        """The relative difference."""
        return self.mine / self.theirs - 1.0 if self.theirs else None

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        more = {"difference": self.difference, "improvement": self.improvement}
        return {**asdict(self), **more}


@dataclass(frozen=True)
class Pair:
    """Two policies' observations of the same commands, run by run."""

    policy: str
    other: str
    noise: str
    value: str
    mine: list[list[Observation]]
    theirs: list[list[Observation]]


def compared(pairs: Sequence[Pair], flips: int = FLIPS) -> list[Comparison]:
    """Test each pair, and correct for all of them."""
    found = [_tested(pair, flips) for pair in pairs]
    chances = holm([one.p for one in found])
    return [replace(one, p=p) for one, p in zip(found, chances, strict=True)]


def table4_pairs(rows: Sequence[Row], policy: str = "rl") -> Iterator[Pair]:
    """``policy`` against every other at each noise level, on both scores."""
    for (other, noise), theirs in cells(rows).items():
        mine = cells(rows).get((policy, noise), [])
        if other != policy and mine:
            for value in SCORES:
                yield _pair(policy, other, noise, value, mine, theirs)


def matched_pairs(rows: Sequence[Row], policy: str = "rl") -> Iterator[Pair]:
    """``policy`` against the rules, stopped so that they ask as much on average."""
    found = cells(rows)
    for (name, noise), mine in found.items():
        for other in MATCHED if name == policy else ():
            theirs = found.get((other, noise), [])
            if theirs:
                stopped = asking(theirs, mean_questions(mine))
                for value in SCORES:
                    own, others = _aligned(mine, theirs)
                    yield Pair(
                        policy,
                        f"{other} (same questions)",
                        noise,
                        value,
                        [row.observations(value) for row in own],
                        [stopped.observations(row, value) for row in others],
                    )


def table5_pairs(
    rows: Sequence[Row], noise: str, policy: str = "rl", other: str = "manual"
) -> Iterator[Pair]:
    """The cells of Table 5 that the paper marks: questions by kind in both phases, and scores."""
    found = cells(rows)
    mine, theirs = found.get((policy, noise), []), found.get((other, noise), [])
    if not mine or not theirs:
        return
    for value in (*EXECUTION_KINDS, *SCORES):
        yield _pair(policy, other, noise, value, mine, theirs)
    own, others = _aligned(mine, theirs)
    for kind in LEARNING_KINDS:
        ours, against = ([_per_run(row, kind) for row in part] for part in (own, others))
        yield Pair(policy, other, noise, f"learning {kind}", ours, against)


def mean_questions(rows: Sequence[Row]) -> float:
    """Mean questions per command in execution, over runs."""
    means = [sum(c.total for c in row.commands) / len(row.commands) for row in rows]
    return sum(means) / len(means)


def _per_run(row: Row, kind: str) -> list[Observation]:
    """Lessons are not kept one by one, so a run is one observation."""
    return [Observation(f"run {row.run}", row.learned(kind))]


def _pair(
    policy: str, other: str, noise: str, value: str, mine: Sequence[Row], theirs: Sequence[Row]
) -> Pair:
    own, others = _aligned(mine, theirs)
    return Pair(
        policy,
        other,
        noise,
        value,
        [row.observations(value) for row in own],
        [row.observations(value) for row in others],
    )


def _aligned(mine: Sequence[Row], theirs: Sequence[Row]) -> tuple[list[Row], list[Row]]:
    by_run = {row.run: row for row in theirs}
    both = [(row, by_run[row.run]) for row in mine if row.run in by_run]
    return [one for one, _ in both], [other for _, other in both]


def _tested(pair: Pair, flips: int) -> Comparison:
    rng = stream("comparison", pair.policy, pair.other, pair.noise, pair.value)
    chance = paired_permutation(pair.mine, pair.theirs, rng, flips)
    means = (_mean(pair.mine), _mean(pair.theirs))
    return Comparison(pair.policy, pair.other, pair.noise, pair.value, *means, chance)


def _mean(runs: Sequence[Sequence[Observation]]) -> float:
    """The mean over runs of each run's mean."""
    means = [sum(one.value for one in run) / len(run) for run in runs]
    return sum(means) / len(means)
