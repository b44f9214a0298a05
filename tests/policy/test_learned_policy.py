"""The policy that learns in live sessions: a Gaussian over weights, exact, recorded, held."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.dialogue.stage import robot, tell
from verbteach.dialogue import acts
from verbteach.dialogue.decision import Candidate
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.policy import LearningPolicy, Taken
from verbteach.dialogue.state import EpisodeState
from verbteach.policy.fixed_rules import ManualPolicy
from verbteach.policy.learned_policy import LearnedPolicy, LiveLearning
from verbteach.policy.learners import BayesianTD, Step
from verbteach.policy.posterior import Posterior
from verbteach_scenarios.weights import starting_weights
from verbteach_sessions.plain_values import from_plain, to_plain

NAMES = ("ask", "gain", "end")
numbers = st.floats(-3, 3, allow_nan=False)
rows = st.fixed_dictionaries(dict.fromkeys(NAMES, numbers))


def posterior(variance: float = 1.0) -> Posterior:
    return Posterior.of(dict.fromkeys(NAMES, 0.0), variance)


def policy(**how: Any) -> LearnedPolicy:
    return LearnedPolicy(posterior(), posterior(), LiveLearning(**how))


def candidates() -> list[Candidate]:
    question = acts.NpGrdWhq("the mug")
    return [
        Candidate(question, {"ask": 1.0, "gain": 0.5}),
        Candidate(acts.IncludeFluent(frozenset()), {"end": 1.0}),
    ]


def episode(phase: Phase = Phase.EXECUTION) -> EpisodeState:
    pupil = robot()
    tell(pupil, acts.Command("boil the water"))
    assert pupil.state.episode is not None
    return replace(pupil.state.episode, phase=phase)


@given(st.lists(st.tuples(rows, numbers), max_size=6))
def test_it_is_the_kalman_learner_of_the_experiments(steps: list[tuple[Any, float]]) -> None:
    """The exact sums agree with the matrix form, which is the oracle here."""
    oracle = BayesianTD(len(NAMES), prior=1.0, noise=0.2)
    found = posterior()
    for features, reward in steps:
        found = found.told(features, reward, 0.2).posterior
        oracle.learn(Step(np.array([features[n] for n in NAMES]), reward, None))
    assert np.allclose(found.mean, oracle.weights, atol=1e-8)
    assert np.allclose(found.covariance, oracle.covariance, atol=1e-8)


@given(rows, numbers)
def test_the_covariance_stays_symmetric_to_the_bit_and_shrinks(seen: Any, reward: float) -> None:
    after = posterior().told(seen, reward, 0.2).posterior
    for i in range(len(NAMES)):
        assert after.covariance[i][i] <= 1.0
        for j in range(len(NAMES)):
            assert after.covariance[i][j] == after.covariance[j][i]


def test_shares_sum_to_the_value() -> None:
    learned = policy().told(Taken("execution", {"ask": 1.0, "gain": 1.0}, 100.0))[0]
    decision = learned.choose(episode(), candidates(), np.random.default_rng(0))
    for one in decision.candidates:
        assert one.value == pytest.approx(sum(one.shares.values()))
    assert decision.weights == learned.digest


def test_a_step_can_be_taken_again_from_its_record_to_the_bit() -> None:
    before = policy(price=4.0)
    taken = Taken("learning", {"ask": 1.0, "gain": 0.3}, -2.0, {"end": 1.0})
    after, record = before.told(taken)
    assert record is not None
    assert before.after(record) == after
    assert record["digest"] == after.digest != before.digest
    assert record["reward"] == pytest.approx(-0.08)
    assert after.execution == before.execution


def test_what_ends_a_phase_has_the_price_that_it_has() -> None:
    _, record = policy(price=4.0).told(Taken("learning", {"end": 1.0}, -2.0))
    assert record is not None
    assert record["reward"] == pytest.approx(-0.02)


def test_a_record_of_something_else_is_refused() -> None:
    with pytest.raises(ValueError, match="no record"):
        policy().after({"phase": "lunch", "seen": {}, "reward": 1.0})


def test_frozen_it_neither_learns_nor_explores() -> None:
    held = replace(policy(exploration=5.0), frozen=True)
    assert held.told(Taken("execution", {"ask": 1.0}, 100.0)) == (held, None)
    for seed in range(20):
        decision = held.choose(episode(), candidates(), np.random.default_rng(seed))
        assert (decision.chosen, decision.propensity, decision.explored) == (0, 1.0, False)


def test_unsure_it_tries_things_and_says_how_likely_that_was() -> None:
    chosen = [0, 0]
    told = 0.0
    for seed in range(300):
        decision = policy(exploration=1.0).choose(
            episode(), candidates(), np.random.default_rng(seed)
        )
        chosen[decision.chosen] += 1
        told += decision.propensity if decision.chosen == 0 else 1.0 - decision.propensity
        assert 0.0 < decision.propensity <= 1.0
    assert min(chosen) > 50
    assert chosen[0] / 300 == pytest.approx(told / 300, abs=0.1)


def test_phases_have_weights_of_their_own() -> None:
    learned = policy(exploration=0.0)
    for _ in range(5):
        learned = learned.told(Taken("learning", {"end": 1.0}, 100.0))[0]
    rng = np.random.default_rng(0)
    assert learned.choose(episode(Phase.LEARNING), candidates(), rng).chosen == 1
    assert learned.choose(episode(Phase.EXECUTION), candidates(), rng).chosen == 0


def test_a_feature_it_has_no_weight_for_counts_nothing() -> None:
    """Weights of an earlier version meet the features of a later one."""
    learned, record = policy().told(Taken("execution", {"new": 2.0, "end": 1.0}, 100.0))
    assert record is not None
    assert set(record["weights"]) == set(NAMES)
    assert learned.execution.shares({"new": 3.0}) == {"new": 0.0}


def test_it_travels_as_plain_values() -> None:
    learned = policy().told(Taken("execution", {"ask": 0.1}, 33.3))[0]
    assert from_plain(LearnedPolicy, to_plain(learned)) == learned


def test_it_begins_with_the_weights_that_come_along() -> None:
    begun = LearnedPolicy.beginning(starting_weights())
    assert dict(begun.execution.weights) == starting_weights().execution.to_json()
    trained, learning = starting_weights().learning.to_json(), begun.learning.weights
    differ = {name for name, weight in learning.items() if trained[name] != weight}
    assert all(trained[name] == 0.0 for name in differ)
    assert learning["goal_relevant_ynq"] != 0.0
    assert isinstance(begun, LearningPolicy)
    assert not isinstance(ManualPolicy(), LearningPolicy)


@pytest.mark.parametrize("wrong", [("a", "a"), ("a",)])
def test_a_posterior_has_a_row_for_each_feature(wrong: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match="feature"):
        Posterior(wrong, (0.0, 0.0), ((1.0, 0.0), (0.0, 1.0)))
