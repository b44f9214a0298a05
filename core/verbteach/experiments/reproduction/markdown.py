"""The document of a reproduction as Markdown: our figures, and the paper's in brackets."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from verbteach.experiments.reproduction.paper import NOISE_NAMES, PAPER_VARIANT, of_table4

NAMES: Mapping[str, str] = {
    "rl": "RL",
    "manual": "Manual",
    "random": "Random",
    "split": "split",
    "she16": "She16, strongest",
    "she16-all": "She16, paper's",
}
"""What the tables call the policies."""


def markdown(document: Mapping[str, Any]) -> str:
    """Every table of the document that it has, with a heading each."""
    parts = [_about(document)]
    if "table4" in document:
        parts += [_table4(document), _improvements(document), _matched(document)]
    if "table5" in document:
        parts.append(_table5(document))
    if "figure5" in document:
        parts += [_figure5(document), _per_question(document)]
    parts += [_beside(document, name) for name in BESIDE if name in document]
    return "\n\n".join(parts) + "\n"


BESIDE: Mapping[str, str] = {
    "phantom": "The phantom reading of the noise",
    "harder_teacher": "A teacher of whose yes/no answers 20 % are wrong",
    "harder_teacher_doubted": "The same teacher, whose answers are trusted at .8",
    "harder_teacher_paper_prices": "Trusted so, and questions at the paper's prices",
    "paper_prices": "The learned policy at the paper's prices of questions",
}


def _about(document: Mapping[str, Any]) -> str:
    counts = document["instances"]
    return (
        f"# Reproduction\n\nRuns: {document['runs']}, seed {document['seed']}; noise reading "
        f"{document['noise_reading']}, grounding {document.get('grounding', 'corpus')}, "
        f"environments held out: {document['folds']}; on average {counts['lessons']:.0f} lessons "
        f"and {counts['tested']:.0f} test commands a run. In square brackets 95 % intervals "
        "(two-level bootstrap: runs, then documents), in round ones the paper's figures. RL was "
        f"trained with questions {document['price']:g} times as dear as the paper's."
    )


def _table4(document: Mapping[str, Any]) -> str:
    heads = ("policy", "noise", "IED", "SJI", "questions, learning", "questions, execution")
    return "## Table 4\n\n" + table(heads, _scores(document["table4"]))


def _scores(cells: Mapping[str, Mapping[str, Any]]) -> Iterator[list[str]]:
    for policy, by_noise in cells.items():
        for noise, cell in by_noise.items():
            paper = cell["paper"]
            yield [
                NAMES.get(policy, policy),
                NOISE_NAMES[noise],
                _cell(cell["ied"], paper.get("ied")),
                _cell(cell["sji"], paper.get("sji")),
                _short(cell["questions_learning"]),
                _short(cell["questions_execution"]),
            ]


def _improvements(document: Mapping[str, Any]) -> str:
    """RL's improvement over each other policy, as in the paper's last two columns."""
    rows = []
    for one in document["comparisons"]:
        paper = None
        if one["other"] == PAPER_VARIANT:
            ours, theirs = (of_table4(p, one["noise"])[one["value"]] for p in ("rl", "she16"))
            paper = f" ({100 * (ours / theirs - 1):.1f} %\\*)"
        share = "" if one["improvement"] is None else f"{100 * one['improvement']:+.1f} %"
        rows.append(
            [
                _name(one["other"]),
                NOISE_NAMES[one["noise"]],
                one["value"].upper(),
                f"{one['difference']:+.3f}",
                share + _star(one["p"], 0.01) + (paper or ""),
                f"{one['p']:.4f}",
            ]
        )
    heads = ("RL against", "noise", "score", "difference", "% improvement", "p")
    about = (
        "Paired permutation tests on the same runs and commands, signs of whole documents "
        "permuted, p corrected by Holm's method over all rows; \\* p < .01."
    )
    return f"### RL against the others\n\n{about}\n\n{table(heads, rows)}"


def _matched(document: Mapping[str, Any]) -> str:
    rows = [
        [
            _name(f"{policy} (same questions)"),
            NOISE_NAMES[noise],
            _cell(cell["ied"]),
            _cell(cell["sji"]),
            f"{cell['questions_execution']:.2f}",
            f"{cell['limit']:.2f}",
        ]
        for policy, by_noise in document["matched"].items()
        for noise, cell in by_noise.items()
    ]
    heads = ("policy", "noise", "IED", "SJI", "questions, execution", "limit")
    about = (
        "The rules, stopped in execution at the limit with which they ask as many questions on "
        "average as RL does; a fraction is the probability of one more question. Random here "
        "asks on until the limit."
    )
    return f"### At RL's own mean number of questions\n\n{about}\n\n{table(heads, rows)}"


def _table5(document: Mapping[str, Any]) -> str:
    phases = [("learning", kind) for kind in ("ground", "env", "total")]
    phases += [("execution", kind) for kind in ("ground", "env", "goal", "total")]
    chances = {one["value"]: one["p"] for one in document["table5_comparisons"]}
    rows = []
    for policy, own in document["table5"].items():
        row = [NAMES.get(policy, policy)]
        for phase, kind in phases:
            value = f"learning {kind}" if phase == "learning" else kind
            theirs = own["paper"].get(phase, {}).get(kind)
            row.append(_marked(own[phase][kind], theirs, policy, chances.get(value)))
        for score in ("ied", "sji"):
            theirs = own["paper"].get(score)
            row.append(_marked(own[score], theirs, policy, chances.get(score), places=3))
        rows.append(row)
    heads = ["policy", *(f"{phase}, {kind}" for phase, kind in phases), "IED", "SJI"]
    about = (
        "NormStd3. Questions per lesson and per command, ± the standard deviation over runs; "
        "\\* RL differs from Manual, p < .05 after Holm's correction."
    )
    return f"## Table 5\n\n{about}\n\n{table(heads, rows)}"


def _figure5(document: Mapping[str, Any]) -> str:
    rows = [
        [NAMES.get(policy, policy), str(lessons), _cell(ied[1]), _cell(sji)]
        for policy, points in document["figure5"].items()
        for (lessons, sji), ied in zip(points, document["figure5_ied"][policy], strict=True)
    ]
    heads = ("policy", "lessons", "IED", "SJI")
    return f"## Figure 5\n\nNormStd3.\n\n{table(heads, rows)}"


def _per_question(document: Mapping[str, Any]) -> str:
    rows = [
        [NAMES.get(policy, policy), f"{questions:.2f}", _cell(sji)]
        for policy, points in document["per_question"].items()
        for questions, sji in points
    ]
    about = (
        "NormStd3. Each policy stopped after no question, one, two and so on, and asked on where "
        "it would have ended; a command that leaves nothing to ask counts with what was asked."
    )
    heads = ("policy", "questions", "SJI")
    return f"## SJI against questions asked\n\n{about}\n\n{table(heads, rows)}"


def _beside(document: Mapping[str, Any], name: str) -> str:
    heads = ("policy", "noise", "IED", "SJI", "questions, learning", "questions, execution")
    return f"## {BESIDE[name]}\n\n" + table(heads, _scores(document[name]))


def table(heads: Sequence[str], rows: Iterator[list[str]] | Sequence[list[str]]) -> str:
    """A Markdown table."""
    lines = [list(heads), ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def _name(other: str) -> str:
    policy, _, rest = other.partition(" ")
    return f"{NAMES.get(policy, policy)} {rest}".strip()


def _cell(figure: Mapping[str, Any], paper: float | None = None) -> str:
    low, high = figure["ci95"]
    shown = f"{figure['mean']:.3f} [{low:.3f}, {high:.3f}]"
    return shown + (f" ({paper:.3f})" if paper is not None else "")


def _short(figure: Mapping[str, Any], places: int = 2) -> str:
    return f"{figure['mean']:.{places}f} ± {figure['sd']:.{places}f}"


def _marked(
    figure: Mapping[str, Any],
    paper: float | None,
    policy: str,
    chance: float | None,
    places: int = 2,
) -> str:
    star = _star(chance, 0.05) if policy == "rl" and chance is not None else ""
    return _short(figure, places) + star + (f" ({paper:.3f})" if paper is not None else "")


def _star(chance: float, below: float) -> str:
    return "\\*" if chance < below else ""
