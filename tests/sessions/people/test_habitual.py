"""People made up from habits: what they do with a right answer, and that they do it again alike."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from tests.sessions.people.corpus import book, settings
from verbteach.dialogue import acts
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.replies import read_reply
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.perception.noise import NoiseModel
from verbteach.policy.fixed_rules import RandomPolicy
from verbteach_sessions.driving import drive
from verbteach_sessions.example_plan import _WORDING
from verbteach_sessions.header import Header
from verbteach_sessions.method import Method
from verbteach_sessions.people.habits import ASKED, Habits, Rates, stage
from verbteach_sessions.people.habitual import HabitualTeacher
from verbteach_sessions.session import Session

YES_NO = (
    acts.NpGrdYnq,
    acts.EnvPredYnq,
    acts.GoalPredYnq,
    acts.PredChangeYnq,
    acts.GoalRelevantYnq,
)


@cache
def lessons() -> tuple[Lesson, ...]:
    """Boiling water twice in one kitchen: there is something to ask about."""
    found = [one for key in sorted(book().lessons) for one in book().lessons[key]]
    here = [one for one in found if one.scene == "kitchen-1" and len(one.demonstration) < 9]
    return tuple(one for one in here if one.verb == "boil")[:2]


class Heard(NamedTuple):
    """A question, its answer, whether that is the lesson's, and whether it was asked again."""

    question: acts.RobotAct
    act: acts.TeacherAct
    right: bool
    again: bool


def heard(habits: Habits, seed: int = 0) -> list[Heard]:
    """Each question with its answer."""
    robot = Robot(settings(), RandomPolicy(), RobotParameters(noise=NoiseModel.named("std5")))
    robot.open("kitchen-1")
    knowing = SimulatedTeacher(lessons(), settings())
    shadow = SimulatedTeacher(lessons(), settings())
    teacher = HabitualTeacher(knowing, habits, settings(), seed)
    found = []
    while (act := teacher.reply(robot.turn, robot.state)) is not None:
        shadow.given = knowing.given - isinstance(act, acts.Command)
        right = shadow.reply(robot.turn, robot.state)
        if robot.turn.waiting_act.name in ASKED:
            again = any(isinstance(one, acts.AskAgain) for one in robot.turn.acts)
            found.append(Heard(robot.turn.waiting_act, act, act == right, again))
        robot.receive(act)
    return found


def alike(rates: Rates, wording: bool = False) -> Habits:
    """The same rates for every question."""
    return Habits(dict.fromkeys(ASKED, rates), _WORDING[1] if wording else {})


def test_without_habits_everything_is_right() -> None:
    found = heard(Habits())
    assert len(found) > 4
    assert all(right for _, _, right, _ in found)


def test_who_always_errs_says_the_opposite_at_first_and_the_truth_when_asked_again() -> None:
    found = heard(alike(Rates(error=1.0)))
    asked = [(right, again) for question, _, right, again in found if isinstance(question, YES_NO)]
    assert asked
    assert all(right == again for right, again in asked)
    goals = [right for question, _, right, _ in found if isinstance(question, acts.IncludeFluent)]
    assert False in goals


def test_who_never_knows_says_so_and_passes_over_what_is_to_be_judged() -> None:
    for question, act, _, _ in heard(alike(Rates(unsure=1.0))):
        judged = isinstance(question, acts.SelectHypo | acts.IncludeFluent)
        assert isinstance(act, acts.Skip if judged else acts.Unsure)


def test_who_gives_up_late_answers_first() -> None:
    patient = heard(alike(Rates(gives_up=(0.0, 0.0, 1.0))))
    assert any(right for _, _, right, _ in patient)
    assert all(isinstance(act, acts.Skip) for _, act, _, _ in heard(alike(Rates((1.0, 1.0, 1.0)))))


@pytest.mark.parametrize(("asked", "name"), [(0, "first"), (1, "first"), (2, "later"), (5, "late")])
def test_patience_wears_out_in_stages(asked: int, name: str) -> None:
    assert stage(asked) == name
    rates = Rates(gives_up=(0.1, 0.2, 0.3))
    assert rates.passes(asked) == {"first": 0.1, "later": 0.2, "late": 0.3}[name]


def test_words_are_said_as_often_as_wanted_and_mean_the_answer() -> None:
    found = heard(alike(Rates(words=1.0), wording=True))
    said = [(question, act) for question, act, _, _ in found if isinstance(act, acts.Say)]
    assert len(said) == len(found) > 4
    assert all(read_reply(act.text).label for question, act in said if isinstance(question, YES_NO))


def test_every_wording_of_the_example_is_read_as_what_it_is_meant_to_be() -> None:
    for texts in _WORDING:
        for answer, phrases in texts.items():
            for text, _ in phrases:
                reply = read_reply(text)
                assert (reply.label, reply.rest) == (answer, "")


def test_the_same_seed_says_the_same_and_another_something_else() -> None:
    some = alike(Rates(error=0.4, unsure=0.3))
    once = heard(some, 1)
    assert heard(some, 1) == once
    assert [one.act for one in heard(some, 2)] != [one.act for one in once]


def test_a_person_who_is_broken_off_goes_on_as_if_nothing_had_been(tmp_path: Path) -> None:
    some = alike(Rates(error=0.4, unsure=0.2, words=0.5), wording=True)

    def teacher(given: int = 0) -> HabitualTeacher:
        knowing = SimulatedTeacher(lessons()[:2], settings(), given)
        return HabitualTeacher(knowing, some, settings(), 3)

    def begin(folder: Path) -> Session:
        header = Header.new("kitchen-1", Method(RandomPolicy()))
        return Session.create(folder, header, settings())

    with begin(tmp_path) as whole:
        drive(whole, teacher())
    with begin(tmp_path) as session:
        person = teacher()
        for _ in range(9):
            act = person.reply(session.turn, session.robot.state)
            assert act is not None
            session.perform(act)
        given = sum(line.kind == "command" for line in session.transcript())
    with Session.resume(session.path, settings()) as resumed:
        drive(resumed, teacher(given))
    assert resumed.content_hash == whole.content_hash


def test_phrases_are_drawn_as_often_as_they_were_said() -> None:
    some = Habits({}, {"yes": (("sure", 3), ("yes", 1))})
    rng = np.random.default_rng(0)
    drawn = [some.phrase("yes", rng) for _ in range(400)]
    assert drawn.count("sure") / 400 == pytest.approx(0.75, abs=0.06)
    assert some.phrase("no", rng) == ""
