"""Policies that ask: the questions of both phases in a live dialogue, answered and taken in."""

from __future__ import annotations

from collections import Counter

import pytest

from tests.dialogue.stage import BOIL, provider, shown, tell
from verbteach.dialogue import acts
from verbteach.dialogue.acts import QUESTIONS, RobotAct
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.moves import ROBOT_MOVES, Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import Policy
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.perception.noise import NoiseModel
from verbteach.policy.fixed_rules import ManualPolicy, RandomPolicy, SplitPolicy
from verbteach.policy.learned_policy import LearnedPolicy
from verbteach.world.fluents import Fluent, Literal, satisfied
from verbteach.world.plan import Action
from verbteach_scenarios.weights import starting_weights

HOT = Literal(Fluent("hot", ("Water",)))


def pupil(policy: Policy, level: str = "perfect", seed: int = 1) -> Robot:
    robot = Robot(provider, policy, RobotParameters(seed, NoiseModel.named(level)))
    robot.open("kitchen-1")
    return robot


def boil(scene: str, burner: int = 1) -> Lesson:
    steps = tuple(Action.parse(s.replace("_1 Burner_1", f"_1 Burner_{burner}")) for s in BOIL)
    names = {"the water": ("Water",)}
    return Lesson("b", scene, "boil the water", "boil", names, steps, frozenset({HOT}))


def rinse(scene: str) -> Lesson:
    steps = ("moveto Mug_2", "grasp Mug_2", "moveto Sink_1", "drop-in Mug_2 Sink_1")
    done = tuple(Action.parse(step) for step in steps)
    goal = frozenset({Literal(Fluent("in", ("Mug_2", "Sink_1")))})
    names = {"the blue mug": ("Mug_2",)}
    return Lesson("r", scene, "rinse the blue mug", "rinse", names, done, goal)


def held(robot: Robot, lessons: tuple[Lesson, ...]) -> Counter[type[RobotAct]]:
    teacher = SimulatedTeacher(lessons, robot.settings)
    asked: Counter[type[RobotAct]] = Counter()
    for _ in range(200):
        act = teacher.reply(robot.turn, robot.state)
        if act is None:
            return asked
        turn = robot.receive(act)
        assert type(turn.waiting_act) in ROBOT_MOVES[turn.phase]
        asked.update(type(one) for one in turn.acts if isinstance(one, QUESTIONS))
    pytest.fail("the dialogue did not end")


def chill(scene: str) -> Lesson:
    steps = ("moveto Fridge_1", "open Fridge_1", "moveto Mug_2", "grasp Mug_2", "moveto Fridge_1")
    done = tuple(Action.parse(step) for step in (*steps, "put-in Mug_2 Fridge_1"))
    goal = frozenset({Literal(Fluent("in", ("Mug_2", "Fridge_1")))})
    names = {"the blue mug": ("Mug_2",)}
    return Lesson("c", scene, "chill the blue mug", "chill", names, done, goal)


@pytest.mark.parametrize("level", ["std3", "uniform"])
def test_under_noise_the_manual_policy_asks_about_change_and_room(level: str) -> None:
    robot = pupil(ManualPolicy(), level)
    asked = held(robot, (boil("kitchen-1"), chill("kitchen-1")) * (6 if level == "uniform" else 2))
    assert asked[acts.PredChangeYnq] > 0
    assert asked[acts.EnvPredYnq] > 0 or level == "std3"
    assert robot.state.totals.questions == sum(asked.values())
    assert robot.state.totals.reward < 1200 - sum(asked.values())


def test_a_goal_question_tells_two_lessons_apart() -> None:
    robot = pupil(SplitPolicy())
    tell(robot, acts.Command("move the blue mug"))
    tell(robot, *shown("moveto Mug_2", "grasp Mug_2", "moveto Table_1", "put-on Mug_2 Table_1"))
    tell(robot, acts.Good(), acts.GoToScene("kitchen-1"), acts.Command("move the blue mug"))
    if robot.turn.phase is not Phase.DEMONSTRATION:
        tell(robot, acts.Show())
    tell(robot, *shown("moveto Mug_2", "grasp Mug_2", "moveto Sink_1", "drop-in Mug_2 Sink_1"))
    turn = tell(robot, acts.Good(), acts.GoToScene("kitchen-1"), acts.Command("move the blue mug"))
    question = turn.waiting_act
    assert isinstance(question, acts.GoalPredYnq)
    wanted = Literal(Fluent("in", ("Mug_2", "Sink_1")))
    answer = acts.Yes() if question.literal == wanted else acts.No()
    while robot.turn.phase is Phase.EXECUTION:
        turn = tell(robot, answer)
        waiting = turn.waiting_act
        sink = isinstance(waiting, acts.GoalPredYnq) and waiting.literal == wanted
        answer = acts.Yes() if sink else acts.No()
    assert robot.turn.phase is Phase.JUDGEMENT
    assert satisfied({wanted}, robot.state.world)


def test_an_unknown_verb_is_still_asked_to_be_shown() -> None:
    turn = tell(pupil(ManualPolicy()), acts.Command("boil the water"))
    assert turn.phase is Phase.DEMONSTRATION


def test_an_answer_about_what_matters_shapes_the_goal_read_back() -> None:
    """Table 1: should I put it on a heat pad? No, you don't have to."""
    robot = pupil(LearnedPolicy.beginning(starting_weights(), frozen=True))
    tell(robot, acts.Command("boil the water"), *shown(*BOIL))
    refused: set[Literal] = set()
    for _ in range(30):
        waiting = robot.turn.waiting_act
        if robot.turn.phase is not Phase.LEARNING:
            break
        if isinstance(waiting, acts.GoalRelevantYnq) and waiting.literal != HOT:
            refused.add(waiting.literal)
            tell(robot, acts.Say("No, you don't have to."))
        else:
            tell(robot, acts.Yes())
    assert robot.turn.phase is Phase.READ_BACK
    included = robot.turn.waiting_act
    assert isinstance(included, acts.IncludeFluent)
    assert refused
    assert not refused & included.goal
    tell(robot, acts.Good())
    assert robot.state.knowledge.verbs == ("boil",)


def test_the_same_seed_holds_the_same_dialogue() -> None:
    digests = set()
    for _ in range(2):
        robot = pupil(RandomPolicy(), "std3", seed=5)
        held(robot, (boil("kitchen-1"), boil("kitchen-1")))
        digests.add(robot.state.digest)
    assert len(digests) == 1
