"""The way through a study: its steps in order, from the instructions to the thanks."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from typing import NamedTuple

from verbteach_sessions.study.design import Lessons, Study
from verbteach_sessions.study.questionnaire import EACH


class Kind(Enum):
    """What a step is."""

    INSTRUCTIONS = "instructions"
    PRACTICE = "practice"
    LESSONS = "lessons"
    QUESTIONNAIRE = "questionnaire"
    THANKS = "thanks"


TEACHING = (Kind.PRACTICE, Kind.LESSONS)
"""The steps in which there is a session."""


class Step(NamedTuple):
    """One step. ``part`` counts the conditions from 1; 0 is before or after all of them."""

    kind: Kind
    condition: str = ""
    part: int = 0


def steps_of(study: Study, order: tuple[str, ...]) -> tuple[Step, ...]:
    """The steps of a participant who meets the conditions in ``order``."""
    return tuple(_steps(study, order))


def lessons_of(study: Study, step: Step) -> Lessons:
    """What is taught in a step of ``TEACHING``."""
    practised = step.kind is Kind.PRACTICE and study.practice is not None
    return study.practice if practised and study.practice else study.lessons


def _steps(study: Study, order: tuple[str, ...]) -> Iterator[Step]:
    each = study.questionnaire.when == EACH
    if study.instructions:
        yield Step(Kind.INSTRUCTIONS)
    if study.practice is not None:
        # Practised is what comes first: another robot would teach other habits.
        yield Step(Kind.PRACTICE, order[0])
    for part, condition in enumerate(order, start=1):
        yield Step(Kind.LESSONS, condition, part)
        if each and study.questionnaire.asks:
            yield Step(Kind.QUESTIONNAIRE, condition, part)
    if not each and study.questionnaire.asks:
        yield Step(Kind.QUESTIONNAIRE)
    yield Step(Kind.THANKS)
