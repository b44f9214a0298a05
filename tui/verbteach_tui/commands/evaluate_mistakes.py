"""`verbteach evaluate --mistakes`: what a robot that asks loses, put down to causes."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from verbteach_tui.commands.evaluate_policy import (
    Question,
    bench_for,
    given_policies,
    policy_document,
    staged,
)
from verbteach_tui.commands.streams import Progress, columns, tell
from verbteach_tui.conclusion import WrongUseError

if TYPE_CHECKING:
    from verbteach_scenarios.grounds import EvaluationData


def mistakes_document(
    asked: Question, data: EvaluationData, show: Progress, out: Path | None, ceilings: bool
) -> dict[str, Any]:
    """The scores of a policy that asks, with its first run's mistakes; into ``out`` as pages too.

    With ``ceilings`` another run is held with oracle grounding.
    """
    from verbteach.experiments.asking_mishaps import Examiner, analyse
    from verbteach.experiments.asking_tables import markdown, to_json
    from verbteach.language.wording import Wording

    folder = None if out is None else _folder(out)
    first = asked.config(0, data.apart)
    examiner = Examiner(first)
    document = policy_document(asked, data, show, examiner)
    analyses = {asked.grounding: examiner.analysis()}
    if ceilings and asked.grounding != "oracle":
        bench = bench_for(replace(asked, grounding="oracle"), data)
        analyses["oracle"] = analyse(bench, first, given_policies(asked), staged(show))
    document |= {"mistakes": to_json(analyses)}
    if folder is not None:
        page, values = folder / "mistakes.md", folder / "mistakes.json"
        page.write_text(markdown(analyses, Wording(data.own.lexicon, str)), "utf-8")
        values.write_text(json.dumps(document, indent=2, ensure_ascii=False) + "\n", "utf-8")
        document |= {"markdown": str(page)}
    return document


def print_mistakes(document: dict[str, Any]) -> None:
    """The causes and the types of questions; where the page is."""
    found = document["mistakes"]
    tell()
    rows: list[tuple[object, ...]] = [("CAUSE", "COMMANDS", "SJI LOST", "SHARE")]
    rows += [(c["meaning"], c["commands"], c["lost"], c["share"]) for c in found["causes"]]
    tell(columns(rows))
    tell()
    heads: list[tuple[object, ...]] = [("QUESTION", "ASKED", "GAIN EXPECTED", "GAINED")]
    heads += [(q["question"], q["asked"], q["expected"], q["gained"]) for q in found["asked"]]
    tell(columns([tuple("" if cell is None else cell for cell in row) for row in heads]))
    if "markdown" in document:
        tell()
        tell(f"written: {document['markdown']}")


def _folder(out: Path) -> Path:
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise WrongUseError(f"{out}: cannot be made a folder, {error.strerror}") from error
    return out
