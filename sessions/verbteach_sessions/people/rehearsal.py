"""Sessions in memory: a policy taught by a simulated person, nothing written down."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from verbteach.dialogue import acts
from verbteach.dialogue.acts import QUESTIONS
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.dialogue.teacher import Teacher
from verbteach_sessions.method import Method
from verbteach_sessions.people.fitted_user import FittedUser
from verbteach_sessions.people.golds import LessonBook
from verbteach_sessions.people.habitual import HabitualTeacher
from verbteach_sessions.people.meeting import Meeting, Met, compare, met_in
from verbteach_sessions.people.observations import observe
from verbteach_sessions.people.recorded import Recorded
from verbteach_sessions.people.recorded_lessons import Taught, taught

FEWEST = 4
"""People in all: half are fitted, half are compared, and one alone is no comparison."""

Records = Sequence[Mapping[str, Any]]


def rehearse(
    method: Method,
    lessons: Sequence[Lesson],
    teacher: Teacher,
    settings: Settings,
    person: str,
    before: Records = (),
) -> Iterator[Met]:
    """Let ``teacher`` teach a robot that has learned ``before``; the episodes as they end."""
    robot = method.robot(settings, before)
    robot.open(lessons[0].scene)
    questions: Counter[str] = Counter()
    turns, earned = 0, 0.0
    while (act := teacher.reply(robot.turn, robot.state)) is not None:
        waiting = robot.turn.waiting_act
        if isinstance(waiting, QUESTIONS):
            questions[waiting.name] += 1
        robot.receive(act)
        turns, earned = turns + 1, earned + robot.turn.reward
        outcome = _closed(robot)
        if outcome is not None:
            counts = dict(sorted(questions.items()))
            yield Met(person, counts, turns, earned, outcome is acts.Outcome.EXECUTED)
            questions, turns, earned = Counter(), 0, 0.0


def _closed(robot: Robot) -> acts.Outcome | None:
    closed = [act.outcome for act in robot.turn.acts if isinstance(act, acts.CloseEpisode)]
    return closed[0] if closed else None


def meet(
    records: Sequence[Recorded],
    book: LessonBook,
    settings: Settings,
    rng: np.random.Generator,
    heard: Callable[[int, int], None] | None = None,
) -> Meeting:
    """Fit half of the people, and hold the other half's sessions again with their simulator.

    The policies, the lessons and the noise are those of the records; who
    teaches is drawn from the fitted population, one for each session. ``heard``
    is told how many sessions are done, and of how many. Raises
    ``FittedUserError`` and ``ValueError`` where there are too few people.
    """
    known, others = _halves(records, rng)
    user = FittedUser.of([one for record in known for one in observe(record, book, settings)])
    real: list[Met] = []
    simulated: list[Met] = []
    for number, record in enumerate(others, start=1):
        commands = list(taught(record, book, settings))
        real += [one for command in commands for one in met_in(record.person, command.episodes)]
        simulated += _again(record, commands, user, settings, rng)
        if heard is not None:
            heard(number, len(others))
    return compare(real, simulated, rng)


def _halves(
    records: Sequence[Recorded], rng: np.random.Generator
) -> tuple[list[Recorded], list[Recorded]]:
    people = sorted({one.person for one in records})
    if len(people) < FEWEST:
        raise ValueError(f"comparing needs {FEWEST} people at least")
    order = rng.permutation(len(people)).tolist()
    known = {people[i] for i in order[: len(people) // 2]}
    return (
        [one for one in records if one.person in known],
        [one for one in records if one.person not in known],
    )


def _again(
    record: Recorded,
    commands: Sequence[Taught],
    user: FittedUser,
    settings: Settings,
    rng: np.random.Generator,
) -> Iterator[Met]:
    if not commands:
        return
    lessons = [one.lesson for one in commands]
    method = record.header.method
    seed = int(rng.integers(2**31))
    method = replace(method, parameters=replace(method.parameters, seed=seed))
    knowing = SimulatedTeacher(lessons, settings)
    teacher = HabitualTeacher(knowing, user.population.person(rng), settings, seed)
    before = record.header.learned_before
    yield from rehearse(method, lessons, teacher, settings, record.person, before)
