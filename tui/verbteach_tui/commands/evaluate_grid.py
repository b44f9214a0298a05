"""`verbteach evaluate --grid`: every learner from demonstrations, under every condition."""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from verbteach_tui.commands.streams import note
from verbteach_tui.conclusion import WrongUseError

if TYPE_CHECKING:
    from verbteach.experiments.evaluation import Mapper
    from verbteach.experiments.grid import Cell, Filled, Ground
    from verbteach_scenarios.grounds import CorpusFolder


@dataclass(frozen=True)
class Part:
    """Which part of the grid: one of each, or all."""

    noise: str | None = None
    reading: str | None = None
    grounding: str | None = None
    seed: int = 0

    def cells(self) -> tuple[Cell, ...]:
        """Its cells. Raises ``WrongUseError`` for noise that the grid does not have."""
        from verbteach.experiments.grid import GROUNDINGS, cells
        from verbteach.perception.noise import LEVELS, READINGS

        if self.noise and self.noise not in LEVELS:
            raise WrongUseError(f"--noise {self.noise}: the grid has {', '.join(LEVELS)}")
        return cells(
            groundings=(self.grounding,) if self.grounding else GROUNDINGS,
            levels=(self.noise,) if self.noise else LEVELS,
            readings=(self.reading,) if self.reading else READINGS,
            seed=self.seed,
        )


def grid(
    data: CorpusFolder, out: Path, part: Part, mapper: Mapper, *, tables_only: bool = False
) -> dict[str, Any]:
    """Compute what is missing in ``out``, write the tables, and say where they are.

    What comes from another program or other data is computed again; with
    ``tables_only`` nothing is computed and all that is there is taken, and
    the tables say where it comes from.
    """
    return _Grid(data, out, part, mapper).written(tables_only)


@dataclass(frozen=True)
class _Grid:
    load: CorpusFolder
    out: Path
    part: Part
    mapper: Mapper

    @cached_property
    def _ground(self) -> Ground:
        return self.load()

    @cached_property
    def _about(self) -> dict[str, str]:
        """What cells hang on besides what they are about."""
        from verbteach.experiments.reproduction.laboratory import fingerprint
        from verbteach_scenarios.programs import program

        made_by = program("verbteach.experiments.grid", "verbteach_scenarios.grounds")
        return {"program": made_by, "data": fingerprint(self._ground[0].instances)}

    def written(self, tables_only: bool) -> dict[str, Any]:
        wanted = self.part.cells()
        folder = self.out / "cells"
        folder.mkdir(parents=True, exist_ok=True)
        kept = {cell: found for cell in wanted if (found := _kept(folder, cell)) is not None}
        done = [*kept.values()] if tables_only else self._filled(wanted, kept, folder)
        missing = [cell for cell in wanted if cell not in kept] if tables_only else []
        if not done:
            raise WrongUseError(f"{folder}: no cell of this part is there; leave --tables-only out")
        written = {"cells": len(done), "missing": len(missing), **self._tables(done, missing)}
        errors = self.out / "errors.md"
        if not tables_only:
            self._write_errors(errors)
        return {**written, "errors": str(errors) if errors.exists() else None}

    def _filled(
        self, wanted: Sequence[Cell], kept: Mapping[Cell, Filled], folder: Path
    ) -> list[Filled]:
        from verbteach.experiments.grid import fill_all

        known = {cell: one for cell, one in kept.items() if one.about == self._about}
        if other := len(kept) - len(known):
            note(f"{other} cells in {folder} are another program's or of other data: again")
        done = []
        for filled in fill_all(wanted, self.load, known, self.mapper):
            named = replace(filled, about=self._about)
            if filled.cell not in known:
                _keep(folder, named)
            done.append(named)
        return done

    def _write_errors(self, path: Path) -> None:
        """What goes wrong for the strongest learner where it sees perfectly, by kind."""
        from verbteach.experiments.grid import STRONGEST
        from verbteach.experiments.jobs import Setup
        from verbteach.experiments.mishaps import analyse, markdown
        from verbteach.experiments.she16 import VARIANTS

        origin = "\nProgram {program}, data {data}, seed {seed}.\n".format(
            **self._about, seed=self.part.seed
        )
        if not path.exists() or not path.read_text("utf-8").endswith(origin):
            setup = Setup(VARIANTS[STRONGEST], seed=self.part.seed)
            path.write_text(
                markdown(analyse(self._ground[0], setup, self.mapper)) + origin, "utf-8"
            )

    def _tables(self, done: Sequence[Filled], missing: Sequence[Cell]) -> dict[str, Any]:
        from verbteach.experiments.evaluation import ceiling_trials
        from verbteach.experiments.grid_tables import HEADER, markdown, rows
        from verbteach.experiments.judging import Score

        scores = [trial.score for trial in ceiling_trials(self._ground[0])]
        goal = Score(*(sum(values) / len(scores) for values in zip(*scores, strict=True)))
        tables = {"csv": self.out / "grid.csv", "markdown": self.out / "grid.md"}
        with tables["csv"].open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([HEADER, *rows(done)])
        tables["markdown"].write_text(markdown(done, goal, missing), "utf-8")
        return {name: str(path) for name, path in tables.items()}


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
