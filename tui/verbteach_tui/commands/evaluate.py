"""`verbteach evaluate`: verb models scored on commands from environments they have not seen."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar

import typer

from verbteach_tui.commands.corpora import tell_left_out
from verbteach_tui.commands.evaluate_grid import Part
from verbteach_tui.commands.evaluate_mistakes import mistakes_document, print_mistakes
from verbteach_tui.commands.evaluate_policy import (
    LEARNED,
    RULES,
    Held,
    Question,
    Spread,
    policy_document,
    taught_document,
)
from verbteach_tui.commands.parameters import (
    JsonFlag,
    NoiseOption,
    NoiseReading,
    SeedOption,
    WeightsOption,
)
from verbteach_tui.commands.session_names import session_completions, session_named
from verbteach_tui.commands.streams import Progress, columns, emit, progress, tell
from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.eyes import check_kinds

if TYPE_CHECKING:
    from verbteach.experiments.jobs import Setup
    from verbteach_scenarios.grounds import CorpusFolder, EvaluationData

J = TypeVar("J")
R = TypeVar("R")


def evaluate(
    policy: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="she16 (default), she16-all as in the paper, or one that asks:"
            " rl, manual, random, split or silent.",
        ),
    ] = None,
    weights: WeightsOption = None,
    source: Annotated[
        Path | None,
        typer.Option(
            "--from",
            metavar="SESSION",
            parser=session_named,
            autocompletion=session_completions,
            help="Score the robot that was taught in this session.",
        ),
    ] = None,
    criterion: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="How it chooses among goals (she16's): most_specific, most_general,"
            " most_frequent, regression or oracle.",
        ),
    ] = None,
    objects: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="What its hypotheses speak of: argument-only, manipulated, argument-related or"
            " all. Unless said, both are as was best on development data.",
        ),
    ] = None,
    noise: NoiseOption = None,
    noise_reading: NoiseReading = None,
    grounding: Annotated[
        Literal["corpus", "oracle", "own"] | None,
        typer.Option(
            help="Where a command's noun phrases get their objects from: corpus unless said.",
            show_default=False,
        ),
    ] = None,
    data: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="A Tell Me Dave folder; else the bundled lessons."),
    ] = None,
    test_data: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Test on this folder; else each environment in turn."),
    ] = None,
    runs: Annotated[int, typer.Option(min=1, metavar="N", help="Draws of the noise.")] = 1,
    seed: SeedOption = None,
    jobs: Annotated[int, typer.Option(min=1, metavar="N", help="Processes.")] = os.cpu_count() or 1,
    ceilings: Annotated[
        bool, typer.Option("--ceilings/--no-ceilings", help="The upper bounds beside the scores.")
    ] = True,
    grid: Annotated[
        bool,
        typer.Option(
            "--grid",
            help="Every learner from demonstrations, criterion and condition, into --out;"
            " --noise, --noise-reading and --grounding choose a part."
            " Nothing is computed twice by the same program on the same data.",
        ),
    ] = False,
    tables_only: Annotated[
        bool,
        typer.Option(
            "--tables-only",
            help="Of the grid only the tables, of whatever is there and wherever it comes from.",
        ),
    ] = False,
    mistakes: Annotated[
        bool,
        typer.Option(
            "--mistakes", help="Why a policy that asks loses what it loses, with examples."
        ),
    ] = False,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Where the grid goes, or the mistakes.",
        ),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Score a verb model on commands from environments that it has not seen.

    A policy that asks learns to ask first, unless --weights has what it learned.
    The number of processes changes no figure.
    """
    from verbteach.experiments import evaluation
    from verbteach_scenarios.grounds import CorpusFolder

    if test_data is not None and data is None and source is None:
        raise WrongUseError("--test-data needs --data: what to learn from")
    if grid or tables_only or (out is not None and not mistakes):
        if not grid or data is None or out is None:
            raise WrongUseError(_GRID_NEEDS)
        part = Part(noise, noise_reading, grounding, seed or 0)
        _grid(CorpusFolder(data, test_data), out, part, tables_only, jobs, as_json)
        return
    grounding = grounding or "corpus"
    asked = Question(
        policy, noise or "perfect", noise_reading or "literal", grounding, runs, seed or 0, weights
    )
    if mistakes:
        _refuse_mistakes(asked, source)
    if source is not None or asked.about_asking:
        _refuse_she16({"--criterion": criterion, "--objects": objects})
        asked.check()
    with progress() as show:
        if source is not None:
            found = _to_test(test_data or data, show, asked.noise)
            document = taught_document(source, asked, found, show)
        elif mistakes:
            found = _data(data, test_data, show, asked.noise)
            document = mistakes_document(asked, found, show, out, ceilings)
        elif asked.about_asking:
            spread = _runs_spread(asked, data, test_data, jobs, show)
            found = _data(data, test_data, show, asked.noise)
            document = policy_document(asked, found, show, spread=spread)
        else:
            setup = _setup(policy or "she16", criterion, objects, noise, noise_reading, seed or 0)
            found = _data(data, test_data, show, asked.noise)
            setup = _grounded(setup, grounding, found)
            document = evaluation.evaluate(
                found.grounds, setup, runs, _Spread(jobs, show), ceilings=ceilings
            )
    document = {
        **document,
        "noise": noise or "perfect",
        "noise_reading": noise_reading or "literal",
    }
    if as_json:
        emit(document)
    else:
        _print(document)


_GRID_NEEDS = (
    "--grid needs --data and --out; --out needs --grid or --mistakes, --tables-only --grid"
)


