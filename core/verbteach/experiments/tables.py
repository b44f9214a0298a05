"""The paper's Tables 4 and 5 and Figure 5 from rows, beside the paper's own figures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from verbteach.experiments.figures import Figure, Observation, figure
from verbteach.experiments.sight import stream
from verbteach.experiments.significance import holm, paired_permutation
from verbteach.experiments.sweep import Row

Figures: TypeAlias = dict[str, dict[str, dict[str, Any]]]

PAPER_TABLE4: Mapping[str, Mapping[str, Mapping[str, float]]] = {
    "she16": {
        "perfect": {"ied": 0.430, "sji": 0.426},
        "std3": {"ied": 0.284, "sji": 0.273},
        "std5": {"ied": 0.172, "sji": 0.168},
        "uniform": {"ied": 0.168, "sji": 0.163},
    },
    "rl": {
        "perfect": {"ied": 0.453, "sji": 0.468},
        "std3": {"ied": 0.420, "sji": 0.431},
        "std5": {"ied": 0.392, "sji": 0.411},
        "uniform": {"ied": 0.332, "sji": 0.347},
    },
}
"""She & Chai (2017), Table 4."""

PAPER_TABLE5: Mapping[str, Mapping[str, Mapping[str, float]]] = {
    "rl": {
        "learning": {"ground": 2.130, "env": 2.615, "total": 4.746},
        "execution": {"ground": 0.383, "env": 0.650, "goal": 2.626, "total": 3.665},
        "score": {"ied": 0.420, "sji": 0.430},
    },
    "manual": {
        "learning": {"ground": 2.495, "env": 5.338, "total": 7.833},
        "execution": {"ground": 1.236, "env": 3.202, "goal": 2.353, "total": 6.792},
        "score": {"ied": 0.406, "sji": 0.404},
    },
    "random": {
        "learning": {"ground": 0.545, "env": 0.368, "total": 0.913},
        "execution": {"ground": 0.678, "env": 0.081, "goal": 0.151, "total": 0.909},
        "score": {"ied": 0.114, "sji": 0.113},
    },
}
"""She & Chai (2017), Table 5 (NormStd3)."""


def table4(rows: Sequence[Row], resamples: int = 1000) -> Figures:
    """Policy -> noise -> figures of both scores and of the questions, with the paper's."""
    found: Figures = {}
    for (policy, noise), own in _grouped(rows, "policy", "noise").items():
        cell: dict[str, Any] = {
            "ied": _figure(own, "ied", resamples).to_json(),
            "sji": _figure(own, "sji", resamples).to_json(),
            "questions_learning": _learning(own, resamples).to_json(),
            "questions_execution": _figure(own, "total", resamples).to_json(),
            "paper": dict(PAPER_TABLE4.get(policy, {}).get(noise, {})),
        }
        found.setdefault(policy, {})[noise] = cell
    return found


def table5(rows: Sequence[Row], resamples: int = 1000) -> Figures:
    """Policy -> phase -> questions by kind, and both scores, with the paper's."""
    found: Figures = {}
    for (policy,), own in _grouped(rows, "policy").items():
        learning = {
            kind: _constant_runs([row.learning[kind] for row in own], resamples).to_json()
            for kind in ("ground", "env")
        }
        kinds = ("ground", "env", "goal", "total")
        found[policy] = {
            "learning": {**learning, "total": _learning(own, resamples).to_json()},
            "execution": {kind: _figure(own, kind, resamples).to_json() for kind in kinds},
            "score": {name: _figure(own, name, resamples).to_json() for name in ("ied", "sji")},
            "paper": dict(PAPER_TABLE5.get(policy, {})),
        }
    return found


def figure5(rows: Sequence[Row], resamples: int = 1000) -> dict[str, list[list[Any]]]:
    """Policy -> [lessons, SJI] by growing number of lessons."""
    found: dict[str, list[list[Any]]] = {}
    for (policy, _), own in _grouped(rows, "policy", "verb_share").items():
        lessons = round(sum(row.lessons for row in own) / len(own))
        found.setdefault(policy, []).append([lessons, _figure(own, "sji", resamples).to_json()])
    return {policy: sorted(points, key=lambda p: int(p[0])) for policy, points in found.items()}


def comparisons(
    rows: Sequence[Row], policy: str = "rl", value: str = "sji", flips: int = 5000
) -> list[dict[str, Any]]:
    """Every other policy against ``policy`` at each noise level, on the same runs and commands.

    ``difference`` is positive where ``policy`` is ahead; ``p`` is Holm's over
    all comparisons; ``improvement`` is relative, as in the paper's Table 4.
    """
    cells = _grouped(rows, "policy", "noise")
    found = []
    for name, noise in cells:
        if name != policy and (policy, noise) in cells:
            mine, theirs = _paired(cells[policy, noise], cells[name, noise], value)
            rng = stream("comparison", policy, name, noise, value)
            chance = paired_permutation(mine, theirs, rng, flips)
            ours, other = _mean(mine), _mean(theirs)
            found.append(
                {
                    "policy": policy,
                    "other": name,
                    "noise": noise,
                    "difference": ours - other,
                    "improvement": ours / other - 1.0 if other else None,
                    "p": chance,
                }
            )
    for one, corrected in zip(found, holm([row["p"] for row in found]), strict=True):
        one["p"] = corrected
    return found


