"""Lessons as JSON Lines: one lesson a line, in words that the domain and people use."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from verbteach.dialogue.lesson import Lesson
from verbteach.world.fluents import Literal
from verbteach.world.plan import Action
from verbteach_scenarios.errors import WorldFileError
from verbteach_scenarios.pddl.grammar import read_text

_KEYS = ("id", "scene", "command", "verb", "grounding", "demonstration", "goal", "teacher")


class LessonFileError(WorldFileError):
    """A file of lessons does not fit; ``line`` is the lesson's."""


def lesson_to_line(lesson: Lesson) -> str:
    """One line, without its end; the same lesson gives the same line."""
    return json.dumps(lesson_to_data(lesson), ensure_ascii=False)


def lesson_to_data(lesson: Lesson) -> dict[str, Any]:
    """The lesson as plain JSON values."""
    return {
        "id": lesson.id,
        "scene": lesson.scene,
        "command": lesson.command,
        "verb": lesson.verb,
        "grounding": {phrase: list(objects) for phrase, objects in lesson.grounding.items()},
        "demonstration": [str(action) for action in lesson.demonstration],
        "goal": [str(literal) for literal in sorted(lesson.goal)],
        "teacher": lesson.teacher,
    }


def parse_lessons(text: str, path: Path) -> Iterator[tuple[int, Lesson]]:
    """Read lessons with their line numbers; raise ``LessonFileError`` at the first that is torn."""
    for number, line in enumerate(text.split("\n"), start=1):
        if line.strip():
            yield number, _lesson(line, path, number)


def read_lessons(path: Path) -> list[tuple[int, Lesson]]:
    """Read a file of lessons with their line numbers."""
    return list(parse_lessons(read_text(path, LessonFileError), path))


def _lesson(line: str, path: Path, number: int) -> Lesson:
    try:
        data = json.loads(line)
    except ValueError as problem:
        raise LessonFileError(path, number, f"is not JSON: {problem}") from None
    if not isinstance(data, dict):
        raise LessonFileError(path, number, "is no lesson: an object in braces is wanted")
    misfits = [key for key in data if key not in _KEYS]
    if misfits:
        raise LessonFileError(path, number, f"{misfits[0]} is not known; there are {_KEYS}")
    try:
        return _from_json(data)
    except KeyError as problem:
        raise LessonFileError(path, number, f"{problem.args[0]} is missing") from None
    except (TypeError, ValueError, AttributeError) as problem:
        raise LessonFileError(path, number, f"is no lesson: {problem}") from None


def _from_json(data: dict[str, Any]) -> Lesson:
    return Lesson(
        id=_word(data, "id"),
        scene=_word(data, "scene"),
        command=_word(data, "command"),
        verb=_word(data, "verb"),
        grounding={phrase: _words(objects) for phrase, objects in data["grounding"].items()},
        demonstration=tuple(Action.parse(text) for text in _words(data["demonstration"])),
        goal=frozenset(Literal.parse(text) for text in _words(data["goal"])),
        teacher=data.get("teacher", ""),
    )


def _word(data: dict[str, Any], key: str) -> str:
    value = data[key]
    if not isinstance(value, str) or not value:
        raise TypeError(f"{key} should be a text")
    return value


def _words(value: object) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(one, str) for one in value):
        raise TypeError(f"a list of texts should stand in place of {value!r}")
    return tuple(value)
