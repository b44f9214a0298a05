"""The grid as rows for a spreadsheet and as tables to read."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from verbteach.experiments.figures import Figure
from verbteach.experiments.grid import STRONGEST, Cell, Filled
from verbteach.experiments.grid_figures import (
    Condition,
    Grid,
    both,
    chosen_by_halves,
    difference,
    earned,
    gathered,
    mean,
    strongest,
)
from verbteach.experiments.judging import Score
from verbteach.experiments.she16 import CRITERIA, ORACLE, VARIANTS

ABOUT = ("program", "data")
HEADER = (
    "noise", "reading", "grounding", "learner", "criterion", "instances",
    "ied", "ied_low", "ied_high", "sji", "sji_low", "sji_high",
)  # fmt: skip


def rows(cells: Sequence[Filled]) -> Iterator[tuple[str | int | float, ...]]:
    """A row for each cell and criterion, as ``HEADER``."""
    for one in cells:
        cell = one.cell
        for criterion in one.scores:
            found = both(one, criterion)
            yield (
                *(cell.noise, cell.reading, cell.grounding, cell.learner, criterion),
                len(one.instances),
                *(round(x, 4) for x in (found.ied.mean, *found.ied.ci95)),
                *(round(x, 4) for x in (found.sji.mean, *found.sji.ci95)),
            )


def markdown(cells: Sequence[Filled], goal: Score, missing: Sequence[Cell] = ()) -> str:
    """All tables; ``goal`` is what planning to the whole demonstrated change comes to.

    ``missing`` are cells that are not computed.
    """
    grid = gathered(cells)
    parts = [_condition(condition, learners, goal) for condition, learners in grid.items()]
    parts += [_strongest(grid), _halves(grid), _earned(grid), _origin(cells, missing)]
    return "\n\n".join(parts) + "\n"


def _condition(condition: Condition, learners: Mapping[str, Filled], goal: Score) -> str:
    title = f"### {_named(condition)}"
    reached = f"{_short(goal.ied)} / {_short(goal.sji)}"
    ceiling = f"Ceilings: oracle selection in the last column; oracle goal {reached}."
    heads = ["learner", *(_words(name) for name in CRITERIA)]
    body = [
        [learner, *(_score(filled, name) for name in CRITERIA)]
        for learner, filled in learners.items()
    ]
    return f"{title}\n\n{_table(heads, body)}\n\n{ceiling}"


def _score(filled: Filled, criterion: str) -> str:
    found = both(filled, criterion)
    low, high = found.sji.ci95
    text = f"{_short(found.ied.mean)} / {_short(found.sji.mean)} [{_short(low)}, {_short(high)}]"
    return f"*{text}*" if criterion == ORACLE else text


def _strongest(grid: Grid) -> str:
    body = []
    for condition, learners in grid.items():
        best = strongest(learners)
        body.append([_named(condition), str(best), _short(mean(learners, best)), _behind(learners)])
    heads = ["condition", "strongest", "SJI", f"{STRONGEST} against it"]
    return f"## The strongest\n\n{_table(heads, body)}"


def _behind(learners: Mapping[str, Filled]) -> str:
    """How ``she16`` as it is defined compares with the strongest there."""
    if STRONGEST not in learners:
        return "not computed"
    best = strongest(learners)
    own = VARIANTS[STRONGEST].criterion
    if best == (STRONGEST, own):
        return "the same"
    return _gain(difference(learners[STRONGEST], own, learners[best.learner], best.criterion))


def _halves(grid: Grid) -> str:
    body = [
        [
            _named(condition), str(one.method),
            _short(one.here), _short(one.elsewhere), _short(one.other_best),
        ]
        for condition, learners in grid.items()
        for one in chosen_by_halves(learners)
    ]  # fmt: skip
    heads = ["condition", "chosen", "SJI there", "on the other half", "best on the other half"]
    return f"## Chosen on half of the environments\n\n{_table(heads, body)}"


def _earned(grid: Grid) -> str:
    body = [
        [_named(condition), one.learner, _words(one.plain), _gain(one.gain)]
        for condition, learners in grid.items()
        for one in earned(learners)
    ]
    heads = ["condition", "learner", "its best plain criterion", "regression against it (SJI)"]
    return f"## What the regression earns\n\n{_table(heads, body)}"


def _origin(cells: Sequence[Filled], missing: Sequence[Cell]) -> str:
    """Which programs and data the cells come from, and what is not there."""
    counts = Counter(tuple(one.about.get(n, "unknown") for n in ABOUT) for one in cells)
    body = [[*names, str(count)] for names, count in sorted(counts.items())]
    table = _table([*ABOUT, "cells"], body)
    conditions = Counter(_named(Condition.of(cell)) for cell in missing)
    lines = [f"- {name}: {count} learners" for name, count in conditions.items()]
    lacking = "\n\nNot computed:\n\n" + "\n".join(lines) if lines else ""
    return f"## Where the figures come from\n\n{table}{lacking}"


def _gain(figure: Figure) -> str:
    low, high = figure.ci95
    return f"{figure.mean:+.3f} [{low:+.3f}, {high:+.3f}]"


def _named(condition: Condition) -> str:
    noise = condition.noise
    seen = noise if noise == "perfect" else f"{noise}, {condition.reading}"
    return f"{seen}, {condition.grounding} grounding"


def _words(name: str) -> str:
    return name.replace("_", " ")


def _short(value: float) -> str:
    return f"{value:.3f}".replace("0.", ".", 1)


def _table(heads: Sequence[str], body: Sequence[Sequence[str]]) -> str:
    lines = [heads, ["---"] * len(heads), *body]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
