"""Recipes: what they may say, whom they cast, how things are named, how teachers show."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from verbteach.dialogue.setting import Setting
from verbteach.world.fluents import Goal, Literal, State, satisfied
from verbteach.world.plan import Action
from verbteach.world.simulator import run
from verbteach_scenarios.build import RECIPES
from verbteach_scenarios.errors import SceneFileError
from verbteach_scenarios.recipes.bindings import casts, ground
from verbteach_scenarios.recipes.demonstrations import CannotShowError, Subject, demonstrate
from verbteach_scenarios.recipes.generate import RecipeError, generate
from verbteach_scenarios.recipes.phrases import definite, descriptions, of_many, placed
from verbteach_scenarios.recipes.tasks import Task, TeacherHabits, read_tasks, read_teachers
from verbteach_scenarios.settings import make_settings

ROOM = "living-room-1"
POUR = """[[task]]
name = "pour"
slots = { v = "cup", x = "liquid", c = "bottle" }
where = ["(contains ?c ?x)", "(not (has ?v ?x))"]
goal = ["(has ?v ?x)", "(on ?v ?c) (not (is-on ?c))"]
draw = 3
ways = [[], ["(grasping Robot ?c)"]]
say.pour = ["pour {x:some} into {v}"]
say.fill = ["fill {v} with {x:bare}"]
"""


@cache
def setting() -> Setting:
    return make_settings()(ROOM)


def tasks_of(tmp_path: Path, text: str) -> tuple[Task, ...]:
    (tmp_path / "some.toml").write_text(text)
    return read_tasks(tmp_path)


def goal(*texts: str) -> Goal:
    return frozenset(Literal.parse(text) for text in texts)


def end(actions: Iterable[Action]) -> State:
    return run(setting().task, setting().scene.initial, actions)[-1]


def test_a_task_is_read_with_all_its_parts(tmp_path: Path) -> None:
    (task,) = tasks_of(tmp_path, POUR)
    assert [(s.name, s.type, s.many) for s in task.slots] == [
        ("v", "cup", False),
        ("x", "liquid", False),
        ("c", "bottle", False),
    ]
    assert [str(x) for x in task.goal] == ["(has ?v ?x)", "(on ?v ?c)", "(not (is-on ?c))"]
    assert [len(way) for way in task.ways] == [0, 1]
    assert [(s.verb, s.named) for s in task.say] == [
        ("pour", frozenset({"x", "v"})),
        ("fill", frozenset({"x", "v"})),
    ]


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("{v}", "{w}"),
        ("draw = 3", "dram = 3"),
        ("(has ?v ?x)", "has ?v ?x"),
        ("name =", "title ="),
        ("slots =", "slots"),
    ],
)
def test_a_task_that_does_not_fit_is_refused(tmp_path: Path, before: str, after: str) -> None:
    with pytest.raises(SceneFileError, match=r"some\.toml"):
        tasks_of(tmp_path, POUR.replace(before, after))


def test_a_teacher_with_an_unknown_habit_is_refused(tmp_path: Path) -> None:
    (tmp_path / "teachers.toml").write_text("[zoe]\nsings = true\n")
    with pytest.raises(SceneFileError, match="sings"):
        read_teachers(tmp_path)


def test_casts_keep_to_the_scene_and_leave_something_to_do() -> None:
    tasks = {task.name: task for task in read_tasks(RECIPES)}
    task = tasks["fill a cup from a bottle or carton"]
    start = setting().scene.initial
    found = list(casts(task, setting().scene, frozenset()))
    assert found
    for cast in found:
        assert satisfied(ground(task.where, cast), start)
        assert not satisfied(ground(task.goal, cast), start)


def test_things_of_a_kind_are_cast_together_under_a_name_they_share() -> None:
    tasks = {task.name: task for task in read_tasks(RECIPES)}
    task = tasks["gather the cushions on a seat"]
    groups = {cast["xs"] for cast in casts(task, setting().scene, frozenset({"xs", "y"}))}
    assert ("Pillow_1", "Pillow_2", "Pillow_3", "Pillow_4") in groups
    assert ("Pillow_1", "Pillow_2") in groups  # the throw pillows
    assert ground(task.goal, {"xs": ("Pillow_1", "Pillow_2"), "y": ("Sofa_1",)}) == goal(
        "(on Pillow_1 Sofa_1)", "(on Pillow_2 Sofa_1)"
    )


def test_descriptions_count_what_they_fit() -> None:
    scene = setting().scene
    fits = {d.text: d.fits for d in descriptions(scene, "Pillow_3")}
    assert fits["pillow"] == 4
    assert fits["red pillow"] == 2
    assert fits["small red pillow"] == 1
    assert fits["small pillow"] == 1
    assert "small cotton small pillow" not in fits


def test_most_definite_phrases_tell_their_thing_apart() -> None:
    scene, rng = setting().scene, np.random.default_rng(0)
    found = [definite(scene, "Pillow_1", rng) for _ in range(200)]
    alone = sum(d.fits == 1 for d in found)
    assert 120 < alone < 200
    assert {len(d.words) for d in found} >= {1, 2}


def test_where_a_thing_lies_tells_which_one() -> None:
    scene, rng = setting().scene, np.random.default_rng(0)
    text = placed(scene, "Pillow_3", rng)
    assert text is not None
    assert text.startswith("pillow on the ")
    assert placed(scene, "Dvd_2", rng) is None


def test_many_things_go_by_the_plural_of_a_name_of_theirs_only() -> None:
    scene, rng = setting().scene, np.random.default_rng(0)
    assert of_many(scene, ("Pillow_1", "Pillow_2"), rng) == "the throw pillows"
    assert of_many(scene, ("Beer_1", "Beer_2"), rng, "dirty").startswith("the dirty ")


SUBJECT = Subject(
    (), (goal("(in Dvd_2 DvdPlayer_1)"), goal("(is-on DvdPlayer_1)")), ("Dvd_2", "DvdPlayer_1")
)


@pytest.mark.parametrize("habits", read_teachers(RECIPES), ids=lambda habits: habits.name)
def test_every_teacher_reaches_the_goal(habits: TeacherHabits) -> None:
    assert satisfied(SUBJECT.goal, end(demonstrate(setting(), SUBJECT, habits)))


def shown(**habits: object) -> list[str]:
    teacher = TeacherHabits("x", **habits)  # type: ignore[arg-type]
    return [str(action) for action in demonstrate(setting(), SUBJECT, teacher)]


def test_habits_show() -> None:
    plain = shown()
    assert shown(looks=True)[:2] == ["moveto Dvd_2", "moveto DvdPlayer_1"]
    assert shown(waits=True, returns=True) == [*plain, "wait", "moveto Person"]
    first, last = "insert Dvd_2 DvdPlayer_1", "turn-on DvdPlayer_1"
    forwards, backwards = shown(order="forwards"), shown(order="backwards")
    assert forwards.index(first) < forwards.index(last)
    assert backwards.index(first) > backwards.index(last)
    assert "close Cabinet_1" not in plain
    assert "close Cabinet_1" in shown(closes=True)


def test_what_is_left_in_the_hands_goes_back_where_it_was() -> None:
    subject = Subject((), (goal("(has Bowl_1 Chips)"),), ())
    kept = demonstrate(setting(), subject, TeacherHabits("x"))
    put = demonstrate(setting(), subject, TeacherHabits("x", puts_down=True))
    assert satisfied(goal("(grasping Robot Chips_1)"), end(kept))
    assert satisfied(goal("(on Chips_1 CoffeeTable_1)"), end(put))


def test_what_the_goal_wants_open_or_held_stays_so() -> None:
    subject = Subject((), (goal("(open Cabinet_1)", "(grasping Robot Remote_1)"),), ())
    tidy = TeacherHabits("x", puts_down=True, closes=True)
    assert satisfied(subject.goal, end(demonstrate(setting(), subject, tidy)))


def test_what_no_plan_reaches_cannot_be_shown() -> None:
    subject = Subject((), (goal("(on Sofa_1 Rug_1)"),), ())
    with pytest.raises(CannotShowError):
        demonstrate(setting(), subject, TeacherHabits("x"))


def test_the_same_recipe_writes_the_same_lessons_whatever_stands_before_it() -> None:
    tasks = {task.name: task for task in read_tasks(RECIPES)}
    louder, cushion = tasks["make a device louder"], tasks["put a cushion on a seat"]
    teachers, settings = read_teachers(RECIPES), {ROOM: setting()}
    written = generate([louder, cushion], teachers, settings)
    assert written == generate([louder, cushion], teachers, settings)
    swapped = generate([cushion, louder], teachers, settings)
    assert {x.command for x in swapped} == {x.command for x in written}


def test_a_task_that_finds_no_lessons_is_an_error() -> None:
    tasks = {task.name: task for task in read_tasks(RECIPES)}
    with pytest.raises(RecipeError, match="boil what is in a pot: 0 of"):
        generate([tasks["boil what is in a pot"]], read_teachers(RECIPES), {ROOM: setting()})
