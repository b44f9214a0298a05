"""`verbteach reproduce`: the paper's tables and figure, on a corpus or on the bundled lessons."""

from __future__ import annotations

import json
import os
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

import typer

from verbteach_tui.commands.corpora import tell_left_out
from verbteach_tui.commands.parameters import JsonFlag, NoiseReading, SeedOption, chosen
from verbteach_tui.commands.streams import Progress, emit, note, progress, tell
from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.workers import Workers

if TYPE_CHECKING:
    from verbteach.experiments.interactive_protocol import Config
    from verbteach.experiments.reproduction.design import Design
    from verbteach.experiments.reproduction.report import Report
    from verbteach.experiments.reproduction.rows import Row
    from verbteach_scenarios.laboratories import LaboratorySource
    from verbteach_scenarios.rows_file import RowsFile

Target: TypeAlias = Literal["table4", "table5", "figure5", "all"]

ROWS, CSV, TABLES, DOCUMENT = "rows.jsonl", "rows.csv", "tables.md", "results.json"
"""The files that are written, beside the figures."""


def reproduce(
    target: Annotated[Target, typer.Argument(help="What to reproduce.")],
    out: Annotated[Path, typer.Option(metavar="DIR", help="Where the results go.")],
    noise_reading: NoiseReading = None,
    grounding: Annotated[
        Literal["corpus", "oracle", "own"],
        typer.Option(help="Where a command's noun phrases get their objects from."),
    ] = "corpus",
    data: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="A Tell Me Dave folder; else the bundled lessons."),
    ] = None,
    test_data: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="Test on this folder; else whole environments are held out."
        ),
    ] = None,
    runs: Annotated[int, typer.Option(min=1, metavar="N", help="Runs of everything.")] = 20,
    seed: SeedOption = None,
    folds: Annotated[
        Literal["groups", "all"],
        typer.Option(help="Each run holds out a fifth of the environments, or each in turn."),
    ] = "groups",
    beside: Annotated[
        list[str] | None,
        typer.Option(
            "--with",
            metavar="phantom|harder-teacher|paper-prices",
            help="Report beside: the harder reading of the noise; a teacher who errs; the"
            " learned policy at the paper's prices.",
        ),
    ] = None,
    episodes: Annotated[
        int | None,
        typer.Option(min=1, metavar="N", help="Dialogues to practise in, in each phase (600)."),
    ] = None,
    jobs: Annotated[int, typer.Option(min=1, metavar="N", help="Processes.")] = os.cpu_count() or 1,
    cluster: Annotated[
        str | None,
        typer.Option(metavar="ADDRESS", help="Use the Dask cluster of this scheduler instead."),
    ] = None,
    resume: Annotated[
        bool, typer.Option("--resume", help="Go on with the rows that DIR has.")
    ] = False,
    as_json: JsonFlag = False,
) -> None:
    """Run the paper's experiments and write tables beside the paper's, rows and the figure.

    The number of processes changes no figure. A run that was broken off goes
    on with --resume.
    """
    if test_data is not None and data is None:
        raise WrongUseError("--test-data needs --data: what to learn from")
    began = time.monotonic()
    from verbteach_scenarios.laboratories import LaboratorySource, evaluation_data

    source = LaboratorySource(_whole(data), _whole(test_data), grounding)
    rows_file = _rows_file(out, resume)
    with progress() as show:
        show("reading", 0, 1)
        wanted = _Wanted(target, runs, seed or 0, noise_reading, folds, beside or [], episodes)
        tell_left_out(evaluation_data(source))
        design = wanted.design(source)
        show("reading", 1, 1)
        report = _swept(design, source, rows_file, Workers(jobs, cluster), show)
        document = {**report.to_json(), "seconds": time.monotonic() - began}
    document["files"] = [str(path) for path in _write(out, report, document)]
    if as_json:
        emit(document)
    else:
        _print(out, document)


def _whole(path: Path | None) -> Path | None:
    """The folder as other processes find it."""
    return None if path is None else path.resolve()


