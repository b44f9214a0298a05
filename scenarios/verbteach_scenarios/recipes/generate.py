"""Draws lessons from recipes: each task says how many, and its name is its seed.

Whether the robot reads a command as the recipe means it is not asked here but
when lessons are checked: what is drawn must not depend on the grammar.
"""

from __future__ import annotations

import re
import zlib
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import cycle
from typing import TypeVar

import numpy as np

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Setting
from verbteach.world.fluents import Goal
from verbteach_scenarios.recipes.bindings import Cast, casts, ground
from verbteach_scenarios.recipes.demonstrations import (
    CannotShowError,
    Subject,
    demonstrate,
)
from verbteach_scenarios.recipes.phrases import definite, of_many, placed, with_determiner
from verbteach_scenarios.recipes.tasks import Saying, Task, TeacherHabits

SEED = 2017
ATTEMPTS = 60
VARIETY = 3
"""As many teachers show a verb before one of them shows it a third time."""

_PLACEHOLDER = re.compile(r"\{(\w+)(?::(\w+)|=([^{}]+))?\}")
_FORMS = frozenset({"some", "bare", "a", "all", "place"})
_ENDS = ("can", "throw", "keys")
"""Nouns that are taken for verbs where words follow; they only end a command."""

_T = TypeVar("_T")


class RecipeError(ValueError):
    """A recipe does not give what it promises."""


@dataclass(frozen=True)
class Command:
    """A command in words, with what its noun phrases mean, in the order said."""

    text: str
    phrases: Mapping[str, tuple[str, ...]]


@dataclass
class Book:
    """The lessons written so far; one command in one scene always means one goal."""

    lessons: list[Lesson] = field(default_factory=list)
    meanings: dict[tuple[str, str], Goal] = field(default_factory=dict)
    numbers: Counter[str] = field(default_factory=Counter)

    def takes(self, lesson: Lesson) -> bool:
        """Whether the lesson says something new without contradicting what is there."""
        meant = self.meanings.get((lesson.scene, lesson.command), lesson.goal)
        same = (
            one.scene == lesson.scene
            and one.command == lesson.command
            and one.demonstration == lesson.demonstration
            for one in self.lessons
        )
        return meant == lesson.goal and not any(same)

    def teachers(self, verb: str) -> Counter[str]:
        """How many lessons of the verb each teacher has given."""
        return Counter(one.teacher for one in self.lessons if one.verb == verb)

    def add(self, lesson: Lesson) -> None:
        """Number the lesson within its verb and keep it."""
        slug = lesson.verb.replace(" ", "-")
        self.numbers[slug] += 1
        self.meanings[lesson.scene, lesson.command] = lesson.goal
        self.lessons.append(replace(lesson, id=f"{slug}-{self.numbers[slug]:02d}"))


def generate(
    tasks: Sequence[Task], teachers: Sequence[TeacherHabits], settings: Mapping[str, Setting]
) -> tuple[Lesson, ...]:
    """Write the lessons of all tasks; the same recipes give the same lessons."""
    book = Book()
    for task in tasks:
        _Writer(task, settings, teachers, book).write()
    return tuple(book.lessons)


@dataclass
class _Writer:
    """Writes the lessons of one task."""

    task: Task
    settings: Mapping[str, Setting]
    teachers: Sequence[TeacherHabits]
    book: Book
    rng: np.random.Generator = field(init=False)
    found: dict[tuple[str, frozenset[str]], list[Cast]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.rng = np.random.default_rng([SEED, zlib.crc32(self.task.name.encode())])

    def write(self) -> None:
        """As many lessons as the task wants; fewer than half of them is an error."""
        rooms = [s for s in self.settings if s in (self.task.scenes or self.settings)]
        scenes, sayings = cycle(self._shuffled(rooms)), cycle(self._shuffled(self.task.say))
        written = 0
        for _ in range(self.task.draw):
            saying = next(sayings)
            tries = (self._try(saying, next(scenes)) for _ in range(ATTEMPTS))
            lesson = next((one for one in tries if one and self.book.takes(one)), None)
            if lesson:
                self.book.add(lesson)
                written += 1
        if 2 * written < self.task.draw:
            raise RecipeError(f"{self.task.name}: {written} of {self.task.draw} lessons found")

    def _try(self, saying: Saying, scene_id: str) -> Lesson | None:
        setting = self.settings[scene_id]
        chosen = self._cast(saying, setting)
        command = chosen and self._say(saying, setting, chosen)
        if not chosen or not command:
            return None
        teacher, way = self._one(self._able(saying.verb)), self._one(self.task.ways)
        subject = Subject(
            tuple(ground(stage, chosen) for stage in way),
            tuple(ground((literal,), chosen) for literal in self.task.goal),
            tuple(o for objects in command.phrases.values() for o in objects),
        )
        try:
            shown = demonstrate(setting, subject, teacher)
        except CannotShowError:
            return None
        return Lesson(
            "new", scene_id, command.text, saying.verb, command.phrases, shown,
            subject.goal, teacher.name,
        )  # fmt: skip

    def _cast(self, saying: Saying, setting: Setting) -> Cast | None:
        key = (setting.scene.id, saying.named)
        if key not in self.found:
            self.found[key] = list(casts(self.task, setting.scene, saying.named))
        return self._one(self.found[key]) if self.found[key] else None

    def _say(self, saying: Saying, setting: Setting, cast: Cast) -> Command | None:
        """The command in words; none where its phrases could not be told apart."""
        phrases: dict[str, tuple[str, ...]] = {}
        text = saying.template
        for match in _PLACEHOLDER.finditer(saying.template):
            slot, form, literal = match.groups(default="")
            phrase = literal or self._phrase(setting, cast[slot], form)
            ends = match.end() == len(saying.template)
            if not phrase or phrase.lower() in phrases or (phrase.endswith(_ENDS) and not ends):
                return None
            phrases[phrase.lower()] = cast[slot]
            text = text.replace(match.group(), phrase, 1)
        return Command(text, phrases)

    def _phrase(self, setting: Setting, objects: Sequence[str], form: str) -> str | None:
        scene = setting.scene
        state = "" if form in _FORMS else form
        if len(objects) > 1:
            many = of_many(scene, objects, self.rng, state)
            return f"all {many}" if form == "all" else many
        if scene.objects[objects[0]].type == "person":
            return "me"
        if form == "place":
            text = placed(scene, objects[0], self.rng)
            return text and with_determiner(text, "the")
        described = definite(scene, objects[0], self.rng, state)
        return with_determiner(described.text, form)

    def _able(self, verb: str) -> list[TeacherHabits]:
        """The teachers to draw from; a verb that few have shown waits for others."""
        wanted, shown = self.task.teachers, self.book.teachers(verb)
        able = [one for one in self.teachers if one.name in wanted or not wanted]
        if sum(shown.values()) > 1 and len(shown) < VARIETY and not wanted:
            able = [one for one in able if one.name not in shown]
        return [teacher for teacher in able for _ in range(teacher.share)]

    def _one(self, things: Sequence[_T]) -> _T:
        return things[int(self.rng.integers(len(things)))]

    def _shuffled(self, things: Sequence[_T]) -> Iterator[_T]:
        return iter([things[int(i)] for i in self.rng.permutation(len(things))])
