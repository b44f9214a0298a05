"""Does a policy meet people and their simulator alike? Two sets of sessions compared.

Episodes of one person are alike, so whole people change sides in the
permutations. That no difference is found does not prove that there is none:
the intervals say how large one could be.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verbteach.dialogue import acts
from verbteach.dialogue.acts import QUESTIONS
from verbteach.experiments.significance import holm
from verbteach_sessions.people.recorded import Said

FLIPS = 2000
LEVEL = 0.05
_QUESTIONS = tuple(kind.name for kind in QUESTIONS)


@dataclass(frozen=True)
class Met:
    """One episode of a policy with somebody: what it asked and what it earned.

    ``questions`` counts by type, ``turns`` are the teacher's acts, ``success``
    says that it was carried out right.
    """

    person: str
    questions: Mapping[str, int]
    turns: int
    earned: float
    success: bool


@dataclass(frozen=True)
class Difference:
    """A statistic with people and with the simulator; ``p`` is corrected for all of them (Holm)."""

    people: float
    simulator: float
    difference: tuple[float, float]
    p: float

    def to_json(self) -> dict[str, Any]:
        """Plain JSON; ``ci95`` is the difference's, bootstrapped over people."""
        return {
            "people": self.people,
            "simulator": self.simulator,
            "ci95": list(self.difference),
            "p": self.p,
        }


@dataclass(frozen=True)
class Meeting:
    """The comparison. ``alike``: no statistic differs at the 5 % level, all tests together."""

    episodes: tuple[int, int]
    people: tuple[int, int]
    statistics: Mapping[str, Difference]
    types_p: float

    @property
    def alike(self) -> bool:
        """Whether no difference was found."""
        return self.types_p >= LEVEL and all(d.p >= LEVEL for d in self.statistics.values())

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, as the command line prints it."""
        return {
            "alike": self.alike,
            "episodes": {"people": self.episodes[0], "simulator": self.episodes[1]},
            "persons": {"people": self.people[0], "simulator": self.people[1]},
            "question_types_p": self.types_p,
            **{name: one.to_json() for name, one in self.statistics.items()},
        }


def met_in(person: str, episodes: Iterable[Sequence[Said]]) -> tuple[Met, ...]:
    """Recorded episodes, those that did not come to an end left out."""
    found = [_met(person, episode) for episode in episodes]
    return tuple(one for one in found if one is not None)


def _met(person: str, episode: Sequence[Said]) -> Met | None:
    outcome = episode[-1].after.outcome
    if outcome is None:
        return None
    asked = Counter(
        one.before.waiting.name for one in episode if isinstance(one.before.waiting, QUESTIONS)
    )
    earned = sum(float(one.reply.data["reward"]) for one in episode)
    success = outcome is acts.Outcome.EXECUTED
    return Met(person, dict(sorted(asked.items())), len(episode), earned, success)


def compare(people: Sequence[Met], simulated: Sequence[Met], rng: np.random.Generator) -> Meeting:
    """Compare. Raises ``ValueError`` where a side has fewer than two persons."""
    sides = [_table(people), _table(simulated)]
    if min(len(names) for names, _ in sides) < 2:
        raise ValueError("both sides need the episodes of two persons at least")
    tables = [table for _, table in sides]
    corrected = holm(_permuted(tables, rng).tolist())
    low, high = _bootstrapped(tables, rng)
    first, second = (_statistics(table.sum(axis=0)) for table in tables)
    statistics = {
        name: Difference(
            float(first[i]), float(second[i]), (float(low[i]), float(high[i])), corrected[i]
        )
        for i, name in enumerate(_NAMES)
    }
    return Meeting(
        (len(people), len(simulated)),
        (len(sides[0][0]), len(sides[1][0])),
        statistics,
        corrected[-1],
    )


_NAMES = ("questions", "turns", "return", "success")
Floats = NDArray[np.float64]


def _table(episodes: Sequence[Met]) -> tuple[list[str], Floats]:
    """A row a person: episodes, the four sums, and questions by type."""
    names = sorted({one.person for one in episodes})
    table = np.zeros((len(names), 5 + len(_QUESTIONS)))
    for one in episodes:
        row = table[names.index(one.person)]
        row[:5] += (1.0, sum(one.questions.values()), one.turns, one.earned, float(one.success))
        row[5:] += [one.questions.get(name, 0) for name in _QUESTIONS]
    return names, table


def _statistics(sums: Floats) -> Floats:
    """Means of an episode, from sums over people (any rows x columns of the table)."""
    return np.asarray(sums[..., 1:5] / sums[..., :1])


def _distance(one: Floats, other: Floats) -> Floats:
    """Total variation between two distributions of question types."""
    shares = [x / np.maximum(1.0, x.sum(axis=-1, keepdims=True)) for x in (one, other)]
    return np.asarray(0.5 * np.abs(shares[0] - shares[1]).sum(axis=-1))


def _differing(first: Floats, second: Floats) -> Floats:
    """How far two sides' sums are apart in each statistic, and in the types of questions."""
    apart = np.abs(_statistics(first) - _statistics(second))
    return np.concatenate([apart, _distance(first[..., 5:], second[..., 5:])[..., None]], axis=-1)


def _permuted(tables: Sequence[Floats], rng: np.random.Generator) -> Floats:
    """How likely each difference is to be as large where the sides are drawn by lot."""
    both, size = np.vstack(tables), len(tables[0])
    order = rng.permuted(np.tile(np.arange(len(both)), (FLIPS, 1)), axis=1)
    inside = (order < size).astype(float)
    drawn = _differing(inside @ both, (1.0 - inside) @ both)
    seen = _differing(*(table.sum(axis=0) for table in tables))
    return np.asarray(((drawn >= seen - 1e-9).sum(axis=0) + 1.0) / (FLIPS + 1.0))


def _bootstrapped(tables: Sequence[Floats], rng: np.random.Generator) -> tuple[Floats, Floats]:
    drawn = []
    for table in tables:
        people = rng.integers(len(table), size=(FLIPS, len(table)))
        drawn.append(_statistics(table[people].sum(axis=1)))
    low, high = np.quantile(drawn[0] - drawn[1], [0.025, 0.975], axis=0)
    return low, high
