"""How far a robot that asks could come: what each thing that it lacks would bring.

The groundings are two runs, each with policies of its own: ``oracle`` narrows
what noun phrases may mean to what the demonstration changed, so it looks at
the outcome. Within a run one thing at a time is put right.
"""

from __future__ import annotations

from collections.abc import Mapping

from verbteach.experiments.asking_counterfactuals import MENDS
from verbteach.experiments.asking_mishaps import Analysis

TITLES: Mapping[str, str] = {
    "own": "as it went",
    "grounded": "noun phrases settled",
    "seen": "room seen as it is",
    "asked_on": "asked on to ManualPolicy's end",
    "answered": "all goal questions answered",
    "goal": "the true change planned to",
}


def ceilings(analyses: Mapping[str, Analysis]) -> dict[str, dict[str, dict[str, float]]]:
    """By grounding and then by what is put right: mean IED and SJI, as plain values."""
    return {
        grounding: {mend: analysis.score(mend)._asdict() for mend in MENDS}
        for grounding, analysis in analyses.items()
    }


def ceilings_table(analyses: Mapping[str, Analysis]) -> str:
    """The same in Markdown, IED / SJI; the groundings are the columns."""
    rows = [("IED / SJI", *(f"`{grounding}` grounding" for grounding in analyses))]
    rows.append(tuple("---" for _ in rows[0]))
    for mend in MENDS:
        scores = (analysis.score(mend) for analysis in analyses.values())
        rows.append((TITLES[mend], *(f"{one.ied:.3f} / {one.sji:.3f}" for one in scores)))
    asked = (questions_asked(analysis) for analysis in analyses.values())
    rows.append(("questions asked, as it went", *(f"{mean:.2f}" for mean in asked)))
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def questions_asked(analysis: Analysis) -> float:
    """How many questions were asked, a command."""
    asked = [len(one.questions) for one in analysis.commands]
    return sum(asked) / len(asked)


def further_questions(analysis: Analysis) -> float:
    """How many questions ManualPolicy would still ask, a command."""
    further = [one.outcomes.further for one in analysis.commands]
    return sum(further) / len(further)
