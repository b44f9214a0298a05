"""The grid of learners from demonstrations: every way to learn, ground, see and choose.

A cell is one way to learn, to ground and to see, tested with all criteria at
once. It is a function of its configuration alone, so cells may be computed in
any order, in any process, and kept between runs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cache
from itertools import product
from typing import Any, NamedTuple, TypeAlias

from verbteach.experiments.evaluation import Grounds, compare_criteria
from verbteach.experiments.groundings import Grounder
from verbteach.experiments.jobs import Setup, Trial
from verbteach.experiments.she16 import CRITERIA, STRONG, VARIANTS, Variant
from verbteach.perception.noise import LEVELS, READINGS, NoiseModel
from verbteach.verbs.change import ObjectSet
from verbteach.verbs.selection import Pooling

GROUNDINGS = ("corpus", "oracle", "own")
PAPERS: tuple[str, ...] = tuple(kind.value for kind in ObjectSet)
"""She & Chai's learners, by object set."""
STRONGEST = "she16"
_BEST = VARIANTS[STRONGEST]
LEARNERS: Mapping[str, Variant] = {
    **{kind.value: Variant(kind.value).with_objects(kind) for kind in ObjectSet},
    STRONGEST: _BEST,
    "she16, trusting its eyes": replace(_BEST, reenacts=False),
    "she16, all objects": _BEST.with_objects(ObjectSet.ALL),
    "she16, summing": replace(_BEST, selection=replace(STRONG, pooling=Pooling.SUM)),
    "she16, own frame": replace(
        _BEST, selection=replace(STRONG, application=replace(STRONG.application, whole_verb=False))
    ),
}
"""Ways to learn and to apply; beside the papers' the strongest one, and it with one thing less."""


@dataclass(frozen=True, order=True)
class Cell:
    """What one cell is about; ``learner`` is one of ``LEARNERS``."""

    noise: str
    reading: str
    grounding: str
    learner: str
    seed: int = 0

    @property
    def key(self) -> str:
        """A name for files."""
        words = (self.noise, self.reading, self.grounding, self.learner, str(self.seed))
        return "-".join(words).replace(", ", "-").replace(" ", "-")


class Scored(NamedTuple):
    """How one test command went."""

    ied: float
    sji: float


@dataclass(frozen=True)
class Filled:
    """A computed cell: the test commands, and by criterion how each went, in the same order.

    ``about`` is what else it hangs on: the ``program`` and the ``data``, each a short hash.
    """

    cell: Cell
    instances: tuple[str, ...]
    groups: tuple[str, ...]
    environments: tuple[str, ...]
    scores: Mapping[str, tuple[Scored, ...]]
    about: Mapping[str, str] = field(default_factory=dict)

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        return {
            "cell": asdict(self.cell),
            "about": dict(self.about),
            "instances": list(self.instances),
            "groups": list(self.groups),
            "environments": list(self.environments),
            "scores": {name: [list(one) for one in rows] for name, rows in self.scores.items()},
        }

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Filled:
        """Read a cell. Raises ``ValueError`` where it is none."""
        try:
            return cls(
                Cell(**data["cell"]),
                tuple(data["instances"]),
                tuple(data["groups"]),
                tuple(data["environments"]),
                {name: tuple(Scored(*r) for r in rows) for name, rows in data["scores"].items()},
                dict(data.get("about", {})),
            )
        except (KeyError, TypeError) as error:
            raise ValueError(f"not a cell of the grid: {error!r}") from error


Ground: TypeAlias = tuple[Grounds, Grounder]
"""What to evaluate on, and the robot's own grounding there."""
Load: TypeAlias = Callable[[], Ground]
"""Makes the ground: a hashable value that travels in its stead, called once in each process."""


def cells(
    learners: Iterable[str] = tuple(LEARNERS),
    groundings: Iterable[str] = GROUNDINGS,
    levels: Iterable[str] = LEVELS,
    readings: Iterable[str] = READINGS,
    seed: int = 0,
) -> tuple[Cell, ...]:
    """The cells, those first that most is compared with; seeing perfectly is read one way only."""
    ways = tuple(readings)
    found = [
        Cell(level, reading, grounding, learner, seed)
        for grounding, level in product(groundings, levels)
        for reading in (ways if level != "perfect" else READINGS[:1])
        for learner in learners
    ]
    return tuple(sorted(found, key=_urgency))


def _urgency(cell: Cell) -> tuple[bool, bool, int]:
    """Seeing perfectly comes first, the default grounding next, variations of the best last."""
    varied = cell.learner not in (*PAPERS, STRONGEST)
    return (varied, cell.noise != "perfect", GROUNDINGS.index(cell.grounding))


def fill(job: tuple[Cell, Load]) -> Filled:
    """Compute a cell with all criteria."""
    cell, load = job
    grounds, own = _loaded(load)
    setup = Setup(
        LEARNERS[cell.learner],
        NoiseModel.named(cell.noise, cell.reading),
        cell.grounding,
        own if cell.grounding == "own" else None,
        cell.seed,
        exact_ceiling=False,
    )
    return _filled(cell, compare_criteria(grounds, setup, CRITERIA))


@cache
def _loaded(load: Load) -> Ground:
    return load()


def _filled(cell: Cell, found: Mapping[str, Sequence[Trial]]) -> Filled:
    first = next(iter(found.values()))
    scores = {
        name: tuple(Scored(round(t.score.ied, 6), round(t.score.sji, 6)) for t in trials)
        for name, trials in found.items()
    }
    return Filled(
        cell,
        tuple(trial.instance for trial in first),
        tuple(trial.group for trial in first),
        tuple(trial.environment for trial in first),
        scores,
    )


def fill_all(
    wanted: Sequence[Cell],
    load: Load,
    known: Mapping[Cell, Filled],
    mapper: Callable[..., Iterable[Filled]] = map,
) -> Iterator[Filled]:
    """The cells in their order, computed unless known."""
    missing = iter(mapper(fill, [(cell, load) for cell in wanted if cell not in known]))
    for cell in wanted:
        yield known[cell] if cell in known else next(missing)
