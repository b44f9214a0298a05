"""The paper's Tables 4 and 5 from rows, as JSON: our figures, and the paper's beside them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from verbteach.experiments.figures import Figure, Observation, figure
from verbteach.experiments.reproduction.paper import PAPER_VARIANT, TABLE5, of_table4
from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.sight import stream

Table: TypeAlias = dict[str, dict[str, Any]]

EXECUTION_KINDS = ("ground", "env", "goal", "total")
LEARNING_KINDS = ("ground", "env", "total")
SCORES = ("ied", "sji")
RESAMPLES = 2000


def table4(rows: Sequence[Row], resamples: int = RESAMPLES) -> Table:
    """Policy -> noise -> both scores and the questions of both phases, with the paper's scores."""
    found: Table = {}
    for (policy, noise), own in cells(rows).items():
        found.setdefault(policy, {})[noise] = {
            **{name: figure_of(own, name, resamples).to_json() for name in SCORES},
            "questions_learning": learning_figure(own, "total", resamples).to_json(),
            "questions_execution": figure_of(own, "total", resamples).to_json(),
            "paper": dict(of_table4(policy, noise)),
        }
    return found


def table5(rows: Sequence[Row], noise: str, resamples: int = RESAMPLES) -> Table:
    """Policy -> questions of both phases by kind, and both scores, at one noise level."""
    found: Table = {}
    for (policy, level), own in cells(rows).items():
        if level == noise:
            found[policy] = {
                "learning": {
                    kind: learning_figure(own, kind, resamples).to_json() for kind in LEARNING_KINDS
                },
                "execution": {
                    kind: figure_of(own, kind, resamples).to_json() for kind in EXECUTION_KINDS
                },
                **{name: figure_of(own, name, resamples).to_json() for name in SCORES},
                "paper": paper5(policy),
            }
    return found


def paper5(policy: str) -> Mapping[str, Any]:
    """The paper's row of Table 5, or its scores alone where Table 5 has no such row."""
    if policy in TABLE5:
        own = TABLE5[policy]
        return {"learning": own["learning"], "execution": own["execution"], **own["score"]}
    return dict(of_table4(policy, "std3")) if policy == PAPER_VARIANT else {}


def cells(rows: Sequence[Row]) -> dict[tuple[str, str], list[Row]]:
    """Rows by policy and noise in the order they come first; each cell's in the runs' order."""
    found: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        found.setdefault((row.policy, row.noise), []).append(row)
    return {key: sorted(own, key=lambda row: row.run) for key, own in found.items()}


def figure_of(rows: Sequence[Row], value: str, resamples: int = RESAMPLES) -> Figure:
    """A figure over all commands of the rows, one row a run."""
    rng = stream("figure", value, *(row.place for row in rows))
    return figure([row.observations(value) for row in rows], rng, resamples)


def learning_figure(rows: Sequence[Row], kind: str, resamples: int = RESAMPLES) -> Figure:
    """Questions per lesson; only runs are resampled, as lessons are not kept one by one."""
    runs = [[Observation("run", row.learned(kind))] for row in rows]
    return figure(runs, stream("learning", kind, *(row.place for row in rows)), resamples)