def per_question(rows: Sequence[Row]) -> dict[str, list[tuple[float, float]]]:
    """Policy -> (questions asked per command, SJI) of each configuration, by questions."""
    found: dict[str, list[tuple[float, float]]] = {}
    for row in rows:
        asked = sum(c.total for c in row.commands) / max(1, len(row.commands))
        score = sum(c.sji for c in row.commands) / max(1, len(row.commands))
        found.setdefault(row.policy, []).append((asked, score))
    return {policy: sorted(points) for policy, points in found.items()}


def markdown4(
    table: Figures, noises: Sequence[str] = ("perfect", "std3", "std5", "uniform")
) -> str:
    """Table 4 as Markdown: ours with its interval, the paper's in brackets."""
    lines = ["| policy | noise | IED | SJI | questions, learning | questions, execution |"]
    lines.append("|---|---|---|---|---|---|")
    for policy, cells in table.items():
        for noise in noises:
            if noise in cells:
                cell = cells[noise]
                paper = cell["paper"]
                lines.append(
                    f"| {policy} | {noise} | {_cell(cell['ied'], paper.get('ied'))}"
                    f" | {_cell(cell['sji'], paper.get('sji'))}"
                    f" | {_short(cell['questions_learning'])}"
                    f" | {_short(cell['questions_execution'])} |"
                )
    return "\n".join(lines) + "\n"


def markdown5(table: Figures) -> str:
    """Table 5 as Markdown: ours, the paper's in brackets."""
    heads = ["learning ground", "learning env", "learning total", "execution ground"]
    heads += ["execution env", "execution goal", "execution total", "score ied", "score sji"]
    lines = ["| policy | " + " | ".join(heads) + " |", "|---" * (len(heads) + 1) + "|"]
    for policy, cells in table.items():
        shown = []
        for head in heads:
            phase, kind = head.split()
            theirs = cells["paper"].get(phase, {}).get(kind)
            shown.append(_short(cells[phase][kind]) + (f" ({theirs:.3f})" if theirs else ""))
        lines.append(f"| {policy} | " + " | ".join(shown) + " |")
    return "\n".join(lines) + "\n"


def _grouped(rows: Sequence[Row], *names: str) -> dict[tuple[Any, ...], list[Row]]:
    """Rows by some of their configuration's values, in the order they come; runs in order."""
    found: dict[tuple[Any, ...], list[Row]] = {}
    for row in rows:
        found.setdefault(tuple(row.config[name] for name in names), []).append(row)
    return {key: sorted(own, key=_run) for key, own in found.items()}


def _paired(
    rows: Sequence[Row], others: Sequence[Row], value: str
) -> tuple[list[list[Observation]], list[list[Observation]]]:
    by_run = {_run(row): row for row in others}
    both = [(row, by_run[_run(row)]) for row in rows if _run(row) in by_run]
    return [a.observations(value) for a, _ in both], [b.observations(value) for _, b in both]


def _run(row: Row) -> int:
    return int(row.config["run"])


def _figure(rows: Sequence[Row], value: str, resamples: int) -> Figure:
    rng = stream("figure", value, *(row.key for row in rows))
    return figure([row.observations(value) for row in rows], rng, resamples)


def _learning(rows: Sequence[Row], resamples: int) -> Figure:
    totals = [row.learning["ground"] + row.learning["env"] for row in rows]
    return _constant_runs(totals, resamples)


def _constant_runs(values: Sequence[float], resamples: int) -> Figure:
    """A figure of one value a run: only the runs are resampled."""
    runs = [[Observation("run", value)] for value in values]
    return figure(runs, stream("runs", *map(repr, values)), resamples)


def _mean(runs: Sequence[Sequence[Observation]]) -> float:
    values = [one.value for run in runs for one in run]
    return sum(values) / len(values)


def _cell(figure_json: Mapping[str, Any], paper: float | None) -> str:
    low, high = figure_json["ci95"]
    shown = f"{figure_json['mean']:.3f} [{low:.3f}, {high:.3f}]"
    return shown + (f" (paper {paper:.3f})" if paper is not None else "")


def _short(figure_json: Mapping[str, Any]) -> str:
    return f"{figure_json['mean']:.2f} ± {figure_json['sd']:.2f}"
