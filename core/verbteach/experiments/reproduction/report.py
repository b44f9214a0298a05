"""The document of a reproduction: every table and curve from its rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from verbteach.experiments.reproduction.comparisons import (
    compared,
    matched_pairs,
    mean_questions,
    table4_pairs,
    table5_pairs,
)
from verbteach.experiments.reproduction.curves import asking, figure5, per_question
from verbteach.experiments.reproduction.design import MATCHED, STUDIED, Design
from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.reproduction.tables import SCORES, Table, cells, table4, table5


@dataclass(frozen=True)
class Report:
    """A design with its rows by section; see ``Design.sections``."""

    design: Design
    rows: Mapping[str, Sequence[Row]]

    @classmethod
    def of(cls, design: Design, rows: Mapping[str, Row]) -> Report:
        """From rows by key; all of the design's."""
        sections = design.sections()
        return cls(design, {name: [rows[t.key] for t in tasks] for name, tasks in sections.items()})

    def to_json(self) -> dict[str, Any]:
        """The document: one key a target, and what goes with it."""
        main = self.rows["main"]
        found: dict[str, Any] = {}
        if "table4" in self.design.targets:
            found["table4"] = table4(main)
            found["matched"] = matched(main)
            pairs = [*table4_pairs(main), *matched_pairs(main)]
            found["comparisons"] = [one.to_json() for one in compared(pairs)]
        if "table5" in self.design.targets:
            found["table5"] = table5(main, STUDIED)
            pairs = list(table5_pairs(main, STUDIED))
            found["table5_comparisons"] = [one.to_json() for one in compared(pairs)]
        if "figure5" in self.design.targets:
            found["figure5"] = figure5(main)
            found["figure5_ied"] = figure5(main, "ied")
            found["per_question"] = per_question(main, STUDIED)
        for name in self.rows:
            if name != "main":
                found[name] = table4(self.rows[name])
        return {**found, **self._about()}

    def _about(self) -> dict[str, Any]:
        main = self.rows["main"]
        design = self.design
        return {
            "runs": design.runs,
            "seed": design.seed,
            "noise_reading": design.reading,
            "price": design.base.training.price,
            "folds": "test data" if design.apart else design.folds,
            "instances": {
                "lessons": _mean([row.lessons for row in main]),
                "tested": _mean([len(row.commands) for row in main]),
            },
            "goals_kept": _kept(main),
            "cpu_seconds": _seconds(main),
            **dict(design.about),
        }


def matched(rows: Sequence[Row], policy: str = "rl") -> Table:
    """Rule -> noise -> both scores, stopped at ``policy``'s mean number of questions."""
    found: Table = {}
    for (name, noise), own in cells(rows).items():
        theirs = cells(rows).get((policy, noise), [])
        if name in MATCHED and theirs:
            stopped = asking(own, mean_questions(theirs))
            found.setdefault(name, {})[noise] = {
                **{score: stopped.figure(score).to_json() for score in SCORES},
                "questions_execution": stopped.questions,
                "limit": stopped.limit,
            }
    return found


def _kept(rows: Sequence[Row]) -> dict[str, dict[str, float]]:
    """Policy -> noise -> share of lessons whose goal was right."""
    found: dict[str, dict[str, float]] = {}
    for (policy, noise), own in cells(rows).items():
        found.setdefault(policy, {})[noise] = _mean([row.kept for row in own])
    return found


def _seconds(rows: Sequence[Row]) -> dict[str, float]:
    """Policy -> mean seconds of processor time of one task."""
    found: dict[str, list[float]] = {}
    for row in rows:
        found.setdefault(row.policy, []).append(row.seconds)
    return {policy: _mean(values) for policy, values in found.items()}


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)
