"""`verbteach sessions fit|evaluate-policy|example`: teachers from records, and records to try."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from verbteach_tui.commands.parameters import (
    JsonFlag,
    ScenesFolder,
    SeedOption,
    WeightsOption,
    to_be_written,
)
from verbteach_tui.commands.session_names import session_completions, session_path
from verbteach_tui.commands.sessions_corpus import found_at
from verbteach_tui.commands.streams import columns, emit, note, progress, tell
from verbteach_tui.conclusion import CHECK_FAILED, WrongUseError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from verbteach.dialogue.setting import Settings
    from verbteach_sessions.people.fitting import Material
    from verbteach_sessions.people.golds import LessonBook
    from verbteach_sessions.people.recorded import Recorded

Paths = Annotated[
    list[Path],
    typer.Argument(
        metavar="PATH",
        parser=session_path,
        autocompletion=session_completions,
        help="Sessions, or folders of them.",
    ),
]
LessonsFolder = Annotated[
    Path | None,
    typer.Option("--lessons", metavar="DIR", help="The lessons that were taught (the bundled)."),
]
_SHOWN = ("unsure", "error", "words")


def fit(
    paths: Paths,
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="Where the user is kept.")],
    check: Annotated[
        bool,
        typer.Option(
            "--check", help="Hold half of the sessions again with a user fitted to the others."
        ),
    ] = False,
    lessons: LessonsFolder = None,
    scenes: ScenesFolder = None,
    seed: SeedOption = None,
    as_json: JsonFlag = False,
) -> None:
    """Fit a simulated user to sessions: how people answer, err, do not know and give up.

    Reports how well it foretells people that it was not fitted to. With --check
    status 1 where a policy meets people and their simulator differently.
    """
    import numpy as np

    from verbteach_sessions.people.agreement import agreement
    from verbteach_sessions.people.fitted_user import FittedUserError
    from verbteach_sessions.people.fitting import save_user
    from verbteach_sessions.people.rehearsal import FEWEST

    to_be_written(out)
    book, settings = _book(lessons), _settings(scenes)
    material = _gathered(found_at(paths), book, settings)
    user = material.user()
    if check and len(user.counts) < FEWEST:
        raise WrongUseError(f"--check: {FEWEST} people at least, here are {len(user.counts)}")
    material.note("fitted user", out)
    save_user(out, user)
    rng = np.random.default_rng(seed or 0)
    document: dict[str, Any] = {
        "out": str(out),
        "sessions": len(material.records),
        "people": len(user.counts),
        "answers": len(material.observed),
        "rates": {
            name: {"answers": user.asked(name), **{rate: beta.mean for rate, beta in one.items()}}
            for name, one in user.population.spread.items()
        },
        "gold_known": {name: list(pair) for name, pair in (user.gold_known or {}).items()},
    }
    try:
        document["held_out"] = agreement(material.observed, rng).to_json()
    except FittedUserError as error:
        note(f"no held-out agreement: {error}")
        document["held_out"] = None
    document["meeting"] = _met(material, book, settings, seed or 0) if check else None
    emit(document) if as_json else _print_fit(document)
    if document["meeting"] is not None and not document["meeting"]["alike"]:
        raise typer.Exit(CHECK_FAILED)


def _book(lessons: Path | None) -> LessonBook:
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_sessions.people.golds import LessonBook

    return LessonBook.of(load_lessons(lessons))


def _settings(scenes: Path | None) -> Settings:
    from verbteach_scenarios.settings import make_settings

    return make_settings(scenes)


def _gathered(paths: Sequence[Path], book: LessonBook, settings: Settings) -> Material:
    from verbteach_sessions.people.fitting import gather

    with progress() as show:
        return gather(paths, book, settings, lambda done, of: show("sessions", done, of))


def _met(material: Material, book: LessonBook, settings: Settings, seed: int) -> dict[str, Any]:
    import numpy as np

    from verbteach_sessions.people.rehearsal import meet

    with progress() as show:
        return meet(
            material.records,
            book,
            settings,
            np.random.default_rng([seed, 1]),
            lambda done, of: show("held again", done, of),
        ).to_json()


def _print_fit(document: Mapping[str, Any]) -> None:
    tell(
        f"{document['out']}: {document['people']} people, {document['answers']} answers in"
        f" {document['sessions']} sessions"
    )
    head = ("QUESTION", "ANSWERS", "GIVES UP EARLY", "LATE", "UNSURE", "WRONG", "IN WORDS")
    rows = [
        (name, one["answers"], one["gives_up.first"], one["gives_up.late"], *_rest(one))
        for name, one in document["rates"].items()
    ]
    tell(columns([head, *rows]))
    held = document["held_out"]
    if held is not None:
        tell()
        figures = ("agreement", "agreement_never_errs", "agreement_majority", "brier")
        tell(columns([(name.replace("_", " "), _share(held[name])) for name in figures]))
    if document["meeting"] is not None:
        tell()
        _print_meeting(document["meeting"])


def _rest(rates: Mapping[str, float]) -> tuple[float, ...]:
    return tuple(rates[name] for name in _SHOWN)


def _share(one: Mapping[str, Any]) -> str:
    return f"{one['mean']:.3f} [{one['ci95'][0]:.3f}, {one['ci95'][1]:.3f}]"


def _print_meeting(meeting: Mapping[str, Any]) -> None:
    names = ("questions", "turns", "return", "success")
    rows = [
        (name, meeting[name]["people"], meeting[name]["simulator"], meeting[name]["p"])
        for name in names
    ]
    tell(columns([("PER COMMAND", "PEOPLE", "SIMULATOR", "P"), *rows]))
    tell(f"question types: p {meeting['question_types_p']:.3f}")
    tell("met alike" if meeting["alike"] else "NOT met alike: see the lines with a p under .05")


def evaluate_policy(
    paths: Paths,
    policy: Annotated[
        str,
        typer.Option("--policy", metavar="NAME", help="rl, manual, random, split or silent."),
    ],
    weights: WeightsOption = None,
    explore: Annotated[
        float,
        typer.Option(min=0.0, max=1.0, metavar="P", help="How often it takes any act (0)."),
    ] = 0.0,
    minimum: Annotated[
        float | None,
        typer.Option(min=1.0, metavar="N", help="The least effective sample size (30)."),
    ] = None,
    seed: SeedOption = None,
    as_json: JsonFlag = False,
) -> None:
    """Estimate how another question policy would have done in recorded sessions.

    Declines where the records cannot tell; status 1 where it does so in both phases.
    """
    import numpy as np

    from verbteach.experiments.off_policy.evaluation import MINIMUM
    from verbteach_scenarios.weights import load_weights, starting_weights
    from verbteach_sessions.people.evaluating import evaluate_policy as evaluate
    from verbteach_sessions.people.targets import target

    chances = target(policy, load_weights(weights) if weights else starting_weights(), explore)
    records = _records(found_at(paths))
    reports = evaluate(
        records,
        chances,
        np.random.default_rng(seed or 0),
        minimum=MINIMUM if minimum is None else minimum,
    )
    document: dict[str, Any] = {
        "policy": policy,
        "explore": explore,
        "sessions": len(records),
        "phases": {name: report.to_json() for name, report in reports.items()},
    }
    emit(document) if as_json else _print_evaluation(document)
    if not any(report.tells for report in reports.values()):
        raise typer.Exit(CHECK_FAILED)


def _records(paths: Sequence[Path]) -> list[Recorded]:
    from verbteach_sessions.people.recorded import read_recorded

    found = []
    with progress() as show:
        for done, path in enumerate(paths, start=1):
            found.append(read_recorded(path))
            show("sessions", done, len(paths))
    return found


def _print_evaluation(document: Mapping[str, Any]) -> None:
    for name, one in document["phases"].items():
        tell(f"{name}: {_told(one)}")
        for estimator, figure in (one.get("estimates") or {}).items():
            low, high = figure["ci95"]
            words = estimator.replace("_", " ")
            tell(f"  {words}: {figure['value']:.1f} [{low:.1f}, {high:.1f}]")
        for policy, reason in one["left_out"].items():
            tell(f"  sessions under {policy} are left out: {reason}")


def _told(one: Mapping[str, Any]) -> str:
    if one["refused"]:
        return "cannot be told"
    size = f"{one['trajectories']} dialogues of {one['people']} people"
    worth = f"worth {one['effective_sample_size']:.1f}; logged return {one['logged_return']:.1f}"
    return one["declined"] or f"{size}, {worth}"


def example(
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="The folder for the sessions.")],
    sessions: Annotated[
        int, typer.Option("--sessions", min=1, metavar="N", help="How many sessions.")
    ] = 48,
    lessons: Annotated[
        int, typer.Option("--lessons", min=1, metavar="N", help="How many lessons in each.")
    ] = 6,
    jobs: Annotated[
        int | None,
        typer.Option(min=1, metavar="N", help="Processes (as many as there are processors)."),
    ] = None,
    seed: SeedOption = None,
    as_json: JsonFlag = False,
) -> None:
    """Make the example corpus: sessions of made-up people, marked as simulated.

    Sessions that are there already are kept, so that a run that was broken off
    is completed.
    """
    import os

    from verbteach_sessions.example import ExampleParameters, make_example

    parameters = ExampleParameters(sessions, lessons, seed or 0)
    with progress() as show:
        made = make_example(
            out,
            parameters,
            jobs or os.cpu_count() or 1,
            lambda done, of: show("sessions", done, of),
        )
    if as_json:
        emit({"out": str(out), "sessions": [str(path) for path in made], "simulated": True})
    else:
        tell(f"{out}: {len(made)} simulated sessions")
