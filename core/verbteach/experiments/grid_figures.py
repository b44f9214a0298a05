"""What a grid of learners says: figures with intervals, the strongest, and fair comparisons.

Everything is computed from the cells' test commands; comparisons are paired
on the same commands, and intervals are bootstrapped over documents.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from verbteach.experiments.figures import Figure, Observation, figure, paired
from verbteach.experiments.grid import Cell, Filled
from verbteach.experiments.she16 import ORACLE, REGRESSION
from verbteach.experiments.sight import stream
from verbteach.verbs.criteria import PLAIN_CRITERIA

RESAMPLES = 1000


class Method(NamedTuple):
    """A way to learn with a way to choose."""

    learner: str
    criterion: str

    def __str__(self) -> str:
        return f"{self.learner}, {self.criterion.replace('_', ' ')}"


class Condition(NamedTuple):
    """What methods are compared under."""

    noise: str
    reading: str
    grounding: str

    @classmethod
    def of(cls, cell: Cell) -> Condition:
        """A cell's condition."""
        return cls(cell.noise, cell.reading, cell.grounding)


@dataclass(frozen=True)
class Both:
    """IED and SJI."""

    ied: Figure
    sji: Figure


Inside = Callable[[str], bool]
"""Whether an environment takes part."""


def everywhere(environment: str) -> bool:
    """Every environment takes part."""
    return True


def observations(
    filled: Filled, criterion: str, value: str = "sji", inside: Inside = everywhere
) -> list[Observation]:
    """One value of each test command in the environments that take part."""
    return [
        Observation(group, float(getattr(score, value)))
        for group, environment, score in zip(
            filled.groups, filled.environments, filled.scores[criterion], strict=True
        )
        if inside(environment)
    ]


def both(filled: Filled, criterion: str) -> Both:
    """The figures of a cell by one criterion."""
    ied, sji = (
        figure([observations(filled, criterion, value)], stream(0, value), RESAMPLES)
        for value in ("ied", "sji")
    )
    return Both(ied, sji)


def difference(one: Filled, by: str, other: Filled, than: str) -> Figure:
    """How much SJI one method comes to more than another, command by command."""
    return paired(
        [observations(one, by)], [observations(other, than)], stream(0, "paired"), RESAMPLES
    )


Grid = Mapping[Condition, Mapping[str, Filled]]
"""Cells by condition and learner."""


def gathered(cells: Sequence[Filled]) -> Grid:
    """Arrange cells, in the order they come."""
    found: dict[Condition, dict[str, Filled]] = {}
    for one in cells:
        found.setdefault(Condition.of(one.cell), {})[one.cell.learner] = one
    return found


def methods(learners: Mapping[str, Filled]) -> Iterator[Method]:
    """Every method of a condition; the oracle is none."""
    for learner, filled in learners.items():
        for criterion in filled.scores:
            if criterion != ORACLE:
                yield Method(learner, criterion)


def mean(learners: Mapping[str, Filled], method: Method, inside: Inside = everywhere) -> float:
    """A method's mean SJI in the environments that take part."""
    values = [
        o.value for o in observations(learners[method.learner], method.criterion, "sji", inside)
    ]
    return sum(values) / len(values)


def strongest(learners: Mapping[str, Filled], inside: Inside = everywhere) -> Method:
    """The method with the highest mean SJI; the first of equals."""
    return max(methods(learners), key=lambda method: mean(learners, method, inside))


class Chosen(NamedTuple):
    """A method chosen on half of the environments, with its SJI there and on the other half.

    ``other_best`` is the highest SJI that any method has on the other half.
    """

    method: Method
    here: float
    elsewhere: float
    other_best: float


def chosen_by_halves(learners: Mapping[str, Filled]) -> tuple[Chosen, Chosen]:
    """Choose on every second environment and try on the rest, and the other way round."""
    names = sorted({name for one in learners.values() for name in one.environments})
    first, second = frozenset(names[::2]), frozenset(names[1::2])
    return _chosen(learners, first, second), _chosen(learners, second, first)


def _chosen(learners: Mapping[str, Filled], here: frozenset[str], there: frozenset[str]) -> Chosen:
    method = strongest(learners, here.__contains__)
    best = strongest(learners, there.__contains__)
    return Chosen(
        method,
        mean(learners, method, here.__contains__),
        mean(learners, method, there.__contains__),
        mean(learners, best, there.__contains__),
    )


class Earned(NamedTuple):
    """The regression against the best criterion that needs no fitting, for one learner."""

    learner: str
    plain: str
    gain: Figure


def earned(learners: Mapping[str, Filled]) -> tuple[Earned, ...]:
    """What fitting is worth to each learner (SJI), against its best plain criterion."""
    found = []
    for learner, filled in learners.items():
        plain = max(PLAIN_CRITERIA, key=lambda name: mean(learners, Method(learner, name)))
        gain = difference(filled, REGRESSION, filled, plain)
        found.append(Earned(learner, plain, gain))
    return tuple(found)
