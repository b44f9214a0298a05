"""Recipes read from TOML: tasks with their slots and sayings, and teachers with their habits."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

from verbteach.world.fluents import Literal
from verbteach_scenarios.errors import SceneFileError
from verbteach_scenarios.pddl.grammar import read_text
from verbteach_scenarios.sidecar import parse_toml

Stage: TypeAlias = tuple[Literal, ...]
"""Literals over slots (``?x``) that hold together at some point of a demonstration."""

_LITERAL = re.compile(r"\(not\s*\([^()]*\)\)|\([^()]*\)")
_PLACEHOLDER = re.compile(r"\{(\w+)[^{}]*\}")
_NAMED = re.compile(r"\{(\w+)(?::\w+)?\}")


class Slot(NamedTuple):
    """A part of a task: an object of a type, or ``many`` of them."""

    name: str
    type: str
    many: bool


class Saying(NamedTuple):
    """One wording: the verb as a frame has it, and the command with slots to fill."""

    verb: str
    template: str

    @property
    def slots(self) -> frozenset[str]:
        """The slots that the command speaks of."""
        return frozenset(_PLACEHOLDER.findall(self.template))

    @property
    def named(self) -> frozenset[str]:
        """Those whose things are called by a name of theirs, not by words of the template's."""
        return frozenset(_NAMED.findall(self.template))


@dataclass(frozen=True)
class Task:
    """One meaning of some verbs.

    ``where`` must hold in the scene as it is found. ``only`` and ``without``
    narrow a slot by type, ``named`` by one of the names people use,
    ``exactly`` to an id; ``scenes`` and ``teachers`` to those listed, where
    any are. ``ways`` are stages that a teacher may go through
    before the goal; ``draw`` is how many lessons to write.
    """

    name: str
    slots: tuple[Slot, ...]
    say: tuple[Saying, ...]
    goal: Stage
    draw: int
    where: Stage = ()
    ways: tuple[tuple[Stage, ...], ...] = ((),)
    only: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    without: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    named: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    exactly: Mapping[str, str] = field(default_factory=dict)
    scenes: tuple[str, ...] = ()
    teachers: tuple[str, ...] = ()


@dataclass(frozen=True)
class TeacherHabits:
    """How somebody shows things.

    ``looks``: goes to everything named first. ``order``: reaches the goal's
    parts one by one, "forwards" or "backwards". ``puts_down``: leaves nothing
    in the hands that need not stay there. ``closes``: shuts and switches off
    what was not open or on before. ``waits`` at the end; ``returns`` to the
    person. ``share`` is how often the teacher is drawn beside the others.
    """

    name: str
    about: str = ""
    looks: bool = False
    order: str = ""
    puts_down: bool = False
    closes: bool = False
    waits: bool = False
    returns: bool = False
    share: int = 1


def read_tasks(folder: Path) -> tuple[Task, ...]:
    """All tasks of a folder, by file and place; raise ``SceneFileError`` for one that is wrong."""
    files = sorted(p for p in folder.glob("*.toml") if p.stem != "teachers")
    return tuple(task for path in files for task in _tasks(path))


def read_teachers(folder: Path) -> tuple[TeacherHabits, ...]:
    """The teachers, in the order of their file."""
    path = folder / "teachers.toml"
    data = parse_toml(read_text(path, SceneFileError), path)
    known = {f.name for f in fields(TeacherHabits)} - {"name"}
    for name, habits in data.items():
        for key in habits:
            if key not in known:
                raise SceneFileError(path, 0, f"{name} has an unknown habit {key}")
    return tuple(TeacherHabits(name, **habits) for name, habits in data.items())


def _tasks(path: Path) -> list[Task]:
    data = parse_toml(read_text(path, SceneFileError), path)
    found = []
    for entry in data.get("task", ()):
        try:
            found.append(_task(dict(entry)))
        except (KeyError, TypeError, ValueError) as problem:
            name = entry.get("name", "a task without a name")
            raise SceneFileError(path, 0, f"{name}: {problem!r}") from problem
    return found


def _task(entry: dict[str, Any]) -> Task:
    slots = tuple(
        Slot(name, type_.removesuffix("*"), type_.endswith("*"))
        for name, type_ in entry.pop("slots").items()
    )
    say = tuple(Saying(v, t) for v, templates in entry.pop("say").items() for t in templates)
    without = _lists(entry.pop("not", {}))
    task = Task(
        name=entry.pop("name"),
        slots=slots,
        say=say,
        goal=_stage(" ".join(entry.pop("goal"))),
        draw=entry.pop("draw"),
        where=_stage(" ".join(entry.pop("where", []))),
        ways=tuple(tuple(_stage(s) for s in way) for way in entry.pop("ways", [[]])),
        only=_lists(entry.pop("only", {})),
        without=without,
        named=_lists(entry.pop("named", {})),
        exactly=dict(entry.pop("exactly", {})),
        scenes=tuple(entry.pop("scenes", ())),
        teachers=tuple(entry.pop("teachers", ())),
    )
    if entry:
        raise ValueError(f"unknown keys {sorted(entry)}")
    known = {slot.name for slot in slots}
    for saying in say:
        if saying.slots - known:
            raise ValueError(f"{saying.template!r} names a slot that the task has not")
    return task


def _lists(table: Mapping[str, list[str]]) -> dict[str, tuple[str, ...]]:
    return {name: tuple(words) for name, words in table.items()}


def _stage(text: str) -> Stage:
    literals = _LITERAL.findall(text)
    if " ".join(_LITERAL.sub("", text).split()):
        raise ValueError(f"not a conjunction of literals: {text!r}")
    return tuple(Literal.parse(" ".join(one.split())) for one in literals)