def _grid(
    data: CorpusFolder, out: Path, part: Part, tables_only: bool, jobs: int, as_json: bool
) -> None:
    from verbteach_tui.commands.evaluate_grid import grid

    with progress() as show:
        written = grid(data, out, part, _Spread(jobs, show), tables_only=tables_only)
    if as_json:
        emit(written)
    else:
        tell(columns([(name, str(value)) for name, value in written.items()]))


def _refuse_mistakes(asked: Question, source: Path | None) -> None:
    if source is not None or not asked.about_asking:
        raise WrongUseError(f"--mistakes needs a policy that asks: {LEARNED}, {', '.join(RULES)}")


def _refuse_she16(given: dict[str, object]) -> None:
    for option, value in given.items():
        if value is not None:
            raise WrongUseError(f"{option} is for --policy she16")


def _setup(
    policy: str,
    criterion: str | None,
    objects: str | None,
    noise: str | None,
    reading: str | None,
    seed: int,
) -> Setup:
    from verbteach.experiments.jobs import Setup
    from verbteach.experiments.she16 import VARIANTS, variant
    from verbteach.perception.noise import NoiseModel

    if policy not in VARIANTS:
        has = ", ".join((*VARIANTS, LEARNED, *RULES))
        raise WrongUseError(f"this version has no policy {policy!r} to evaluate; it has: {has}")
    try:
        chosen = variant(
            policy,
            criterion and criterion.replace("-", "_"),
            objects and objects.replace("_", "-"),
        )
    except ValueError as error:
        raise WrongUseError(str(error)) from error
    return Setup(chosen, NoiseModel.named(noise or "perfect", reading or "literal"), seed=seed)


def _data(data: Path | None, test: Path | None, show: Progress, noise: str) -> EvaluationData:
    """What is learned from and tested on. Raises ``WrongUseError`` for noise of nothing in it."""
    from verbteach_scenarios.grounds import of_corpus, of_lessons
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_scenarios.settings import make_settings

    if data is None:
        found = of_lessons(load_lessons(), make_settings())
    else:
        found = of_corpus(data, test, lambda done, total: show("reading", done, total))
        tell_left_out(found)
    _check_eyes(noise, found)
    return found


def _check_eyes(noise: str, found: EvaluationData) -> None:
    from verbteach.perception.noise import NoiseModel

    domains = (task.domain for task in found.grounds.tasks.values())
    check_kinds(NoiseModel.named(noise), domains)


def _to_test(data: Path | None, show: Progress, noise: str) -> EvaluationData:
    """What a robot that was taught is scored on: nothing is learned from it."""
    from verbteach_scenarios.grounds import to_test

    if data is None:
        return _data(None, None, show, noise)
    found = to_test(data, lambda done, total: show("reading", done, total))
    _check_eyes(noise, found)
    return found


def _runs_spread(
    asked: Question, data: Path | None, test: Path | None, jobs: int, show: Progress
) -> Spread | None:
    """Runs in several processes; none where one is enough."""
    if jobs == 1 or asked.runs == 1:
        return None
    from verbteach_scenarios.laboratories import LaboratorySource

    held = Held(asked, LaboratorySource(data, test, asked.grounding))
    return lambda numbers: list(_Spread(jobs, show)(held, numbers))


def _grounded(setup: Setup, grounding: str, data: EvaluationData) -> Setup:
    own = data.own if grounding == "own" else None
    return replace(setup, grounding=grounding, grounder=own)


class _Spread:
    """A mapper over processes that says how far each round of jobs is."""

    def __init__(self, processes: int, show: Progress) -> None:
        self._processes, self._show = processes, show
        self._rounds = 0

    def __call__(self, function: Callable[[J], R], jobs: Iterable[J], /) -> Iterator[R]:
        waiting = list(jobs)
        self._rounds += 1
        stage = f"round {self._rounds}"
        for done, result in enumerate(self._results(function, waiting), start=1):
            self._show(stage, done, len(waiting))
            yield result

    def _results(self, function: Callable[[J], R], jobs: list[J]) -> Iterable[R]:
        if self._processes == 1:
            return map(function, jobs)
        from joblib import Parallel, delayed

        results: Iterable[R] = Parallel(n_jobs=self._processes, return_as="generator")(
            delayed(function)(job) for job in jobs
        )
        return results


def _print(document: dict[str, Any]) -> None:
    names = ("from", "policy", "criterion", "objects", "grounding", "noise", "noise_reading")
    settled = [(name, str(document[name])) for name in names if name in document]
    tell(columns([*settled, ("instances", str(document["instances"]))]))
    tell()
    rows = [("", "IED", "SJI"), ("score", _figure(document["ied"]), _figure(document["sji"]))]
    for name, both in document.get("ceilings", {}).items():
        rows.append((name.replace("_", " "), _figure(both["ied"]), _figure(both["sji"])))
    tell(columns(rows))
    if "by_type" in document:
        tell()
        phases = [(name, _figure(document[name])) for name in _ASKED]
        kinds = [(name, f"{mean:.2f}") for name, mean in document["by_type"].items()]
        tell(columns([(name.replace("_", " "), figure) for name, figure in phases + kinds]))
    if "mistakes" in document:
        print_mistakes(document)


_ASKED = ("questions_learning", "questions_execution")


def _figure(figure: dict[str, Any]) -> str:
    low, high = figure["ci95"]
    return f"{figure['mean']:.3f} [{low:.3f}, {high:.3f}]"
