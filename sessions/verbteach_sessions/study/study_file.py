"""A study's file: TOML, read and checked as a whole, every misfit with its line."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Collection, Mapping
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeAlias

from verbteach.perception.noise import READINGS, NoiseModel
from verbteach_sessions.method import POLICIES
from verbteach_sessions.study.design import (
    DESIGNS,
    PANELS,
    WITHIN,
    Condition,
    Lessons,
    Stop,
    Study,
    Task,
)
from verbteach_sessions.study.errors import Problem, StudyFileError
from verbteach_sessions.study.questionnaire import END, NASA_TLX, WHEN, Question, Questionnaire
from verbteach_sessions.study.tables import Notes, Table
from verbteach_sessions.study.toml_lines import lines_of
from verbteach_sessions.study.weights_beside import LEARNED, WeightsBeside

_NAME = re.compile(r"[a-z0-9][a-z0-9-]{0,39}")
_PLACE = re.compile(r"\s*\((?:at line (\d+), column \d+|at end of document)\)$")
MOST_MINUTES = 24 * 60.0
Kinds: TypeAlias = Callable[[], Collection[str]]
"""The kinds of fluents there are to see; asked for only where noise names some."""


def read_study(
    path: Path,
    scenes: Collection[str],
    kept: Mapping[str, str] | None = None,
    kinds: Kinds | None = None,
) -> Study:
    """The study in the file ``path``, whose scenes are among ``scenes``.

    With ``kinds`` noise of other kinds of fluents is a misfit. ``kept``, for a
    copy that was made when somebody began: the hashes of the weights by
    condition, copies of which lie beside it. Raises :class:`StudyFileError`
    with all that does not fit, and ``OSError``.
    """
    return parse_study(path.read_bytes(), path, scenes, kept, kinds)


def parse_study(
    raw: bytes,
    path: Path,
    scenes: Collection[str],
    kept: Mapping[str, str] | None = None,
    kinds: Kinds | None = None,
) -> Study:
    """The study that ``raw`` says; beside ``path`` lie the files it names.

    Otherwise as :func:`read_study`. Raises :class:`StudyFileError`.
    """
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise StudyFileError(path, [Problem(line, "is not UTF-8 text")]) from error
    notes = Notes(lines_of(text))
    beside = WeightsBeside(path.parent, kept)
    table = Table(_parsed(text, path), (), notes)
    study = _study(table, scenes, sha256(raw).hexdigest(), beside, kinds)
    if notes.problems:
        raise StudyFileError(path, notes.problems)
    return study


def _parsed(text: str, path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        place = _PLACE.search(str(error))
        line = int(place[1]) if place and place[1] else text.rstrip().count("\n") + 1
        problem = Problem(line, f"is not TOML: {_PLACE.sub('', str(error))}")
        raise StudyFileError(path, [problem]) from None


def _study(
    file: Table,
    scenes: Collection[str],
    file_hash: str,
    beside: WeightsBeside,
    kinds: Kinds | None,
) -> Study:
    head = file.table("study")
    design = head.choice("design", DESIGNS, DESIGNS[0])
    conditions = tuple(_condition(one, beside, kinds) for one in file.tables("condition"))
    _check_ids(file, "condition", [one.id for one in conditions])
    if not conditions:
        file.fail("condition", "there is none: write at least one [[condition]] with its id")
    practice = _lessons(file.table("practice"), scenes, 1) if "practice" in file else None
    parts = max(len(conditions), 1) if design == WITHIN else 1
    study = Study(
        id=_name(head, "id"),
        title=head.text("title"),
        seed=head.whole("seed", 0, 0, 2**63 - 1) or 0,
        design=design,
        consent=head.text("consent").strip(),
        instructions=head.text("instructions", "").strip(),
        thanks=head.text("thanks", "").strip(),
        conditions=conditions,
        lessons=_lessons(file.table("lessons"), scenes, parts),
        practice=practice,
        questionnaire=_questionnaire(file.table("questionnaire")),
        file_hash=file_hash,
        attached=beside.attached,
    )
    head.close()
    file.close()
    return study


def _condition(table: Table, beside: WeightsBeside, kinds: Kinds | None) -> Condition:
    panels = table.words("panels", PANELS, PANELS)
    weights, freeze = table.text("weights", ""), table.flag("freeze", False)
    condition = Condition(
        id=_name(table, "id"),
        policy=table.choice("policy", POLICIES),
        noise=_noise(table, kinds),
        noise_reading=table.choice("noise_reading", READINGS, "literal"),
        panels=tuple(panel for panel in PANELS if panel in panels),
        weights=weights,
        weights_hash=beside.read(table, weights),
        freeze=freeze,
    )
    if condition.policy != LEARNED and (weights or freeze):
        name = "weights" if weights else "freeze"
        table.fail(name, f"is for the policy {LEARNED!r} alone: the others learn no weights")
    table.close()
    return condition


def _noise(table: Table, kinds: Kinds | None) -> str:
    noise = table.text("noise", "perfect")
    try:
        model = NoiseModel.named(noise)
        if model.spreads and kinds is not None:
            model.check_kinds(kinds())
    except ValueError as error:
        table.fail("noise", str(error))
    return noise


def _lessons(table: Table, scenes: Collection[str], parts: int) -> Lessons:
    tasks = tuple(_task(one, scenes, parts) for one in table.tables("task"))
    named = table.words("scenes", (), scenes)
    if not named and not tasks:
        table.fail("scenes", "is missing: name the scenes, or write a [[...task]] with one")
    if tasks and any(not any(task.part in (0, part) for task in tasks) for part in _parts(parts)):
        table.fail("task", "some part has no task: each of the conditions' parts needs one")
    stop = Stop(
        lessons=table.whole("lessons", None, 1, 10_000),
        minutes=table.number("minutes", None),
        mastery=table.whole("mastery", None, 1, 1000),
        questions=table.whole("questions", None, 0, 1000),
    )
    if not tasks and stop.lessons is stop.minutes is stop.mastery is None:
        table.fail("lessons", "nothing ends it: give lessons, minutes, mastery, or tasks")
    if stop.minutes is not None and stop.minutes > MOST_MINUTES:
        table.fail("minutes", f"must be at most {MOST_MINUTES:g}")
    lessons = Lessons(
        scenes=tuple(dict.fromkeys((*named, *(task.scene for task in tasks)))),
        tasks=tasks,
        stop=stop,
        text=table.text("text", "").strip(),
    )
    table.close()
    return lessons


def _parts(count: int) -> range:
    return range(1, count + 1)


def _task(table: Table, scenes: Collection[str], parts: int) -> Task:
    scene = table.choice("scene", scenes)
    task = Task(scene, table.text("text").strip(), table.whole("part", 0, 1, parts) or 0)
    table.close()
    return task


def _questionnaire(table: Table) -> Questionnaire:
    default = Questionnaire()
    questions = default.questions
    if "question" in table:
        questions = tuple(_question(one) for one in table.tables("question"))
        taken = [scale.id for scale in NASA_TLX]
        _check_ids(table, "question", [one.id for one in questions], taken)
    asked = Questionnaire(
        when=table.choice("when", WHEN, END),
        nasa_tlx=table.flag("nasa_tlx", True),
        questions=questions,
    )
    table.close()
    return asked


def _question(table: Table) -> Question:
    question = Question(_name(table, "id", joint="_"), table.text("text").strip())
    table.close()
    return question


def _name(table: Table, name: str, joint: str = "-") -> str:
    """A name that is safe in a record, a table and a file's name."""
    value = table.text(name)
    if value and not _NAME.fullmatch(value.replace("_", "-") if joint == "_" else value):
        table.fail(name, f"use up to 40 small letters, digits and '{joint}', a letter first")
    return value


def _check_ids(table: Table, name: str, ids: list[str], taken: Collection[str] = ()) -> None:
    seen = set(taken)
    for index, one in enumerate(ids):
        if one and one in seen:
            table.notes.add((*table.path, name, index, "id"), f"{one!r} is used twice")
        seen.add(one)
