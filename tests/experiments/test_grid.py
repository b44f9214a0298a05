"""The grid: every cell by its own, kept as JSON, and what its tables say of known scores."""

from __future__ import annotations

import json

import pytest

from tests.experiments.shelves import grounds
from verbteach.experiments.evaluation import run_trials
from verbteach.experiments.grid import (
    LEARNERS,
    PAPERS,
    Cell,
    Filled,
    Scored,
    cells,
    fill,
    fill_all,
)
from verbteach.experiments.grid_figures import (
    Condition,
    Method,
    chosen_by_halves,
    earned,
    gathered,
    strongest,
)
from verbteach.experiments.grid_tables import HEADER, markdown, rows
from verbteach.experiments.groundings import Grounder, corpus
from verbteach.experiments.jobs import Setup
from verbteach.experiments.judging import Score
from verbteach.experiments.she16 import CRITERIA
from verbteach.perception.noise import NoiseModel


def shelves() -> tuple[object, Grounder]:
    return grounds(), corpus


def test_every_condition_has_every_learner_once() -> None:
    found = cells()
    assert len(set(found)) == len(found) == len(LEARNERS) * 3 * (1 + 3 * 2)
    assert found[0].noise == "perfect"
    assert {cell.reading for cell in cells(readings=("phantom",), levels=("std3",))} == {"phantom"}
    assert {cell.reading for cell in cells(levels=("perfect",))} == {"literal"}
    assert len({cell.key for cell in found}) == len(found)


@pytest.mark.parametrize("learner", PAPERS)
def test_a_cell_is_what_each_criterion_comes_to_alone(learner: str) -> None:
    cell = Cell("std3", "literal", "corpus", learner)
    filled = fill((cell, shelves))  # type: ignore[arg-type]
    setup = Setup(LEARNERS[learner], NoiseModel.named("std3"))
    alone = run_trials(grounds(), setup)
    assert filled.instances == tuple(trial.instance for trial in alone)
    assert filled.scores[setup.variant.criterion] == tuple(
        Scored(round(t.score.ied, 6), round(t.score.sji, 6)) for t in alone
    )
    assert set(filled.scores) == set(CRITERIA)
    assert Filled.from_json(json.loads(json.dumps(filled.to_json()))) == filled


def test_what_is_no_cell_is_refused() -> None:
    with pytest.raises(ValueError, match="not a cell"):
        Filled.from_json({"cell": {"noise": "perfect"}})


def made(learner: str, **sji: float) -> Filled:
    """A cell of four commands in four rooms; the others score a tenth of a point less each."""
    scores = {
        name: tuple(Scored(0.5, sji.get(name, 0.1) + 0.01 * room) for room in range(4))
        for name in CRITERIA
    }
    names = tuple("abcd")
    return Filled(Cell("perfect", "literal", "corpus", learner), names, names, names, scores)


def test_known_cells_are_not_computed_again() -> None:
    known = made("all")
    other = Cell("perfect", "literal", "corpus", "she16")
    asked: list[Cell] = []

    def mapper(function: object, jobs: list[tuple[Cell, object]]) -> list[Filled]:
        asked.extend(cell for cell, _ in jobs)
        return [made(cell.learner) for cell, _ in jobs]

    found = list(fill_all([known.cell, other], shelves, {known.cell: known}, mapper))  # type: ignore[arg-type]
    assert asked == [other]
    assert [one.cell for one in found] == [known.cell, other]


def test_the_strongest_is_found_and_the_oracle_is_none() -> None:
    grid = gathered(
        [made("all", most_general=0.4, oracle=0.9), made("manipulated", regression=0.3)]
    )
    learners = grid[Condition("perfect", "literal", "corpus")]
    assert strongest(learners) == Method("all", "most_general")
    one, other = chosen_by_halves(learners)
    assert one.method == other.method == Method("all", "most_general")
    assert one.elsewhere == one.other_best == other.here
    gains = {row.learner: row for row in earned(learners)}
    assert gains["all"].plain == "most_general"
    assert gains["all"].gain.mean == pytest.approx(-0.3)
    assert gains["manipulated"].gain.ci95 == pytest.approx((0.2, 0.2))


def test_tables_say_what_the_cells_say() -> None:
    found = [made("all", most_general=0.4), made("she16", regression=0.2)]
    written = list(rows(found))
    assert all(len(row) == len(HEADER) for row in written)
    assert len(written) == 2 * len(CRITERIA)
    text = markdown(found, Score(0.8, 0.95))
    assert "oracle goal .800 / .950" in text
    assert "| all | .500 / .115" in text
    assert (
        "| perfect, corpus grounding | all, most general | .415 | -0.200 [-0.200, -0.200] |" in text
    )
