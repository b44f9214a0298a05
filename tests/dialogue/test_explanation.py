"""Why do you ask? Told with the numbers that chose: they add up, and answers do what was said."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from tests.dialogue.stage import BOIL, provider, shown, tell
from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.policy import Policy
from verbteach.dialogue.robot import Robot
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy
from verbteach.policy.fixed_rules import SplitPolicy
from verbteach.policy.learned_policy import LearnedPolicy
from verbteach.policy.linear import Weights
from verbteach_scenarios.weights import starting_weights

SUM = re.compile(r"Q (-?\d+\.\d\d) = ((?:[+-]\d+\.\d\d [\w.]+ ?)+)\)")
TABLE = ("moveto Table_1", "put-on Mug_2 Table_1")
SINK = ("moveto Sink_1", "drop-in Mug_2 Sink_1")
MOVED = ("moveto Mug_2", "grasp Mug_2")


def opened(policy: Policy) -> Robot:
    robot = Robot(provider, policy)
    robot.open("kitchen-1")
    return robot


def learned() -> Robot:
    return opened(LearnedPolicy.beginning(starting_weights(), frozen=True))


def told_two_ways(robot: Robot) -> Robot:
    """A robot that was shown two ends of moving a mug, and is told to move it."""
    for end in (TABLE, SINK):
        tell(robot, acts.GoToScene("kitchen-1"), acts.Command("move the blue mug"))
        if robot.turn.phase is not Phase.DEMONSTRATION:
            tell(robot, acts.Show())
        tell(robot, *shown(*MOVED, *end))
        while robot.turn.phase is Phase.LEARNING:
            tell(robot, acts.Yes())
        tell(robot, acts.Good())
    tell(robot, acts.GoToScene("kitchen-1"), acts.Command("move the blue mug"))
    return robot


def test_the_parts_of_each_value_add_up() -> None:
    robot = learned()
    tell(robot, acts.Command("boil the water"), *shown(*BOIL))
    sums = SUM.findall(robot.explain()[1])
    assert 1 <= len(sums) <= 3
    for value, parts in sums:
        total = sum(float(part) for part in re.findall(r"[+-]\d+\.\d\d", parts))
        assert float(value) == pytest.approx(total, abs=0.025)


def test_a_question_about_a_change_says_what_is_unsure_and_what_answers_do() -> None:
    robot = learned()
    tell(robot, acts.Command("boil the water"), *shown(*BOIL))
    assert isinstance(robot.turn.waiting_act, acts.GoalRelevantYnq)
    unsure, weighed, answers = robot.explain()
    assert "but not whether you wanted that" in unsure
    assert "read back a goal of 2 parts" in weighed
    assert answers == "A yes keeps it in what I read back to you; a no leaves it out."


def test_a_question_about_a_goal_says_what_it_would_do_after_either_answer() -> None:
    robot = told_two_ways(opened(SplitPolicy()))
    question = robot.turn.waiting_act
    assert isinstance(question, acts.GoalPredYnq)
    unsure, weighed, answers = robot.explain()
    assert re.search(r"I expect a yes at \d+%", unsure)
    assert weighed.startswith("I weighed: ask whether the blue mug should be ")
    assert answers.startswith("My best guess now: ")
    assert "A yes " in answers
    assert "a no " in answers
    place = "in the sink" if "Sink" in str(question.literal) else "on the table"
    other = "on the table" if "sink" in place else "in the sink"
    yes, no = answers.split("A yes ", 1)[1].split("; a no ", 1)
    assert place in yes or "leaves it so" in yes
    assert other in no or "leaves it so" in no


def test_explaining_changes_nothing() -> None:
    robot = opened(SplitPolicy())
    told_two_ways(robot)
    before = robot.state
    assert robot.explain() == robot.explain()
    assert robot.state is before


def test_what_was_not_chosen_is_not_explained() -> None:
    robot = opened(DemonstrationOnlyPolicy())
    assert robot.explain() == ("I did not have to choose: this is what comes next.",)


def test_other_weights_are_told_with_other_numbers() -> None:
    trained = starting_weights()
    less = Weights(trained.learning.space, tuple(w / 2 for w in trained.learning.values))
    told = []
    for weights in (trained, replace(trained, learning=less)):
        robot = opened(LearnedPolicy.beginning(weights, frozen=True))
        tell(robot, acts.Command("boil the water"), *shown(*BOIL))
        told.append(robot.explain()[1])
    assert told[0] != told[1]
