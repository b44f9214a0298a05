"""What planners are asked in the benchmark: a state and a goal in a grounded task."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Settings
from verbteach.experiments.gold import whole_change
from verbteach.world.fluents import Goal, State
from verbteach.world.task import Task
from verbteach_scenarios.pddl import domain_text, problem_text
from verbteach_scenarios.tell_me_dave.corpus import read_corpus
from verbteach_scenarios.tell_me_dave.instances import instances
from verbteach_scenarios.tell_me_dave.rooms import Rooms

T = TypeVar("T")


@dataclass(frozen=True)
class Question:
    """How to get from ``state`` to ``goal``. ``task`` is shared by questions about one room."""

    task: Task
    state: State
    goal: Goal

    def pddl(self) -> tuple[str, str]:
        """The domain and the problem, as other planners read them."""
        domain = self.task.domain
        problem = problem_text("question", domain, self.task.objects, self.state, self.goal)
        return domain_text(domain), problem


def of_lessons(lessons: Sequence[Lesson], settings: Settings) -> Iterator[Question]:
    """Every lesson's goal, from its scene as it is found."""
    for lesson in lessons:
        setting = settings(lesson.scene)
        yield Question(setting.task, setting.scene.initial, lesson.goal)


def of_corpus(folder: Path) -> Iterator[Question]:
    """Every instance's whole change, from where it started. Raises ``CorpusError``."""
    corpus = read_corpus(folder)
    rooms = Rooms.of(corpus)
    for found in instances(corpus, rooms=rooms):
        task = rooms.task(found.instance.task_key)
        goal = whole_change(found.instance, task).literals
        if goal:
            yield Question(task, found.instance.start, goal)


def spread(questions: Sequence[T], count: int) -> list[T]:
    """At most ``count`` of them, evenly spread over the whole list."""
    if len(questions) <= count:
        return list(questions)
    return [questions[index * len(questions) // count] for index in range(count)]
