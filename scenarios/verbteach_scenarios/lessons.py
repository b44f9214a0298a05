"""Lessons by folder, the bundled ones by default, and the proof that they can be taught."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Setting, Settings, UnknownSceneError
from verbteach.language.grammar import parse
from verbteach.language.looks import Looks
from verbteach.language.refer import refer
from verbteach.world.fluents import satisfied
from verbteach.world.simulator import InapplicableError, Unmet, apply
from verbteach_scenarios.errors import WorldFileError
from verbteach_scenarios.folders import BUNDLED
from verbteach_scenarios.lengths import Lengths
from verbteach_scenarios.lesson_file import LessonFileError, read_lessons
from verbteach_scenarios.settings import make_settings

CONTENTS = "with"
"""The role in which a word for a thing and for what is in it means what is in it."""


@dataclass(frozen=True)
class LessonProblem:
    """What is wrong with a lesson; ``lesson`` is empty where the file is torn."""

    path: Path
    line: int
    lesson: str
    reason: str


@dataclass(frozen=True)
class LessonReport:
    """Counts over all lessons that could be read, and what is wrong with some.

    Noun phrases are counted without their determiners.
    """

    lessons: int
    verbs: int
    noun_phrases: int
    length: Lengths
    problems: tuple[LessonProblem, ...]


def load_lessons(folder: Path | None = None) -> tuple[Lesson, ...]:
    """The lessons in a folder's ``*.jsonl`` files, by file and line, or the bundled ones.

    Raises ``LessonFileError``.
    """
    return tuple(lesson for path in _files(folder) for _, lesson in read_lessons(path))


def check_lessons(
    folder: Path | None = None,
    scenes: Path | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> LessonReport:
    """Teach every lesson to a simulator; ``scenes`` is the folder of the scenes they are set in.

    Without ``scenes``, a folder of lessons that holds scenes too is set in those.
    ``progress`` hears how many lessons have been taught, and of how many.
    """
    if scenes is None and folder is not None and any(folder.glob("*.pddl")):
        scenes = folder
    rooms = _rooms(make_settings(scenes))
    problems: list[LessonProblem] = []
    found: list[tuple[Path, int, Lesson]] = []
    for path in _files(folder):
        try:
            found += [(path, line, lesson) for line, lesson in read_lessons(path)]
        except LessonFileError as error:
            problems.append(LessonProblem(path, error.line, "", error.reason))
    seen: set[str] = set()
    for done, (path, line, lesson) in enumerate(found, start=1):
        reasons = [*_known(lesson, seen), *_wrong(lesson, rooms)]
        problems += [LessonProblem(path, line, lesson.id, reason) for reason in reasons]
        if progress is not None:
            progress(done, len(found))
    return report([lesson for _, _, lesson in found], problems)


def report(lessons: Sequence[Lesson], problems: Sequence[LessonProblem] = ()) -> LessonReport:
    """Count what there is."""
    phrases = {_bare(phrase) for lesson in lessons for phrase in lesson.grounding}
    return LessonReport(
        len(lessons),
        len({lesson.verb for lesson in lessons}),
        len(phrases),
        Lengths.of([len(lesson.demonstration) for lesson in lessons]),
        tuple(problems),
    )


def _files(folder: Path | None) -> list[Path]:
    home = BUNDLED if folder is None else folder
    if not home.is_dir():
        raise LessonFileError(home, 0, "there is no such folder of lessons")
    found = sorted(home.glob("*.jsonl"))
    if not found:
        raise LessonFileError(home, 0, "holds no lessons: no .jsonl file")
    return found


def _known(lesson: Lesson, seen: set[str]) -> list[str]:
    if lesson.id in seen:
        return ["another lesson has the same id"]
    seen.add(lesson.id)
    return []


@dataclass(frozen=True)
class _Room:
    """A scene made ready, and what can be said of its things as it is found."""

    setting: Setting
    looks: Looks


def _rooms(settings: Settings) -> Callable[[str], _Room]:
    @cache
    def room(scene_id: str) -> _Room:
        setting = settings(scene_id)
        return _Room(setting, Looks(setting.scene, setting.scene.initial, setting.lexicon))

    return room


def _wrong(lesson: Lesson, rooms: Callable[[str], _Room]) -> Iterator[str]:
    """What keeps the lesson from being taught, in words."""
    try:
        room = rooms(lesson.scene)
    except (UnknownSceneError, WorldFileError) as error:
        yield str(error)
        return
    unknown = [o for objects in lesson.grounding.values() for o in objects]
    unknown = [o for o in unknown if o not in room.setting.scene.objects]
    if unknown:
        yield f"the scene {lesson.scene} has no object {unknown[0]}"
        return
    yield from _misread(lesson, room)
    yield from _misshown(lesson, room.setting)


def _misread(lesson: Lesson, room: _Room) -> Iterator[str]:
    """Where the robot would read something else than the lesson means."""
    frames = parse(lesson.command, room.setting.lexicon, room.setting.vocabulary)
    read = [(frame.verb, sorted(phrase.text for phrase in frame.phrases)) for frame in frames]
    if read != [(lesson.verb, sorted(lesson.grounding))]:
        yield f"{lesson.command!r} is read as {read}"
        return
    for argument in frames[0].arguments:
        missing = lesson.grounding[argument.phrase.text]
        for role in (argument.role, CONTENTS):
            if missing:
                may_mean = dict(refer(argument.phrase, room.looks, (), role))
                missing = tuple(o for o in missing if o not in may_mean)
        if missing:
            yield f"{argument.phrase.text!r} does not fit {missing[0]}"


def _misshown(lesson: Lesson, setting: Setting) -> Iterator[str]:
    """Where the demonstration cannot be done, or does not lead to the goal."""
    task, state = setting.task, setting.scene.initial
    strange = sorted(x.fluent for x in lesson.goal if not task.is_fluent(x.fluent))
    if strange:
        yield f"the goal speaks of {strange[0]}, which the scene does not know"
        return
    if satisfied(lesson.goal, state):
        yield "the goal holds before anything is shown"
    for number, action in enumerate(lesson.demonstration, start=1):
        try:
            state = apply(task, state, action)
        except InapplicableError as error:
            unmet = [str(o.literal) for o in error.obstacles if isinstance(o, Unmet)]
            why = f": {' '.join(unmet)} does not hold" if unmet else ""
            yield f"step {number}, {action}, cannot be done{why}"
            return
    missed = sorted(x for x in lesson.goal if not x.holds(state))
    if missed:
        yield f"the goal is not reached: {missed[0]} does not hold at the end"


def _bare(phrase: str) -> str:
    first, _, rest = phrase.lower().partition(" ")
    return rest if first in ("the", "a", "an", "some", "all") and rest else phrase.lower()
