"""The courses of commands in live sessions: what the robot would do, by how sure it has to be.

A simulated teacher teaches a robot that makes no promise, lesson by lesson, as
a person would. Whenever it takes up a command, the same robot is also followed
through what it would ask and do if it had to be surer; then the session goes on
as if nobody had looked.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from verbteach.dialogue import acts
from verbteach.dialogue.acts import RobotAct, TeacherAct
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.policy import Policy
from verbteach.dialogue.promise import Promise, Sureness
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach.experiments.live_practice import Classroom, PractisedTeacher, taught
from verbteach.policy.courses import Course, Outcome


class _Gone(NamedTuple):
    """A turn and the state after it."""

    turn: RobotTurn
    state: RobotState


@dataclass(frozen=True)
class _Room:
    """A teacher and the same robot twice: one that makes no promise, one that is never sure."""

    teacher: SimulatedTeacher
    sureness: Sureness
    willing: Robot
    unwilling: Robot

    def go(self, state: RobotState, act: TeacherAct, *, sure: bool) -> _Gone:
        """What comes of the teacher's act; answers go on until something is chosen."""
        robot = self.willing if sure else self.unwilling
        robot.state = state
        turn = robot.receive(act)
        while turn.phase is Phase.EXECUTION and not turn.decisions:
            turn = robot.receive(self.reply(turn, robot.state))
        return _Gone(turn, robot.state)

    def reply(self, turn: RobotTurn, state: RobotState) -> TeacherAct:
        """The teacher's, who has one to every turn within a command."""
        act = self.teacher.reply(turn, state)
        if act is None:
            raise RuntimeError("the teacher has left in the middle of a command")
        return act


@dataclass(frozen=True)
class LiveMoment:
    """The robot in ``state`` has been told ``act`` and is about to choose."""

    room: _Room
    state: RobotState
    act: TeacherAct

    @property
    def sure(self) -> float:
        """How sure the robot is of the goal that it would carry out."""
        decisions = self._willing.turn.decisions
        return (self.room.sureness.now(decisions[-1].candidates) or 0.0) if decisions else 0.0

    def choice(self, *, sure: bool) -> RobotAct:
        """What the policy chooses; where nothing is left to choose, what is said."""
        turn = self._gone(sure=sure).turn
        return turn.decisions[-1].act if turn.decisions else turn.waiting_act

    def after(self, *, sure: bool) -> LiveMoment | Outcome:
        """What that leads to."""
        turn, state = self._gone(sure=sure)
        if turn.phase is Phase.EXECUTION:
            return LiveMoment(self.room, state, self.room.reply(turn, state))
        if turn.phase is not Phase.JUDGEMENT:
            return Outcome.SHOWN
        good = isinstance(self.room.reply(turn, state), acts.Good)
        return Outcome.RIGHT if good else Outcome.WRONG

    @property
    def weighs_acting(self) -> bool:
        """Whether the robot weighs, or asks what it must know to weigh, carrying something out."""
        return self._willing.turn.phase in {Phase.EXECUTION, Phase.JUDGEMENT}

    def _gone(self, *, sure: bool) -> _Gone:
        return self._willing if sure else self._unwilling

    @cached_property
    def _willing(self) -> _Gone:
        return self.room.go(self.state, self.act, sure=True)

    @cached_property
    def _unwilling(self) -> _Gone:
        return self.room.go(self.state, self.act, sure=False)


def live_courses(
    policy: Policy,
    sureness: Sureness,
    parameters: RobotParameters,
    room: Classroom,
    heard: Callable[[int], None] = lambda given: None,
) -> Iterator[tuple[str, Course]]:
    """Teach the lessons in one session; each command that could be carried out, with its scene.

    Commands of verbs that nobody has shown yet have no course. ``heard`` is told
    how many lessons have been given, whenever one begins.
    """
    surest = Promise(rate=0.5, sure=1.0, lessons=1, sureness=sureness)
    robot, never = (
        Robot(room.settings, policy, parameters, promise=promise) for promise in (None, surest)
    )
    teacher = PractisedTeacher(room.lessons, room)
    never.open(teacher.first_scene)
    for _, act in taught(robot, teacher):
        if not isinstance(act, acts.Command):
            continue
        heard(teacher.given)
        state = robot.state
        moment = LiveMoment(_Room(teacher, sureness, robot, never), state, act)
        if moment.weighs_acting:
            yield state.scene, Course.of(moment)
        robot.state = state
