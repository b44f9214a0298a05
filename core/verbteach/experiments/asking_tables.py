"""The analysis of a robot that asks, as plain values and as Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from verbteach.experiments.asking_ceilings import ceilings, ceilings_table, further_questions
from verbteach.experiments.asking_examples import telling, told
from verbteach.experiments.asking_gains import by_kind
from verbteach.experiments.asking_mishaps import Analysis, Cause
from verbteach.language.wording import Wording

VERBS = 15
"""So many verbs are in the table, the most frequent."""
EXAMPLES = 4
"""So many commands are told of each cause."""


def cause_rows(analysis: Analysis) -> list[dict[str, Any]]:
    """The causes with what each takes from the mean SJI, the dearest first."""
    rows = [_cause_row(analysis, cause) for cause in Cause if analysis.of(cause)]
    return sorted(rows, key=lambda row: -row["lost"])


def _cause_row(analysis: Analysis, cause: Cause) -> dict[str, Any]:
    found = analysis.of(cause)
    return {
        "cause": cause.name.lower(),
        "meaning": cause.value,
        "commands": len(found),
        "lost": analysis.lost_by(cause),
        "share": analysis.lost_by(cause) / analysis.lost,
        "sji": _mean(one.sji for one in found),
        "expected": _mean(one.expected for one in found),
        "questions": _mean(float(len(one.questions)) for one in found),
        "further": _mean(float(one.outcomes.further) for one in found),
    }


def verb_rows(analysis: Analysis, most: int = VERBS) -> list[dict[str, Any]]:
    """The most frequent verbs, and the cause that cost each of them most."""
    return [_verb_row(analysis, verb) for verb in analysis.verbs[:most]]


def _verb_row(analysis: Analysis, verb: str) -> dict[str, Any]:
    found = analysis.verb(verb)
    lost = sum(one.lost for one in found)
    dearest = max(Cause, key=lambda c: sum(one.lost for one in found if one.cause is c))
    return {
        "verb": verb,
        "commands": len(found),
        "sji": _mean(one.sji for one in found),
        "questions": _mean(float(len(one.questions)) for one in found),
        "share": lost / (analysis.lost * len(analysis.commands)) if lost else 0.0,
        "cause": dearest.name.lower() if lost else None,
    }


def question_rows(analysis: Analysis) -> list[dict[str, Any]]:
    """The types of questions, and what they brought."""
    kinds = by_kind(question for one in analysis.commands for question in one.questions)
    return [
        {
            "question": kind.name,
            "asked": kind.asked,
            "per_command": kind.asked / len(analysis.commands),
            "yes": kind.yes,
            "expected": kind.expected,
            "gained": kind.gained,
            "helped": kind.helped,
            "harmed": kind.harmed,
        }
        for kind in kinds
    ]


def to_json(analyses: Mapping[str, Analysis]) -> dict[str, Any]:
    """The document; ``analyses`` by grounding: the causes are of the first, the ceilings of all."""
    analysis = next(iter(analyses.values()))
    return {
        "commands": len(analysis.commands),
        "exact": sum(one.cause is None for one in analysis.commands),
        "lost": analysis.lost,
        "causes": cause_rows(analysis),
        "verbs": verb_rows(analysis),
        "asked": question_rows(analysis),
        "further": further_questions(analysis),
        "ceilings": ceilings(analyses),
    }


def markdown(analyses: Mapping[str, Analysis], words: Wording) -> str:
    """The tables, and commands of each cause, those that lost most, in ``words``."""
    analysis = next(iter(analyses.values()))
    exact = sum(one.cause is None for one in analysis.commands)
    parts = [
        f"Of {len(analysis.commands)} commands {exact} were done exactly as demonstrated;"
        f" the others take {analysis.lost:.3f} from the mean SJI.",
        _causes(analysis),
        "**How far it could come**",
        ceilings_table(analyses),
        f"To its end ManualPolicy would have asked {further_questions(analysis):.1f} questions"
        " more a command.",
        "**By question**",
        _questions(analysis),
        "**By verb**",
        _verbs(analysis),
    ]
    for row in cause_rows(analysis):
        found = telling(analysis.of(Cause[row["cause"].upper()]), EXAMPLES)
        lines = "\n".join(f"- {told(one, words)}" for one in found)
        parts.append(f"**{row['meaning'].capitalize()}**\n\n{lines}")
    return "\n\n".join(parts) + "\n"


def _causes(analysis: Analysis) -> str:
    heads = ("cause", "commands", "SJI lost", "share", "SJI", "expected", "asked", "further")
    return _table(
        heads,
        (
            (
                row["meaning"],
                str(row["commands"]),
                f"{row['lost']:.3f}",
                f"{row['share']:.0%}",
                f"{row['sji']:.2f}",
                f"{row['expected']:.2f}",
                f"{row['questions']:.1f}",
                f"{row['further']:.1f}",
            )
            for row in cause_rows(analysis)
        ),
    )


def _questions(analysis: Analysis) -> str:
    heads = ("question", "asked", "a command", "yes", "gain expected", "gained", "helped", "harmed")
    return _table(
        heads,
        (
            (
                f"`{row['question']}`",
                str(row["asked"]),
                f"{row['per_command']:.2f}",
                f"{row['yes']:.0%}",
                "" if row["expected"] is None else f"{row['expected']:.3f}",
                f"{row['gained']:.3f}",
                f"{row['helped']:.0%}",
                f"{row['harmed']:.0%}",
            )
            for row in question_rows(analysis)
        ),
    )


def _verbs(analysis: Analysis) -> str:
    heads = ("verb", "commands", "SJI", "asked", "share of the loss", "what cost most")
    return _table(
        heads,
        (
            (
                row["verb"],
                str(row["commands"]),
                f"{row['sji']:.2f}",
                f"{row['questions']:.1f}",
                f"{row['share']:.0%}",
                Cause[row["cause"].upper()].value if row["cause"] else "",
            )
            for row in verb_rows(analysis)
        ),
    )


def _table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _mean(values: Iterable[float]) -> float:
    found = list(values)
    return sum(found) / len(found) if found else 0.0