def _rows_file(out: Path, resume: bool) -> RowsFile:
    from verbteach_scenarios.rows_file import RowsFile

    out.mkdir(parents=True, exist_ok=True)
    rows = RowsFile(out / ROWS)
    if rows.path.exists() and not resume:
        raise WrongUseError(
            f"{rows.path} has rows of an earlier run: go on with --resume, or name another folder"
        )
    return rows


@dataclass(frozen=True)
class _Wanted:
    """What the command line asks for."""

    target: str
    runs: int
    seed: int
    reading: str | None
    folds: str
    extras: list[str]
    episodes: int | None

    def design(self, source: LaboratorySource) -> Design:
        """The design, checked against the data. Raises :class:`WrongUseError`."""
        from verbteach.experiments.reproduction.design import EXTRAS, TARGETS, Design
        from verbteach_scenarios.laboratories import laboratory

        chosen(self.extras, EXTRAS, "--with")
        where = laboratory(source)
        try:
            design = Design(
                where.environments,
                targets=TARGETS if self.target == "all" else (self.target,),
                runs=self.runs,
                seed=self.seed,
                reading=self.reading or "literal",
                folds=self.folds,
                apart=where.apart,
                extras=tuple(dict.fromkeys(self.extras)),
                about=source.about(),
                base=self._base(),
            )
            where.check(design)
        except ValueError as error:
            raise WrongUseError(str(error)) from error
        return design

    def _base(self) -> Config:
        from verbteach.experiments.interactive_protocol import Config
        from verbteach.experiments.policy_training import with_dialogues

        plain = Config()
        if self.episodes is None:
            return plain
        return replace(plain, training=with_dialogues(plain.training, self.episodes))


def _swept(
    design: Design, source: LaboratorySource, file: RowsFile, workers: Workers, show: Progress
) -> Report:
    from verbteach.experiments.reproduction.report import Report
    from verbteach.experiments.reproduction.sweep import sweep
    from verbteach_scenarios.laboratories import Scorer

    tasks = [task for part in design.sections().values() for task in part]
    wanted = {task.key for task in tasks}
    done = {row.key: row for row in file.read() if row.key in wanted}
    finished = len(done)
    show("runs", finished, len(wanted))

    def keep(row: Row) -> None:
        nonlocal finished
        file.append(row)
        finished += 1
        show("runs", finished, len(wanted))

    try:
        rows = sweep(tasks, Scorer(source), done.values(), keep, workers.bundled)
    except KeyboardInterrupt:
        note(f"{finished} of {len(wanted)} rows are kept in {file.path}; go on with --resume")
        raise
    return Report.of(design, rows)


def _write(out: Path, report: Report, document: dict[str, Any]) -> list[Path]:
    from verbteach.experiments.reproduction.markdown import markdown
    from verbteach_scenarios.rows_file import write_csv

    write_csv(out / CSV, report.rows)
    (out / TABLES).write_text(markdown(document), encoding="utf-8")
    text = json.dumps(document, ensure_ascii=False, indent=1, allow_nan=False)
    (out / DOCUMENT).write_text(text + "\n", encoding="utf-8")
    return [out / ROWS, out / CSV, out / TABLES, out / DOCUMENT, *_figures(out, document)]


def _figures(out: Path, document: dict[str, Any]) -> list[Path]:
    from verbteach_tui.plots.files import draw
    from verbteach_tui.plots.paper import charts

    return [path for name, chart in charts(document).items() for path in draw(chart, out / name)]


def _print(out: Path, document: dict[str, Any]) -> None:
    from rich.console import Console

    from verbteach_tui.plots.paper import charts
    from verbteach_tui.plots.terminal import draw

    tell((out / TABLES).read_text(encoding="utf-8"))
    console = Console(highlight=False)
    for chart in charts(document).values():
        console.print(draw(chart, min(console.width, 110)), soft_wrap=True)
        tell()
    tell("written: " + ", ".join(document["files"]))
