"""`verbteach train`: the two question policies learned in simulation, as a file of weights."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple

import typer

from verbteach_tui.commands.parameters import (
    JsonFlag,
    NoiseReading,
    SeedOption,
    to_be_written,
)
from verbteach_tui.commands.streams import Progress, columns, emit, note, progress, tell
from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.eyes import NOISE, check_kinds, noise_names, noise_text

if TYPE_CHECKING:
    from verbteach.dialogue.lesson import Lesson
    from verbteach.dialogue.setting import Settings
    from verbteach.experiments.interactive_bench import Bench
    from verbteach.experiments.live_practice import Classroom
    from verbteach.experiments.policy_training import Schooling
    from verbteach.experiments.promise_calibration import CalibrationPlan
    from verbteach.experiments.pupil import LivePractice
    from verbteach.experiments.simulated_human import HumanParameters
    from verbteach.policy.weights_file import PolicyWeights
    from verbteach.world.domain import Domain
    from verbteach_sessions.people.fitting import Material
    from verbteach_sessions.people.golds import LessonBook

LearnerName = Literal["lspi", "bayesian", "true-online", "sarsa"]
"""The learners there are to choose from, as `LEARNERS` has them, and the one that refits."""

RATES = (0.6, 0.7, 0.8, 0.9)
"""Success rates that are looked at when calibrations are told."""


def train(
    out: Annotated[Path, typer.Option(metavar="FILE", help="Where the weights go.")],
    more: Annotated[
        list[Path] | None,
        typer.Argument(metavar="SESSION", help="More sessions after that of --from."),
    ] = None,
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
            metavar=NOISE,
            parser=noise_text,
            autocompletion=noise_names,
            help="How unreliable the eyes are, as for teach; may be repeated (perfect and std3).",
        ),
    ] = None,
    noise_reading: NoiseReading = None,
    learner: Annotated[
        LearnerName | None,
        typer.Option(help="The learner (lspi)."),
    ] = None,
    episodes: Annotated[
        int | None,
        typer.Option(
            min=1, metavar="N", help="Dialogues to hold in each phase (340; with --data 600)."
        ),
    ] = None,
    calibrate: Annotated[
        int | None,
        typer.Option(
            min=0,
            metavar="N",
            help="Lessons to calibrate promises on, in rooms set apart (all there, which takes"
            " minutes; 0: none).",
        ),
    ] = None,
    weights: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Keep these weights, and only calibrate them anew."),
    ] = None,
    seed: SeedOption = None,
    as_json: JsonFlag = False,
) -> None:
    """Learn when to ask what, in dialogues with simulated teachers, and write the weights.

    `verbteach teach` begins with such a file; the one that comes with the
    program was trained by this command on the bundled lessons. A third of the
    rooms is set apart to calibrate what `verbteach teach --promise` promises.
    """
    if data is not None and (calibrate or weights is not None):
        raise WrongUseError("--calibrate and --weights go with the bundled lessons, not --data")
    if more and not sessions:
        raise WrongUseError(f"{more[0]}: sessions to practise on are named after --from")
    from verbteach.perception.noise import NoiseModel

    schooling = _schooling(noise, noise_reading, learner, episodes, seed or 0)
    to_be_written(out)
    kept = None if weights is None else _loaded(weights)
    with progress() as show:
        matter = _matter(data, [*(sessions or []), *(more or [])], schooling.seed, show)
        for name in schooling.noises:
            check_kinds(NoiseModel.named(name), matter.domains())
        if matter.bench is not None:
            made = _trained(matter.bench, matter.source, schooling, show)
        else:
            practice = _practice(learner, episodes)
            plan = _plan(schooling, calibrate)
            made = _taught_live(matter, schooling, practice, plan, kept, show)
    from verbteach_scenarios.weights import save_weights

    if matter.people is not None:
        matter.people.note("weights", out)
    save_weights(out, made)
    document = _document(made, out)
    if as_json:
        emit(document)
    else:
        _print(document, made)


def _loaded(path: Path) -> PolicyWeights:
    from verbteach_scenarios.weights import load_weights

    return load_weights(path)


def _schooling(
    noise: list[str] | None,
    reading: str | None,
    learner: str | None,
    episodes: int | None,
    seed: int,
) -> Schooling:
    from verbteach.experiments.policy_training import Schooling, with_dialogues

    plain = Schooling(reading=reading or "literal", seed=seed)
    training = plain.training
    if learner is not None:
        training = replace(training, learner=learner)
    if episodes is not None:
        training = with_dialogues(training, episodes)
    noises = tuple(dict.fromkeys(noise)) if noise else plain.noises
    return replace(plain, noises=noises, training=training)


def _practice(learner: str | None, episodes: int | None) -> LivePractice:
    """The practice on lessons, with as large a share of its dialogues warm."""
    from verbteach.experiments.pupil import LivePractice

    usual = LivePractice()
    count = usual.dialogues if episodes is None else episodes
    warm = round(usual.warm * count / usual.dialogues)
    return replace(usual, learner=learner or usual.learner, dialogues=count, warm=warm)


def _plan(schooling: Schooling, lessons: int | None) -> CalibrationPlan:
    from verbteach.experiments.promise_calibration import CalibrationPlan

    plan = CalibrationPlan(noises=schooling.noises, reading=schooling.reading, seed=schooling.seed)
    return plan if lessons is None else replace(plan, lessons=lessons)


class _Matter(NamedTuple):
    """What to practise on (a corpus's bench, else lessons), what to call it, and who answers.

    ``people`` are the sessions that lessons and answers are from.
    """

    source: str
    bench: Bench | None = None
    room: Classroom | None = None
    people: Material | None = None

    def domains(self) -> Iterator[Domain]:
        """What there may be to see, of each room as it is asked for."""
        if self.bench is not None:
            yield from (room.task.domain for room in self.bench.rooms.values())
        if self.room is not None:
            scenes = sorted({lesson.scene for lesson in self.room.lessons})
            yield from (self.room.settings(scene).task.domain for scene in scenes)


def _matter(data: Path | None, sessions: list[Path], seed: int, show: Progress) -> _Matter:
    from verbteach.experiments.live_practice import Classroom
    from verbteach.experiments.simulated_human import HumanParameters
    from verbteach.world import compiled
    from verbteach_scenarios.benches import bench_of
    from verbteach_scenarios.grounds import of_corpus
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_scenarios.settings import make_settings
    from verbteach_sessions.people.golds import LessonBook

    if data is not None:
        if sessions:
            raise WrongUseError("--from goes with the bundled lessons, not with --data")
        found = of_corpus(data, None, lambda done, total: show("reading", done, total))
        return _Matter("a Tell Me Dave folder", bench_of(found))
    settings = make_settings()
    lessons = {lesson.id: lesson for lesson in load_lessons()}
    source, people, teachers = "bundled lessons", None, HumanParameters()
    if sessions:
        book = LessonBook.of(lessons.values())
        people = _gathered(sessions, book, settings, show)
        taught, teachers = _taught(people, book, settings), _answering(people, seed)
        lessons |= {lesson.id: lesson for lesson in taught}
        source += f", and {len(taught)} lessons that sessions taught, answered as in them"
    compiled.warm_up()
    return _Matter(source, None, Classroom(tuple(lessons.values()), settings, teachers), people)


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


def _trained(bench: Bench, source: str, schooling: Schooling, show: Progress) -> PolicyWeights:
    from verbteach.experiments.policy_training import train_policies

    try:
        return train_policies(
            bench, schooling, source, lambda stage, done, total, _: show(stage, done, total)
        )
    except ValueError as error:
        raise WrongUseError(str(error)) from error


def _taught_live(
    matter: _Matter,
    schooling: Schooling,
    practice: LivePractice,
    plan: CalibrationPlan,
    already: PolicyWeights | None,
    show: Progress,
) -> PolicyWeights:
    """Practise in some rooms, and calibrate in those that are set apart.

    With weights ``already`` there, practice only says how sure they may be.
    """
    from verbteach.experiments.policy_training import train_live
    from verbteach.experiments.promise_calibration import calibrated

    room = matter.room
    if room is None:
        raise RuntimeError("there are no lessons to practise on")
    apart = plan.set_apart(room.lessons)
    kept = [lesson for lesson in room.lessons if lesson.scene in apart]
    rest = [lesson for lesson in room.lessons if lesson.scene not in apart]
    try:
        weights, sureness = train_live(
            replace(room, lessons=rest),
            schooling,
            practice,
            matter.source,
            lambda stage, done, total, _: show(stage, done, total),
        )
    except ValueError as error:
        raise WrongUseError(str(error)) from error
    weights = already or weights
    if not kept:
        return weights
    found = calibrated(
        weights,
        sureness,
        replace(room, lessons=kept),
        plan,
        lambda done, total: show("calibration", done, total),
    )
    return replace(weights, calibrations=found)


def _document(weights: PolicyWeights, out: Path) -> dict[str, Any]:
    from verbteach.experiments.policy_training import totals

    return {
        **totals(weights),
        "weights": str(out),
        "learner": weights.learner,
        "training": dict(weights.training),
        "promises": promises_of(weights),
    }


def promises_of(weights: PolicyWeights) -> list[dict[str, Any]]:
    """How sure the robot has to be for each rate, by calibration; null where it cannot keep it."""
    from verbteach.policy.stopping import UnkeepablePromiseError, cut_for

    found = []
    for one in weights.calibrations.each if weights.calibrations else ():
        rates: list[dict[str, float | None]] = []
        for rate in RATES:
            try:
                rates.append({"rate": rate, "sure": cut_for(one.courses, rate).sure})
            except UnkeepablePromiseError:
                rates.append({"rate": rate, "sure": None})
        named = {"policy": one.policy, "noise": one.noise, "reading": one.reading}
        found.append({**named, "lessons": len(one.courses), "rates": rates})
    return found


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
    if document["promises"]:
        tell()
        tell("acts for a promise when so sure (-: cannot be promised)")
        tell(columns(_promise_rows(document["promises"])))
    tell(f"written: {document['weights']}")


def _promise_rows(promises: list[dict[str, Any]]) -> list[tuple[object, ...]]:
    rows: list[tuple[object, ...]] = [("policy", "noise", "lessons", *map("{:.0%}".format, RATES))]
    for one in promises:
        each = [row["sure"] for row in one["rates"]]
        sure = ["-" if value is None else f"{value:.2f}" for value in each]
        rows.append((one["policy"], one["noise"], one["lessons"], *sure))
    return rows
