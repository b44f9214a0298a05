"""Lessons from records: a person's own teaching, given again by the simulated teacher."""

from __future__ import annotations

from pathlib import Path

from tests.sessions.people.corpus import book, read_all, settings
from tests.sessions.rooms import BOIL, TAUGHT, recorded
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.world.fluents import satisfied
from verbteach.world.simulator import run
from verbteach_sessions.method import Method
from verbteach_sessions.people.golds import LessonBook
from verbteach_sessions.people.recorded import Recorded
from verbteach_sessions.people.recorded_lessons import taught
from verbteach_sessions.people.rehearsal import rehearse


def test_what_a_person_taught_can_be_taught_again(tmp_path: Path) -> None:
    (record,) = read_all([recorded(tmp_path, TAUGHT + "good\n", teacher="human")])
    found = [one.lesson for one in taught(record, book(), settings())]
    assert [(one.scene, one.verb) for one in found] == [
        ("kitchen-1", "boil"),
        ("kitchen-3", "boil"),
    ]
    for lesson in found:
        setting = settings()(lesson.scene)
        end = run(setting.task, setting.scene.initial, lesson.demonstration)[-1]
        assert satisfied(lesson.goal, end)
        assert lesson.teacher == record.person
    teacher = SimulatedTeacher(found, settings())
    met = list(rehearse(Method(), found, teacher, settings(), "someone"))
    assert [one.success for one in met] == [False, True]
    assert {one.person for one in met} == {"someone"}


def test_simulated_sessions_give_their_own_lessons_back(records: tuple[Recorded, ...]) -> None:
    for record in records:
        given = [one.lesson for one in taught(record, book(), settings())]
        commands = [said.act.text for said in record.said if said.act.name == "command"]  # type: ignore[union-attr]
        assert [one.command for one in given] == [text for text in commands if text != "yes"]


def test_what_began_in_a_changed_world_is_no_lesson(tmp_path: Path) -> None:
    script = BOIL + "command: open the fridge\ndo: moveto Fridge_1\ndo: open Fridge_1\ndone\ngood\n"
    (record,) = read_all([recorded(tmp_path, script)])
    verbs = [one.lesson.verb for one in taught(record, LessonBook(), settings())]
    assert verbs == ["boil"]


def test_what_nobody_confirmed_is_no_lesson(tmp_path: Path) -> None:
    (record,) = read_all([recorded(tmp_path, BOIL.replace("done\ngood\n", "done\nskip\n"))])
    assert list(taught(record, LessonBook(), settings())) == []
