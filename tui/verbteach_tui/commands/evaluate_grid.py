"""`verbteach evaluate --grid`: every learner from demonstrations, under every condition."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from verbteach_tui.conclusion import WrongUseError

if TYPE_CHECKING:
    from verbteach.experiments.evaluation import Grounds, Mapper
    from verbteach.experiments.grid import Cell, Filled


def grid(
    data: Path, out: Path, levels: Sequence[str], readings: Sequence[str], seed: int, mapper: Mapper
) -> dict[str, Any]:
    """Compute what is missing in ``out``, write the tables, and say where they are."""
    from verbteach.experiments.grid import LEARNERS, cells, fill_all
    from verbteach_scenarios.grounds import CorpusFolder

    wanted = cells(tuple(LEARNERS), levels=levels, readings=readings, seed=seed)
    folder = out / "cells"
    folder.mkdir(parents=True, exist_ok=True)
    known = {cell: found for cell in wanted if (found := _kept(folder, cell)) is not None}
    load = CorpusFolder(data)
    done = []
    for filled in fill_all(wanted, load, known, mapper):
        if filled.cell not in known:
            _keep(folder, filled)
        done.append(filled)
    grounds, _ = load()
    return {**_written(out, done, grounds), "errors": str(_errors(out, grounds, seed, mapper))}


def _errors(out: Path, grounds: Grounds, seed: int, mapper: Mapper) -> Path:
    """What goes wrong for the strongest learner where it sees perfectly, by kind."""
    from verbteach.experiments.grid import STRONGEST
    from verbteach.experiments.jobs import Setup
    from verbteach.experiments.mishaps import analyse, markdown
    from verbteach.experiments.she16 import VARIANTS

    path = out / "errors.md"
    if not path.exists():
        analysis = analyse(grounds, Setup(VARIANTS[STRONGEST], seed=seed), mapper)
        path.write_text(markdown(analysis), "utf-8")
    return path


def _kept(folder: Path, cell: Cell) -> Filled | None:
    from verbteach.experiments.grid import Filled

    path = folder / f"{cell.key}.json"
    if not path.exists():
        return None
    try:
        found = Filled.from_json(json.loads(path.read_text("utf-8")))
    except ValueError as error:
        raise WrongUseError(f"{path}: {error}; delete it to compute it again") from error
    if found.cell != cell:
        raise WrongUseError(f"{path} is another cell's; delete it to compute it again")
    return found


def _keep(folder: Path, filled: Filled) -> None:
    """Written beside and moved, so that a cell is there whole or not at all."""
    path = folder / f"{filled.cell.key}.json"
    fresh = path.with_suffix(".part")
    fresh.write_text(json.dumps(filled.to_json()), "utf-8")
    fresh.replace(path)


def _written(out: Path, done: Sequence[Filled], grounds: Grounds) -> dict[str, Any]:
    from verbteach.experiments.evaluation import ceiling_trials
    from verbteach.experiments.grid_tables import HEADER, markdown, rows
    from verbteach.experiments.judging import Score

    scores = [trial.score for trial in ceiling_trials(grounds)]
    goal = Score(*(sum(values) / len(scores) for values in zip(*scores, strict=True)))
    tables = {"csv": out / "grid.csv", "markdown": out / "grid.md"}
    with tables["csv"].open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([HEADER, *rows(done)])
    tables["markdown"].write_text(markdown(done, goal), "utf-8")
    return {"cells": len(done), **{name: str(path) for name, path in tables.items()}}
