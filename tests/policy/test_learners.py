"""Learners are judged on a chain with a known solution, and against each other."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pytest

from verbteach.experiments.interactive_training import LEARNERS
from verbteach.policy.learners import (
    BayesianTD,
    Floats,
    Learner,
    Sarsa,
    Step,
    TrueOnlineSarsa,
    lspi,
)

STATES = 4
GAMMA = 0.9
SIZE = 2 * STATES


def phi(state: int, act: int) -> Floats:
    found = np.zeros(SIZE)
    found[2 * state + act] = 1.0
    return found


def episode(choose: Callable[[int], int]) -> list[tuple[int, int, float]]:
    """Act 1 walks on, act 0 stops with what the state is worth: -0.1 a step, 1 at the end."""
    state, found = 0, []
    while True:
        act = choose(state)
        if act == 0 or state == STATES - 1:
            found.append((state, act, 1.0 if state == STATES - 1 else 0.2))
            return found
        found.append((state, act, -0.1))
        state += 1


def solution() -> Floats:
    """The values of the best policy, by going through the chain backwards."""
    values = np.zeros(SIZE)
    ahead = 0.0
    for state in reversed(range(STATES)):
        last = state == STATES - 1
        values[2 * state] = 1.0 if last else 0.2
        values[2 * state + 1] = 1.0 if last else -0.1 + GAMMA * ahead
        ahead = max(values[2 * state], values[2 * state + 1])
    return values


def steps(rows: list[tuple[int, int, float]]) -> list[Step]:
    found = []
    for place, (state, act, reward) in enumerate(rows):
        if place + 1 == len(rows):
            found.append(Step(phi(state, act), reward, None))
        else:
            after, following, _ = rows[place + 1]
            both = np.stack([phi(after, 0), phi(after, 1)])
            found.append(Step(phi(state, act), reward, both, following))
    return found


def taught(learner: Learner, dialogues: int, warm: int) -> list[Step]:
    rng = np.random.default_rng(0)
    log: list[Step] = []
    for number in range(dialogues):
        weights = learner.acting(rng)

        def choose(state: int, weights: Floats = weights, exploring: bool = number < warm) -> int:
            if exploring or rng.random() < 0.2:
                return int(rng.integers(2))
            return int(weights[2 * state + 1] > weights[2 * state])

        learner.begin()
        for step in steps(episode(choose)):
            learner.learn(step)
            log.append(step)
    return log


QUICK: Mapping[str, Callable[[], Learner]] = {
    "sarsa": lambda: Sarsa(SIZE, GAMMA, 0.1),
    "true-online": lambda: TrueOnlineSarsa(SIZE, GAMMA, 0.2),
    "bayesian": lambda: BayesianTD(SIZE, GAMMA),
}
"""Each learner at a rate for so small a chain."""


@pytest.mark.parametrize("name", LEARNERS)
def test_each_learner_finds_the_way_to_the_end(name: str) -> None:
    learner = QUICK[name]()
    assert type(learner) is LEARNERS[name]
    taught(learner, 600, 300)
    for state in range(STATES - 1):
        assert learner.weights[2 * state + 1] > learner.weights[2 * state]


def test_lspi_solves_the_chain_from_a_log_of_random_acts() -> None:
    log = taught(Sarsa(SIZE, GAMMA), 400, 400)
    assert lspi(log, SIZE, GAMMA, ridge=1e-6) == pytest.approx(solution(), abs=1e-3)


def test_true_online_without_a_trace_is_sarsa() -> None:
    plain, traced = Sarsa(SIZE, GAMMA, 0.05), TrueOnlineSarsa(SIZE, GAMMA, 0.05, decay=0.0)
    taught(plain, 50, 50)
    taught(traced, 50, 50)
    assert plain.weights == pytest.approx(traced.weights)


def test_sarsa_makes_the_step_of_algorithm_1() -> None:
    learner = Sarsa(2, gamma=0.99, rate=0.01)
    learner.weights = np.array([0.5, 1.0])
    learner.learn(Step(np.array([1.0, 0.0]), -1.0, np.array([[0.0, 1.0]])))
    assert learner.weights == pytest.approx([0.5 + 0.01 * (-1.0 + 0.99 - 0.5), 1.0])


def test_the_bayesian_learner_grows_sure() -> None:
    learner = BayesianTD(SIZE, GAMMA)
    before = np.trace(learner.covariance)
    taught(learner, 100, 100)
    assert np.trace(learner.covariance) < before / 2
    rng = np.random.default_rng(1)
    assert not np.array_equal(learner.acting(rng), learner.acting(rng))
