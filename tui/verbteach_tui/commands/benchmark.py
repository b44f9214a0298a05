"""`verbteach benchmark`: is a Tell Me Dave folder whole, and does the project's domain fit it?"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from verbteach_tui.commands.parameters import JsonFlag
from verbteach_tui.commands.streams import columns, emit, note, progress, tell
from verbteach_tui.conclusion import CHECK_FAILED

if TYPE_CHECKING:
    from verbteach_scenarios.tell_me_dave.check import BenchmarkReport

REPRODUCED, REACHABLE = 0.995, 0.94
"""What the check asks for: the share of transitions reproduced, the mean SJI of plans."""


def check(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="The corpus's folder.")],
    as_json: JsonFlag = False,
) -> None:
    """Read a Tell Me Dave folder, run every recorded action, plan to every recorded change.

    Exit status 1 where under 99.5 % of the transitions are reproduced, or the
    plans' mean SJI is under .94.
    """
    from verbteach_scenarios.tell_me_dave.check import check_corpus

    with progress() as show:
        report = check_corpus(folder, show)
    for oddity in report.oddities:
        note(f"warning: {oddity}")
    if as_json:
        emit(report.to_json())
    else:
        _print(report)
    if report.reproduced < REPRODUCED or report.sji < REACHABLE:
        raise typer.Exit(CHECK_FAILED)


def _print(report: BenchmarkReport) -> None:
    length, cleaned = report.length, report.cleaned
    tell(
        columns(
            [
                ("documents", report.documents),
                ("environments", report.environments),
                ("clauses", report.clauses),
                ("instances", report.instances),
                ("verbs", report.verbs),
                ("noun phrases", report.noun_phrases),
                ("mean length", f"{length.mean:.2f} +- {length.sd:.2f}, {length.min}-{length.max}"),
                ("without needless moves", f"{cleaned.mean:.2f} +- {cleaned.sd:.2f}"),
                ("transitions", report.transitions),
                ("reproduced", report.reproduced),
                ("plans' mean SJI", report.sji),
                ("exact plans", report.exact),
            ]
        )
    )
    data = report.to_json()
    for title, kinds in (("differences", data["kinds"]), ("plans", data["reachable"]["kinds"])):
        tell()
        tell(f"{title} by kind")
        tell(columns([(f"  {kind}", count) for kind, count in kinds.items()] or [("  none", 0)]))
