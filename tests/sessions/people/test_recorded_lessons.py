"""Lessons from records: a person's own teaching, given again by the simulated teacher."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.sessions.people.corpus import book, read_all, settings
from tests.sessions.rooms import BOIL, TAUGHT, recorded
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.world.fluents import satisfied
from verbteach.world.simulator import run
from verbteach_sessions.example import ExampleParameters, make_example
from verbteach_sessions.method import Method
from verbteach_sessions.people.golds import LessonBook
from verbteach_sessions.people.recorded import Recorded
from verbteach_sessions.people.recorded_lessons import taught
from verbteach_sessions.people.rehearsal import meet, rehearse


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


@pytest.mark.slow
def test_a_policy_meets_people_and_those_fitted_to_others_alike(tmp_path: Path) -> None:
    made = make_example(tmp_path, ExampleParameters(sessions=16, lessons=4, seed=7))
    heard: list[tuple[int, int]] = []
    meeting = meet(
        read_all(made),
        book(),
        settings(),
        np.random.default_rng(0),
        lambda done, of: heard.append((done, of)),
    )
    assert meeting.alike
    assert meeting.people == (4, 4)
    assert meeting.episodes[0] == meeting.episodes[1] > 20
    assert heard[-1] == (8, 8)


def test_comparing_with_a_simulator_needs_four_people(records: tuple[Recorded, ...]) -> None:
    with pytest.raises(ValueError, match="4 people"):
        meet(records, book(), settings(), np.random.default_rng(0))
