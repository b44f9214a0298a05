"""`verbteach train`: the two question policies learned in simulation, as a file of weights."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple

import typer

from verbteach_tui.commands.parameters import (
    NOISES,
    JsonFlag,
    NoiseReading,
    SeedOption,
    chosen,
)
from verbteach_tui.commands.streams import Progress, columns, emit, note, progress, tell
from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.workers import one_thread

if TYPE_CHECKING:
    from verbteach.dialogue.lesson import Lesson
    from verbteach.dialogue.setting import Settings
    from verbteach.experiments.interactive_bench import Bench
    from verbteach.experiments.policy_training import Schooling
    from verbteach.experiments.simulated_human import HumanParameters
    from verbteach.policy.weights_file import PolicyWeights
    from verbteach_sessions.people.fitting import Material
    from verbteach_sessions.people.golds import LessonBook


def train(
    out: Annotated[Path, typer.Option(metavar="FILE", help="Where the weights go.")],
    data: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="A Tell Me Dave folder; else the bundled lessons."),
    ] = None,
    sessions: Annotated[
        list[Path] | None,
        typer.Option(
            "--from",
            metavar="SESSION",
            help="Also on what this session taught, answered as in it; a folder of sessions, or"
            " several times.",
        ),
    ] = None,
    noise: Annotated[
        list[str] | None,
        typer.Option(
            metavar="perfect|std3|std5|uniform",
            help="How unreliable the eyes are; may be repeated (perfect and std3).",
        ),
    ] = None,
    noise_reading: NoiseReading = None,
    learner: Annotated[
        Literal["lspi", "bayesian", "true-online", "sarsa"] | None,
        typer.Option(help="The learner (lspi)."),
    ] = None,
    episodes: Annotated[
        int | None, typer.Option(min=1, metavar="N", help="Dialogues to hold in each phase.")
    ] = None,
    seed: SeedOption = None,
    as_json: JsonFlag = False,
) -> None:
    """Learn when to ask what, in dialogues with simulated teachers, and write the weights.

    `verbteach teach` begins with such a file; the one that comes with the
    program was trained by this command on the bundled lessons.
    """
    one_thread()
    schooling = _schooling(noise, noise_reading, learner, episodes, seed or 0)
    if not out.resolve().parent.is_dir():
        raise WrongUseError(f"{out.resolve().parent}: there is no such folder")
    with progress() as show:
        matter = _matter(data, sessions or [], schooling.seed, show)
        weights = _trained(matter, replace(schooling, human=matter.teachers), show)
    from verbteach_scenarios.weights import save_weights

    if matter.people is not None:
        matter.people.note("weights", out)
    save_weights(out, weights)
    document = _document(weights, out)
    if as_json:
        emit(document)
    else:
        _print(document, weights)


def _schooling(
    noise: list[str] | None,
    reading: str | None,
    learner: str | None,
    episodes: int | None,
    seed: int,
) -> Schooling:
    from verbteach.experiments.policy_training import Schooling, with_dialogues

    chosen(noise or [], NOISES, "--noise")
    plain = Schooling(reading=reading or "literal", seed=seed)
    training = plain.training
    if learner is not None:
        training = replace(training, learner=learner)
    if episodes is not None:
        training = with_dialogues(training, episodes)
    noises = tuple(dict.fromkeys(noise)) if noise else plain.noises
    return replace(plain, noises=noises, training=training)


class _Matter(NamedTuple):
    """What to practise on, what to call it, who answers, and the sessions that they are from."""

    bench: Bench
    source: str
    teachers: HumanParameters
    people: Material | None = None


def _matter(data: Path | None, sessions: list[Path], seed: int, show: Progress) -> _Matter:
    from verbteach.experiments.simulated_human import HumanParameters
    from verbteach_scenarios.benches import bench_of
    from verbteach_scenarios.grounds import of_corpus, of_lessons
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_scenarios.settings import make_settings
    from verbteach_sessions.people.golds import LessonBook

    if data is not None:
        if sessions:
            raise WrongUseError("--from goes with the bundled lessons, not with --data")
        found = of_corpus(data, None, lambda done, total: show("reading", done, total))
        return _Matter(bench_of(found), "a Tell Me Dave folder", HumanParameters())
    settings = make_settings()
    lessons = {lesson.id: lesson for lesson in load_lessons()}
    source, people, teachers = "bundled lessons", None, HumanParameters()
    if sessions:
        book = LessonBook.of(lessons.values())
        people = _gathered(sessions, book, settings, show)
        taught, teachers = _taught(people, book, settings), _answering(people, seed)
        lessons |= {lesson.id: lesson for lesson in taught}
        source += f", and {len(taught)} lessons that sessions taught, answered as in them"
    bench = bench_of(of_lessons(list(lessons.values()), settings))
    return _Matter(bench, source, teachers, people)


def _gathered(
    sessions: list[Path], book: LessonBook, settings: Settings, show: Progress
) -> Material:
    from verbteach_sessions.corpus.folder import sessions_at
    from verbteach_sessions.people.fitting import gather

    paths = sessions_at(sessions)
    return gather(paths, book, settings, lambda done, of: show("sessions", done, of))


def _taught(material: Material, book: LessonBook, settings: Settings) -> list[Lesson]:
    """What sessions taught, as lessons; commands without a confirmed goal teach nothing."""
    from verbteach_sessions.people.recorded_lessons import taught

    found = []
    for record in material.records:
        lessons = [one.lesson for one in taught(record, book, settings)]
        usable = [lesson for lesson in lessons if lesson.verb and lesson.grounding]
        if not usable:
            note(f"{record.header.id}: no command in it was taught from the scene as it is found")
        found += usable
    return found


def _answering(material: Material, seed: int) -> HumanParameters:
    """People who answer as those in the sessions did."""
    import numpy as np

    from verbteach_sessions.people.training import training_people

    return training_people(material.user().population, np.random.default_rng([seed, 2]))


def _trained(matter: _Matter, schooling: Schooling, show: Progress) -> PolicyWeights:
    from verbteach.experiments.policy_training import train_policies

    try:
        return train_policies(
            matter.bench,
            schooling,
            matter.source,
            lambda stage, done, total, _: show(stage, done, total),
        )
    except ValueError as error:
        raise WrongUseError(str(error)) from error


def _document(weights: PolicyWeights, out: Path) -> dict[str, Any]:
    from verbteach.experiments.policy_training import totals

    return {
        **totals(weights),
        "weights": str(out),
        "learner": weights.learner,
        "training": dict(weights.training),
    }


def _print(document: dict[str, Any], weights: PolicyWeights) -> None:
    heads = ("phase", "episodes", "mean return", "questions", "return at the end", "questions")
    rows: list[tuple[object, ...]] = [heads]
    for name, phase in weights.training["phases"].items():
        means = [
            figure
            for part in (phase, phase["last"])
            for figure in (part["mean_return"], part["questions"] / part["episodes"])
        ]
        rows.append((name, phase["episodes"], *means))
    tell(columns(rows))
    tell(f"written: {document['weights']}")
