"""Learning to ask as it is used: lessons taught to a live robot by simulated teachers.

Both phases are learned together, in sessions that begin with nothing known,
with the groundings, the candidates and the judgements of a session with a
person. What the experiments' practice lacks counts here: goals are read back,
and a part of what changed may not belong to them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from verbteach.dialogue import acts
from verbteach.dialogue.acts import RobotAct, TeacherAct
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.simulated import SimulatedTeacher, TeacherHabits, seeded_order
from verbteach.dialogue.turn import RobotTurn
from verbteach.experiments.interactive_training import Trained
from verbteach.experiments.pupil import LivePractice, Pupil
from verbteach.experiments.sight import stream
from verbteach.experiments.simulated_human import HumanParameters
from verbteach.perception.noise import NoiseModel

_MOST_LESSONS = 20
"""Lessons for each dialogue asked for, at most: after so many nothing is carried out at all."""


@dataclass(frozen=True)
class Classroom:
    """Lessons with the scenes that they take place in, and what the teachers are like."""

    lessons: Sequence[Lesson]
    settings: Settings
    human: HumanParameters = field(default_factory=HumanParameters)


@dataclass(frozen=True)
class Practised:
    """What came of it: both phases' learning, and the executions with whether they were right.

    Of ``goals`` read back, ``goals_right`` were right as first read.
    """

    phases: Mapping[str, Trained]
    executions: tuple[tuple[Mapping[str, float], bool], ...]
    goals: int
    goals_right: int


def practise(
    room: Classroom,
    practice: LivePractice,
    noises: Sequence[NoiseModel],
    seed: int,
    heard: Callable[[int], None] = lambda dialogues: None,
) -> Practised:
    """Teach until enough has been practised; the sessions meet the ``noises`` in turn.

    ``heard`` is told how many dialogues the phase has had that has had fewer.
    Raises ``ValueError`` where there are no lessons, or nothing is ever carried out.
    """
    if not room.lessons:
        raise ValueError("there is nothing to practise on")
    pupil = Pupil(practice, stream(seed, "practice"))
    verdicts: list[bool] = []
    for number, lessons in enumerate(_sessions(room.lessons, practice, seed)):
        parameters = RobotParameters(
            seed=int(stream(seed, "practice", number).integers(2**31)),
            noise=noises[number % len(noises)],
        )
        robot = Robot(room.settings, pupil, parameters)
        for turn, act in taught(robot, PractisedTeacher(lessons, room)):
            verdicts += _first_verdict(robot, turn, act)
            if not isinstance(act, acts.Command):
                continue
            pupil.begin()
            heard(min(pupil.dialogues, practice.dialogues))
            if pupil.dialogues >= practice.dialogues:
                return Practised(pupil.trained(), pupil.executions, len(verdicts), sum(verdicts))
    raise ValueError("in practice too little is carried out: other lessons are needed")


def taught(robot: Robot, teacher: SimulatedTeacher) -> Iterator[tuple[RobotTurn, TeacherAct]]:
    """Let the teacher teach; each act with the turn that it answers, before it is received."""
    turn = robot.open(teacher.first_scene)
    while (act := teacher.reply(turn, robot.state)) is not None:
        yield turn, act
        turn = robot.receive(act)


class PractisedTeacher(SimulatedTeacher):
    """A simulated teacher who errs as the people do that answer in training."""

    def __init__(self, lessons: Sequence[Lesson], room: Classroom) -> None:
        super().__init__(lessons, room.settings)
        self._human = room.human

    def habits(self, question: RobotAct) -> TeacherHabits:
        """Those of whoever teaches the lesson, for this kind of question."""
        human = self._human.teaching(self.lesson.id)
        rates = human.rates(question.name)
        return TeacherHabits(rates.error, rates.unsure, human.patience)


def _sessions(
    lessons: Sequence[Lesson], practice: LivePractice, seed: int
) -> Iterator[Sequence[Lesson]]:
    """The lessons in a seeded order, over and over, cut into sessions."""
    order = seeded_order(lessons, _MOST_LESSONS * practice.dialogues, seed)
    for begin in range(0, len(order), practice.session):
        yield order[begin : begin + practice.session]


def _first_verdict(robot: Robot, turn: RobotTurn, act: TeacherAct) -> list[bool]:
    """Whether the goal was right as first read back; nothing where none was judged."""
    episode = robot.state.episode
    if turn.phase is not Phase.READ_BACK or episode is None or episode.read_back is None:
        return []
    judged = isinstance(act, acts.Good | acts.Bad) and not episode.read_back.rejected
    return [isinstance(act, acts.Good)] if judged else []
