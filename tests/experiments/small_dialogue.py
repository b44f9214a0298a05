"""A dialogue small enough to compute: three goals, two questions, teachers who err or do not know.

Its trajectories look like those of real sessions (candidates with named-like
features, propensities, prices), and the value of any policy is known exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from verbteach.experiments.off_policy.trajectories import Choice, Log, Trajectory

Floats: TypeAlias = NDArray[np.float64]
History: TypeAlias = tuple[tuple[int, str], ...]
Rule: TypeAlias = Callable[[Floats], Floats]

PRIOR = np.array([0.5, 0.3, 0.2])
ANSWERS = ("yes", "no", "unsure")
CAP = 3
GAMMA = 0.99
PEOPLE = ((0.05, 0.05), (0.1, 0.2), (0.25, 0.1))
"""Kinds of teachers as (error, don't know), each as frequent as the others."""


def likelihood(kind: tuple[float, float], question: int, answer: str) -> Floats:
    """The probability of an answer to "is it goal ``question``?" for each goal."""
    error, unsure = kind
    right = np.where(np.arange(3) == question, "yes", "no") == answer
    sure = np.where(right, 1.0 - error, error) * (1.0 - unsure)
    return np.full(3, unsure) if answer == "unsure" else sure


@cache
def belief(history: History) -> tuple[float, ...]:
    """What the robot, which takes every teacher for the middle one, makes of the answers."""
    found = PRIOR.copy()
    for question, answer in history:
        found = found * likelihood(PEOPLE[1], question, answer)
    return tuple((found / found.sum()).tolist())


@cache
def features(history: History) -> Floats:
    """Candidates x features: two questions while there are any left, then carrying out.

    The same array for the same history: not to be written to.
    """
    now = np.array(belief(history))
    best, asked = float(now.max()), len(history) / CAP
    rows = [[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, best, best * best, asked]]
    if len(history) < CAP:
        rows = [
            [1.0, p, 1 - abs(2 * p - 1), best, asked, 0.0, 0.0, 0.0, 0.0] for p in now[:2]
        ] + rows
    found = np.array(rows)
    found.flags.writeable = False
    return found


@cache
def chances(rule: Rule, history: History) -> Floats:
    """How likely a rule is to take each candidate; the same array for the same history."""
    found = rule(features(history))
    found.flags.writeable = False
    return found


@cache
def answering(kind: tuple[float, float], question: int, goal: int) -> tuple[float, ...]:
    """How likely each of the ``ANSWERS`` is from a teacher of this kind who has this goal."""
    return tuple(float(likelihood(kind, question, answer)[goal]) for answer in ANSWERS)


def softmax(theta: Floats, heat: float) -> Rule:
    """Acts by the exponential of Q / heat."""

    def probabilities(found: Floats) -> Floats:
        values = found @ theta / heat
        grown = np.exp(values - values.max())
        return np.asarray(grown / grown.sum())

    return probabilities


def greedy(theta: Floats, epsilon: float) -> Rule:
    """Takes the best act, or with probability epsilon any."""

    def probabilities(found: Floats) -> Floats:
        spread = np.full(len(found), epsilon / len(found))
        spread[int((found @ theta).argmax())] += 1.0 - epsilon
        return spread

    return probabilities


CURIOUS = np.array([0.4, 0.0, 0.5, -0.3, -0.4, 0.0, 0.0, 0.9, 0.0])
HASTY = np.array([0.1, 0.0, 0.2, -0.1, -0.5, 0.0, 0.5, 0.4, 0.3])


def earned(*, question: bool, good: bool) -> float:
    """The paper's prices, questions four times as dear."""
    if question:
        return -4.0 if good else -8.0
    return 100.0 if good else -2.0


def truth(rule: Rule) -> float:
    """The value of a policy, by going through every dialogue."""
    total = 0.0
    for kind in PEOPLE:
        for goal, chance in enumerate(PRIOR.tolist()):
            total += chance * _value(rule, kind, goal, ()) / len(PEOPLE)
    return total


def _value(rule: Rule, kind: tuple[float, float], goal: int, history: History) -> float:
    *asking, ending = chances(rule, history).tolist()
    right = int(np.argmax(belief(history))) == goal
    value: float = ending * earned(question=False, good=right)
    for question, chance in enumerate(asking):
        for answer, likely in zip(ANSWERS, answering(kind, question, goal), strict=True):
            ahead = _value(rule, kind, goal, (*history, (question, answer)))
            value += chance * likely * (earned(question=True, good=answer == "yes") + GAMMA * ahead)
    return value


@dataclass(frozen=True)
class Sampler:
    """Logs dialogues of ``people``, each of whom teaches ``lessons`` times."""

    logged: Rule
    evaluated: Rule
    people: int
    lessons: int

    def log(self, rng: np.random.Generator, coarse: bool = False) -> Log:
        """One log; ``coarse`` features leave out what the value hangs on."""
        found = []
        for person in range(self.people):
            kind = PEOPLE[int(rng.integers(len(PEOPLE)))]
            for _ in range(self.lessons):
                found.append(self._trajectory(kind, f"p{person}", rng, coarse))
        return Log(tuple(found), GAMMA)

    def _trajectory(
        self, kind: tuple[float, float], name: str, rng: np.random.Generator, coarse: bool
    ) -> Trajectory:
        goal = int(rng.choice(3, p=PRIOR))
        history: History = ()
        choices = []
        while True:
            offered = features(history)
            likely = chances(self.logged, history)
            taken = int(rng.choice(len(likely), p=likely))
            target = chances(self.evaluated, history)
            seen = offered[:, [0, 4, 5]] if coarse else offered
            ends = taken == len(likely) - 1
            if ends:
                right = int(np.argmax(belief(history))) == goal
                reward = earned(question=False, good=right)
            else:
                answer = ANSWERS[int(rng.choice(3, p=answering(kind, taken, goal)))]
                history = (*history, (taken, answer))
                reward = earned(question=True, good=answer == "yes")
            choices.append(Choice(seen, taken, float(likely[taken]), reward, target))
            if ends:
                return Trajectory(tuple(choices), name)
