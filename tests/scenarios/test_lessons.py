"""The bundled lessons, the file they are in, and what a check finds wrong with a lesson."""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.dialogue.lesson import Lesson
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach_scenarios.build import LESSONS, lesson_text
from verbteach_scenarios.lesson_file import LessonFileError, lesson_to_line, parse_lessons
from verbteach_scenarios.lessons import check_lessons, load_lessons, report

BUNDLED = load_lessons()
CELLAR = """(define (problem cellar) (:domain household)
(:objects Hatch_1 - opening Mug_1 - cup Shelf_1 - surface)
(:init (openable Hatch_1) (on Mug_1 Shelf_1)) (:goal (and)))
"""
OPEN: dict[str, Any] = {
    "id": "open-1",
    "scene": "cellar",
    "command": "open the hatch",
    "verb": "open",
    "grounding": {"the hatch": ["Hatch_1"]},
    "demonstration": ["moveto Hatch_1", "open Hatch_1"],
    "goal": ["(open Hatch_1)"],
    "teacher": "ada",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder of lessons with the scene that they are set in."""
    (tmp_path / "cellar.pddl").write_text(CELLAR)
    return tmp_path


def test_there_are_as_many_as_the_paper_had_and_as_varied() -> None:
    """Section 5.1: 979 instances, 75 verbs, 215 noun phrases, lengths 1-51, 4.82 +- 4.8."""
    found = report(BUNDLED)
    assert found.lessons >= 600
    assert found.verbs >= 75
    assert found.noun_phrases >= 200
    assert found.length.min == 1
    assert 45 <= found.length.max <= 55
    assert 4.3 <= found.length.mean <= 5.7
    assert 4.0 <= found.length.sd <= 5.5


def test_the_papers_own_examples_are_among_them() -> None:
    commands = {lesson.command for lesson in BUNDLED}
    assert {
        "boil the water",
        "microwave the ramen",
        "throw the beer into the trashcan",
        "fill the cup with water",
        "fill the cup with milk",
    } <= commands


def test_boiling_the_water_is_about_the_waters_heat() -> None:
    boil = [lesson for lesson in BUNDLED if lesson.command == "boil the water"]
    assert all(x.goal == {Literal(Fluent("hot", ("Water",)))} for x in boil)
    assert all(x.grounding == {"the water": ("Water",)} for x in boil)


def test_one_verb_means_different_ends_in_different_situations() -> None:
    meanings = defaultdict(set)
    for lesson in BUNDLED:
        shape = frozenset((x.fluent.predicate, x.positive) for x in lesson.goal)
        meanings[lesson.verb].add(shape)
    for verb in ("fill", "put", "take", "microwave", "light", "draw"):
        assert len(meanings[verb]) >= 2, verb


def test_verbs_are_said_in_several_ways_and_shown_by_several_teachers() -> None:
    teachers, wordings = defaultdict(set), defaultdict(set)
    for lesson in BUNDLED:
        teachers[lesson.verb].add(lesson.teacher)
        text = lesson.command.lower()
        for phrase in lesson.grounding:
            text = text.replace(phrase, "_", 1)
        wordings[lesson.verb].add(text)
    often = [verb for verb in teachers if sum(x.verb == verb for x in BUNDLED) >= 8]
    assert len(often) >= 20
    assert all(len(teachers[verb]) >= 3 for verb in often)
    assert sum(len(wordings[verb]) >= 2 for verb in often) >= 0.8 * len(often)


def test_a_command_in_a_scene_means_one_thing() -> None:
    meant: dict[tuple[str, str], object] = {}
    for lesson in BUNDLED:
        assert meant.setdefault((lesson.scene, lesson.command), lesson.goal) == lesson.goal


def test_lessons_of_one_kitchen_can_be_taught(tmp_path: Path) -> None:
    lines = (lesson_to_line(x) for x in BUNDLED if x.scene == "kitchen-2")
    (tmp_path / "some.jsonl").write_text("\n".join(lines))
    found = check_lessons(tmp_path)
    assert found.lessons > 50
    assert found.problems == ()


@pytest.mark.slow
def test_every_lesson_can_be_taught() -> None:
    found = check_lessons()
    assert found.lessons == len(BUNDLED)
    assert found.problems == ()


@pytest.mark.slow
def test_the_recipes_write_what_is_committed() -> None:
    assert lesson_text() == LESSONS.read_text(encoding="utf-8"), "run the build"


def changed(**values: Any) -> dict[str, Any]:
    return {**OPEN, **values}


@pytest.mark.parametrize(
    ("lesson", "reason"),
    [
        (changed(scene="attic"), "no scene 'attic'"),
        (changed(grounding={"the hatch": ["Hatch_9"]}), "no object Hatch_9"),
        (changed(grounding={"the hatch": ["Mug_1"]}), "does not fit Mug_1"),
        (changed(grounding={"the door": ["Hatch_1"]}), "is read as"),
        (changed(verb="shut"), "is read as"),
        (changed(command="gargle blorp"), "is read as"),
        (changed(demonstration=["open Hatch_1"]), "step 1, open Hatch_1, cannot be done"),
        (changed(demonstration=["moveto Hatch_1", "sing"]), "step 2, sing, cannot be done"),
        (changed(demonstration=["moveto Hatch_1"]), "the goal is not reached: (open Hatch_1)"),
        (changed(goal=["(on Mug_1 Shelf_1)"]), "the goal holds before"),
        (changed(goal=["(ajar Hatch_1)"]), "speaks of (ajar Hatch_1)"),
    ],
)
def test_a_check_says_what_is_wrong(folder: Path, lesson: dict[str, Any], reason: str) -> None:
    (folder / "mine.jsonl").write_text(json.dumps(lesson) + "\n")
    problems = check_lessons(folder).problems
    assert any(reason in problem.reason for problem in problems), problems
    assert {(p.path.name, p.line, p.lesson) for p in problems} == {("mine.jsonl", 1, "open-1")}


def test_a_check_finds_an_id_used_twice(folder: Path) -> None:
    line = json.dumps(OPEN)
    (folder / "mine.jsonl").write_text(f"{line}\n\n{line}\n")
    problems = check_lessons(folder).problems
    assert [(p.line, p.reason) for p in problems] == [(3, "another lesson has the same id")]


def test_a_lesson_that_fits_has_no_problems(folder: Path) -> None:
    (folder / "mine.jsonl").write_text(json.dumps(OPEN))
    found = check_lessons(folder)
    assert (found.lessons, found.verbs, found.noun_phrases, found.problems) == (1, 1, 1, ())
    assert (found.length.mean, found.length.sd) == (2.0, 0.0)


def test_lessons_can_be_set_in_bundled_scenes_or_in_another_folders(tmp_path: Path) -> None:
    (tmp_path / "mine.jsonl").write_text(json.dumps(OPEN))
    (problem,) = check_lessons(tmp_path).problems
    assert "kitchen-1" in problem.reason
    (tmp_path / "rooms").mkdir()
    (tmp_path / "rooms" / "cellar.pddl").write_text(CELLAR)
    assert check_lessons(tmp_path, tmp_path / "rooms").problems == ()


def without(key: str) -> str:
    return json.dumps({k: v for k, v in OPEN.items() if k != key})


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        (json.dumps(OPEN)[:40], "is not JSON"),
        ("[1]", "an object in braces"),
        (without("verb"), "verb is missing"),
        (without("goal"), "goal is missing"),
        (json.dumps(changed(mood="glad")), "mood is not known"),
        (json.dumps(changed(goal=[])), "has a goal"),
        (json.dumps(changed(demonstration=[])), "at least one action"),
        (json.dumps(changed(demonstration="open")), "a list of texts"),
        (json.dumps(changed(goal=["open)"])), "not a fluent"),
        (json.dumps(changed(id=3)), "id should be a text"),
        (json.dumps(changed(grounding=[])), "is no lesson"),
    ],
)
def test_a_torn_line_is_named(folder: Path, line: str, reason: str) -> None:
    (folder / "mine.jsonl").write_text(json.dumps(OPEN) + "\n" + line + "\n")
    with pytest.raises(LessonFileError, match=r"mine\.jsonl:2") as caught:
        load_lessons(folder)
    assert reason in caught.value.reason
    assert [p.line for p in check_lessons(folder).problems] == [2]


def test_a_folder_without_lessons_is_said_to_be_so(tmp_path: Path) -> None:
    with pytest.raises(LessonFileError, match="holds no lessons"):
        load_lessons(tmp_path)
    with pytest.raises(LessonFileError, match="no such folder"):
        load_lessons(tmp_path / "nowhere")


words = st.text(st.characters(categories=("L", "N")), min_size=1, max_size=8)
arguments = st.lists(words, max_size=3).map(tuple)
fluents = st.builds(Fluent, words, arguments)
lessons = st.builds(
    Lesson,
    id=words,
    scene=words,
    command=st.text(min_size=1, max_size=30),
    verb=words,
    grounding=st.dictionaries(
        words, st.lists(words, min_size=1, max_size=2).map(tuple), max_size=3
    ),
    demonstration=st.lists(st.builds(Action, words, arguments), min_size=1, max_size=3).map(tuple),
    goal=st.frozensets(st.builds(Literal, fluents, st.booleans()), min_size=1, max_size=3),
    teacher=words,
)


@given(lessons)
def test_a_lesson_survives_its_line(lesson: Lesson) -> None:
    line = lesson_to_line(lesson)
    assert [one for _, one in parse_lessons(f"{line}\n", Path("x.jsonl"))] == [lesson]


def test_strange_line_ends_in_a_command_do_not_tear_it() -> None:
    line = json.dumps(changed(command="open\u2028the\x85hatch"), ensure_ascii=False)
    assert [number for number, _ in parse_lessons(line, Path("x.jsonl"))] == [1]
