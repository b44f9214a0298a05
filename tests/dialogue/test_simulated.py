"""The simulated teacher teaches lessons from their gold, and its judgements are fair."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from tests.dialogue.stage import BOIL, robot, tell
from verbteach.dialogue import acts
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.judging import Judge
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.simulated import SimulatedTeacher, TeacherHabits, seeded_order
from verbteach.verbs.space import FrameKey
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action
from verbteach.world.simulator import run

GOAL = frozenset({Literal(Fluent("hot", ("Water",)))})


@cache
def boil(scene: str = "kitchen-1", number: int = 0) -> Lesson:
    steps = tuple(Action.parse(step) for step in BOIL)
    return Lesson(
        f"boil-{number}", scene, "boil the water", "boil", {"the water": ("Water",)}, steps, GOAL
    )


def held(pupil: Robot, lessons: tuple[Lesson, ...], limit: int = 100) -> None:
    teacher = SimulatedTeacher(lessons, pupil.settings)
    for _ in range(limit):
        act = teacher.reply(pupil.turn, pupil.state)
        if act is None:
            return
        pupil.receive(act)
    pytest.fail(f"the dialogue did not end within {limit} turns")


def test_a_lesson_given_twice_is_learned_and_then_carried_out() -> None:
    pupil = robot()
    held(pupil, (boil(), boil(number=1)))
    assert pupil.state.totals.episodes == 2
    assert pupil.state.totals.learned == 1
    assert pupil.state.totals.successes == 1


def test_lessons_repeat_in_a_newly_seeded_order() -> None:
    lessons = tuple(boil(number=number) for number in range(5))
    order = seeded_order(lessons, 12, seed=7)
    assert len(order) == 12
    assert sorted(one.id for one in order[:5]) == sorted(one.id for one in order[5:10])
    assert order == seeded_order(lessons, 12, seed=7)
    assert order != seeded_order(lessons, 12, seed=8)


def test_leaving_out_a_needless_step_is_right_and_a_needless_change_is_wrong() -> None:
    pupil = robot()
    judge = Judge(boil(), pupil.setting)
    start, task = pupil.state.world, pupil.setting.task
    as_shown = run(task, start, boil().demonstration)[-1]
    assert judge.execution(start, as_shown)
    more = run(task, as_shown, [Action("moveto", ("Tap_1",)), Action("turn-on", ("Tap_1",))])
    assert len(more) == 3
    assert not judge.execution(start, more[-1])
    assert not judge.execution(start, start)


def test_a_wrong_goal_is_corrected_literal_by_literal() -> None:
    pupil = robot()
    teacher = SimulatedTeacher((boil(),), pupil.settings)
    said: list[str] = []
    while (act := teacher.reply(pupil.turn, pupil.state)) is not None:
        if isinstance(act, acts.Good) and not said:
            act = acts.Strike(next(iter(GOAL)))  # the robot is made to forget the point of it
        if pupil.turn.phase is Phase.READ_BACK:
            said.append(act.name)
        pupil.receive(act)
    assert said == ["strike", "bad", "keep", "good"]
    frame = pupil.state.knowledge.frames[FrameKey("boil", 1)]
    hot = Literal(Fluent("hot", ("?0",)))
    assert all(hot in node.literals for node in frame.nodes.values() if node.confirmed)


def test_a_word_like_one_it_knows_is_no_slip_if_the_teacher_says_so() -> None:
    """No to "did you mean toast?" means that "roast" was meant; the lesson is not lost."""
    pupil = robot()
    offered = tell(pupil, acts.Command("roast the egg"))
    assert isinstance(offered.waiting_act, acts.AskRephrase)
    assert pupil.state.suggested == "toast the egg"
    turn = tell(pupil, acts.Command("no"))
    assert turn.phase is Phase.DEMONSTRATION
    assert pupil.state.episode is not None
    assert pupil.state.episode.frame.verb == "roast"


@pytest.mark.parametrize(
    ("habits", "expected"),
    [
        (TeacherHabits(), acts.Yes()),
        (TeacherHabits(wrong=1.0), acts.No()),
        (TeacherHabits(unsure=1.0), acts.Unsure()),
        (TeacherHabits(patience=0), acts.Unsure()),
    ],
)
def test_habits_change_answers(habits: TeacherHabits, expected: acts.TeacherAct) -> None:
    pupil = robot()
    teacher = SimulatedTeacher([boil()], pupil.settings, habits=habits)
    tell(pupil, teacher.reply(pupil.turn, pupil.state) or acts.Skip())
    question = acts.GoalPredYnq(Literal(Fluent("hot", ("Water",))))
    turn = replace(pupil.turn, acts=(question,), phase=Phase.EXECUTION)
    assert teacher.reply(turn, pupil.state) == expected
    assert teacher.reply(turn, pupil.state) == expected


def test_rates_are_met_and_seeds_matter() -> None:
    pupil = robot()
    question = replace(
        pupil.turn, acts=(acts.EnvPredYnq(Fluent("hot", ("Water",))),), phase=Phase.EXECUTION
    )
    wrong = 0
    for seed in range(200):
        habits = TeacherHabits(wrong=0.2, seed=seed)
        teacher = SimulatedTeacher([boil()], pupil.settings, given=1, habits=habits)
        wrong += teacher.reply(question, pupil.state) == acts.Yes()
    assert 20 <= wrong <= 60


@pytest.mark.parametrize("rate", [-0.1, 1.1])
def test_a_rate_is_a_probability(rate: float) -> None:
    with pytest.raises(ValueError, match="between 0 and 1"):
        TeacherHabits(wrong=rate)


def test_what_is_meant_may_be_said_in_other_words_than_the_lesson() -> None:
    """A lesson that wants a thing stowed: in the cupboard is part of it, if nothing else is."""
    inside = Literal(Fluent("in", ("Bread_1", "Cupboard_1")))
    steps = ("moveto Cupboard_1", "open Cupboard_1", "moveto Bread_1", "grasp Bread_1")
    stored = ("moveto Cupboard_1", "put-in Bread_1 Cupboard_1")
    lesson = Lesson(
        "stow", "kitchen-1", "put away the bread", "put away", {"the bread": ("Bread_1",)},
        tuple(Action.parse(step) for step in (*steps, *stored)),
        frozenset({Literal(Fluent("stowed", ("Bread_1",)))}),
    )  # fmt: skip
    pupil = robot()
    teacher = SimulatedTeacher([lesson], pupil.settings)
    tell(pupil, teacher.reply(pupil.turn, pupil.state) or acts.Skip())
    question = acts.GoalRelevantYnq(inside)

    def asked(*goal: Literal) -> acts.TeacherAct | None:
        keep = Candidate(acts.IncludeFluent(frozenset(goal)), {})
        decision = Decision((Candidate(question, {}), keep), 0)
        turn = replace(pupil.turn, acts=(question,), phase=Phase.LEARNING, decisions=(decision,))
        return teacher.reply(turn, pupil.state)

    opened = Literal(Fluent("open", ("Cupboard_1",)))
    assert asked(inside, opened) == acts.Yes()
    assert asked(inside, *lesson.goal) == acts.No()
