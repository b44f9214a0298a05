"""What counts as right: the world, the lesson, what followed; nothing where none of them tells."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.sessions.people.corpus import settings
from verbteach.dialogue import acts
from verbteach.dialogue.lesson import Lesson
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach_sessions.people.golds import Gold, Later, LessonBook
from verbteach_sessions.people.standing import Standing

OPENED = Literal(Fluent("open", ("Fridge_1",)))
LESSON = Lesson(
    "one",
    "kitchen-1",
    "open the fridge",
    "open",
    {"the fridge": ("Fridge_1",)},
    (Action("moveto", ("Fridge_1",)), Action("open", ("Fridge_1",))),
    frozenset({OPENED}),
)
START = settings()("kitchen-1").scene.initial
AFTER = START | {OPENED.fluent}
NOW = Standing((acts.AwaitCommand(),), "", "kitchen-1", AFTER, START)


def gold(*lessons: Lesson, later: Later | None = None) -> Gold:
    return Gold(lessons, later or Later(), settings())


def test_the_world_tells_about_the_environment_and_the_change_whoever_teaches() -> None:
    here = sorted(START)[0]
    assert gold().truth(acts.EnvPredYnq(here), NOW) is True
    assert gold().truth(acts.EnvPredYnq(OPENED.fluent), NOW) is False
    assert gold().truth(acts.PredChangeYnq(OPENED), NOW) is True
    assert gold().truth(acts.PredChangeYnq(Literal(here)), NOW) is False


def test_an_unknown_world_tells_nothing() -> None:
    lost = replace(NOW, world=None, start=None)
    for question in (acts.EnvPredYnq(OPENED.fluent), acts.PredChangeYnq(OPENED)):
        assert gold().truth(question, lost) is None
    assert gold(LESSON).truth(acts.SelectHypo(LESSON.goal, "", ()), lost) is None


def test_the_lesson_tells_about_objects_goals_and_what_is_judged() -> None:
    one = gold(LESSON)
    assert one.truth(acts.NpGrdYnq("the fridge", "Fridge_1"), NOW) is True
    assert one.truth(acts.NpGrdYnq("the fridge", "Mug_1"), NOW) is False
    assert one.truth(acts.BulkNpGrdYnq((("the fridge", "Mug_1"),)), NOW) is False
    assert one.objects("the fridge") == frozenset({"Fridge_1"})
    assert one.objects("the mug") is None
    assert one.truth(acts.GoalPredYnq(OPENED), NOW) is True
    assert one.truth(acts.GoalRelevantYnq(Literal(OPENED.fluent, positive=False)), NOW) is False
    assert one.truth(acts.SelectHypo(LESSON.goal, "", ()), NOW) is True
    assert one.truth(acts.SelectHypo(LESSON.goal, "", ()), replace(NOW, world=START)) is False
    assert one.truth(acts.IncludeFluent(LESSON.goal), NOW) is True


def test_two_lessons_of_the_same_words_tell_only_what_they_agree_on() -> None:
    other = replace(LESSON, id="two", grounding={"the fridge": ("Fridge_2",)})
    both = gold(LESSON, other)
    assert both.truth(acts.GoalPredYnq(OPENED), NOW) is True
    assert both.truth(acts.NpGrdYnq("the fridge", "Fridge_1"), NOW) is None
    assert both.objects("the fridge") is None


def test_what_followed_tells_about_people_who_teach_what_they_like() -> None:
    later = Later({"the fridge": "Fridge_1"}, frozenset({OPENED}))
    one = gold(later=later)
    assert one.truth(acts.NpGrdYnq("the fridge", "Fridge_1"), NOW) is True
    assert one.truth(acts.NpGrdYnq("the fridge", "Mug_1"), NOW) is False
    assert one.truth(acts.NpGrdYnq("the mug", "Mug_1"), NOW) is None
    pairs = (("the fridge", "Mug_1"), ("the mug", "Mug_1"))
    assert one.truth(acts.BulkNpGrdYnq(pairs), NOW) is False  # one of them is known to be wrong
    assert one.truth(acts.BulkNpGrdYnq(pairs[1:]), NOW) is None
    assert one.truth(acts.GoalPredYnq(OPENED), NOW) is True
    assert one.objects("the fridge") == frozenset({"Fridge_1"})


@pytest.mark.parametrize(
    "question",
    [
        acts.NpGrdYnq("the fridge", "Fridge_1"),
        acts.GoalPredYnq(OPENED),
        acts.GoalRelevantYnq(OPENED),
        acts.SelectHypo(frozenset({OPENED}), "", ()),
        acts.IncludeFluent(frozenset({OPENED})),
    ],
)
def test_where_nothing_tells_nothing_is_made_up(question: acts.RobotAct) -> None:
    assert gold().truth(question, NOW) is None


def test_a_book_finds_lessons_by_scene_and_words() -> None:
    elsewhere = replace(LESSON, scene="kitchen-2")
    book = LessonBook.of([LESSON, elsewhere])
    assert book.meant("kitchen-1", "open the fridge") == (LESSON,)
    assert book.meant("kitchen-1", "open the door") == ()
