"""Answers that cannot both be right are noticed, and asked about once more."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.dialogue.stage import provider, tell
from verbteach.dialogue import acts
from verbteach.dialogue.contradictions import CONTRADICTORY, WITHDRAWN
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.state import Exchange
from verbteach.policy.fixed_rules import ManualPolicy
from verbteach.world.fluents import Fluent, Literal

ON_TABLE = Fluent("on", ("Mug_2", "Table_1"))
IN_SINK = Fluent("in", ("Mug_2", "Sink_1"))


def asked(earlier: Exchange, question: acts.RobotAct, phase: Phase = Phase.EXECUTION) -> Robot:
    """A robot that waits for an answer to ``question``, after ``earlier``."""
    robot = Robot(provider, ManualPolicy())
    robot.open("kitchen-1")
    tell(robot, acts.Command("move the blue mug"))
    episode = robot.state.episode
    assert episode is not None
    episode = replace(episode, phase=phase, question=question, asked=(earlier,))
    turn = replace(robot.turn, acts=(question,), phase=phase)
    robot.state = replace(robot.state, episode=episode, turn=turn)
    return robot


def exchanges(robot: Robot) -> tuple[Exchange, ...]:
    assert robot.state.episode is not None
    return robot.state.episode.asked


PAIRS: dict[str, tuple[Exchange, acts.RobotAct, acts.TeacherAct]] = {
    "two places": (
        Exchange(acts.EnvPredYnq(ON_TABLE), "yes"),
        acts.EnvPredYnq(IN_SINK),
        acts.Yes(),
    ),
    "wanted in two places": (
        Exchange(acts.GoalPredYnq(Literal(ON_TABLE)), "yes"),
        acts.GoalPredYnq(Literal(IN_SINK)),
        acts.Yes(),
    ),
    "wanted and not": (
        Exchange(acts.GoalPredYnq(Literal(ON_TABLE)), "yes"),
        acts.GoalPredYnq(Literal(ON_TABLE, False)),
        acts.Yes(),
    ),
    "denied, then pointed at": (
        Exchange(acts.NpGrdYnq("the blue mug", "Mug_2"), "no"),
        acts.NpGrdWhq("the blue mug"),
        acts.Point("Mug_2"),
    ),
}


@pytest.mark.parametrize("name", PAIRS)
def test_a_contradiction_is_asked_about_once_more_and_the_second_answer_counts(name: str) -> None:
    earlier, question, answer = PAIRS[name]
    robot = asked(earlier, question)
    turn = tell(robot, answer)
    assert [type(act) for act in turn.acts] == [acts.AskAgain, type(question)]
    assert turn.texts[0].startswith("Before, you said that ")
    assert turn.reward == 0.0
    assert exchanges(robot) == (earlier, Exchange(question, CONTRADICTORY))
    questions = robot.state.totals.questions
    tell(robot, answer)
    assert exchanges(robot)[0] == Exchange(earlier.question, WITHDRAWN)
    assert exchanges(robot)[-1].question == question
    assert robot.state.totals.questions == questions


def test_the_teacher_may_think_better_of_it() -> None:
    earlier, question, answer = PAIRS["two places"]
    robot = asked(earlier, question)
    tell(robot, answer, acts.No())
    assert exchanges(robot)[0] == earlier
    assert exchanges(robot)[-1] == Exchange(question, "no")


@pytest.mark.parametrize("answer", [acts.No(), acts.Unsure()])
def test_what_goes_together_is_taken_in_at_once(answer: acts.TeacherAct) -> None:
    earlier, question, _ = PAIRS["two places"]
    robot = asked(earlier, question)
    turn = tell(robot, answer)
    assert acts.AskAgain not in {type(act) for act in turn.acts}


def test_a_change_that_did_not_happen_is_no_part_of_the_goal() -> None:
    hot = Literal(Fluent("hot", ("Kettle_1",)))
    earlier = Exchange(acts.PredChangeYnq(hot), "no")
    robot = asked(earlier, acts.GoalRelevantYnq(hot), Phase.LEARNING)
    turn = tell(robot, acts.Yes())
    assert "it did not come to be that the kettle is hot" in turn.texts[0]
