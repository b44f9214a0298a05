"""The small example corpus of these tests, and answers made up by the rates that a test names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from verbteach.dialogue.setting import Settings
from verbteach_scenarios.lessons import load_lessons
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.example import ExampleParameters
from verbteach_sessions.people.golds import LessonBook
from verbteach_sessions.people.observations import GAVE_UP, NO, UNSURE, YES, Observed
from verbteach_sessions.people.recorded import Recorded, read_recorded

SMALL = ExampleParameters(sessions=4, lessons=4, seed=4)


@cache
def settings() -> Settings:
    """The bundled scenes, ready."""
    return make_settings()


@cache
def book() -> LessonBook:
    """The bundled lessons."""
    return LessonBook.of(load_lessons())


def read_all(paths: Sequence[Path]) -> tuple[Recorded, ...]:
    """The sessions, read."""
    return tuple(read_recorded(path, settings()) for path in paths)


def answer(
    person: str = "p",
    question: str = "goal_pred_ynq",
    given: str = YES,
    truth: bool | None = True,
    asked: int = 0,
    words: str = "",
) -> Observed:
    """One answer."""
    right = None if truth is None or given not in (YES, NO) else truth == (given == YES)
    return Observed(person, "s", 0, question, asked, given, right, truth, words, bool(words))


def answers_of(
    person: str,
    rates: Mapping[str, float],
    count: int,
    rng: np.random.Generator,
    question: str = "goal_pred_ynq",
) -> list[Observed]:
    """Answers of somebody who gives up, is unsure and errs at these rates."""
    found = []
    for _ in range(count):
        truth = bool(rng.random() < 0.4)
        gives_up, unsure, wrong = rng.random(3)
        if gives_up < rates.get("gives_up", 0.0):
            given = GAVE_UP
        elif unsure < rates.get("unsure", 0.0):
            given = UNSURE
        else:
            given = YES if truth != (wrong < rates.get("error", 0.0)) else NO
        found.append(answer(person, question, given, truth))
    return found
