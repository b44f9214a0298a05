"""Off-policy estimates: right where the truth can be computed, and silent where they cannot be."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.experiments.small_dialogue import (
    CURIOUS,
    HASTY,
    Floats,
    Rule,
    Sampler,
    greedy,
    softmax,
    truth,
)
from verbteach.experiments.off_policy.estimators import estimators
from verbteach.experiments.off_policy.evaluation import UnsupportedLogError, evaluate
from verbteach.experiments.off_policy.trajectories import Choice, Log, Trajectory

LOGGED, EVALUATED = softmax(CURIOUS, 0.5), greedy(HASTY, 0.3)


def rng(*seed: int) -> np.random.Generator:
    return np.random.default_rng(list(seed))


def sampled(logged: Rule, evaluated: Rule, people: int = 40, lessons: int = 10) -> Log:
    return Sampler(logged, evaluated, people, lessons).log(rng(people, lessons))


def test_with_many_trajectories_all_three_come_to_the_truth() -> None:
    log = sampled(LOGGED, EVALUATED, 300, 10)
    right = truth(EVALUATED)
    assert abs(right - truth(LOGGED)) > 5.0  # the log's own mean would not do
    for one in estimators(log):
        assert one(np.ones(len(log))).value == pytest.approx(right, abs=3.0), one.name


def test_a_policy_evaluated_on_its_own_log_gets_the_mean_return() -> None:
    log = sampled(LOGGED, LOGGED)
    weighted, _, robust = estimators(log)
    assert log.effective_size == pytest.approx(len(log))
    assert log.mean_weight == pytest.approx(1.0)
    assert weighted(np.ones(len(log))).value == pytest.approx(log.returns.mean())
    assert robust(np.ones(len(log))).value == pytest.approx(log.returns.mean(), abs=1.0)


def test_influences_add_up_to_nothing_and_foretell_what_leaving_one_out_does() -> None:
    log = sampled(LOGGED, EVALUATED)
    every = np.ones(len(log))
    for one in estimators(log):
        valued = one(every)
        assert valued.influence.mean() == pytest.approx(0.0, abs=0.1)  # the ridge
        heaviest = int(np.abs(valued.influence).argmax())
        without = every.copy()
        without[heaviest] = 0.0
        moved = valued.value - one(without).value
        assert moved == pytest.approx(valued.influence[heaviest] / len(log), rel=0.35)


def test_counting_a_trajectory_twice_is_having_it_twice() -> None:
    log = sampled(LOGGED, EVALUATED, 20, 2)
    twice = Log((*log.trajectories, log.trajectories[3]), log.gamma)
    counts = np.ones(len(log))
    counts[3] = 2.0
    for one, other in zip(estimators(log)[:2], estimators(twice)[:2], strict=True):
        assert one(counts).value == pytest.approx(other(np.ones(len(twice))).value)


def test_too_small_an_effective_sample_is_declined() -> None:
    far = sampled(softmax(CURIOUS, 1e9), greedy(CURIOUS, 0.0), 60, 1)
    found = evaluate(far, rng(0))
    assert found.effective_size < 30.0
    assert found.estimates == ()
    assert "too differently" in found.declined
    assert found.to_json()["declined"] == found.declined
    assert evaluate(far, rng(0), minimum=0.1, resamples=50).estimates


def test_a_handful_of_dialogues_is_said_to_be_too_few() -> None:
    found = evaluate(sampled(LOGGED, EVALUATED, 5, 1), rng(0))
    assert found.declined.startswith("5 dialogues are too few")
    assert found.estimates == ()


def test_a_log_of_a_policy_that_never_explores_is_refused_with_the_reason() -> None:
    certain = greedy(CURIOUS, 0.0)
    with pytest.raises(UnsupportedLogError, match=r"in \d+% of its dialogues .* never does"):
        evaluate(sampled(certain, EVALUATED), rng(0))
    assert evaluate(sampled(certain, certain), rng(0), resamples=50).estimates  # its own is fine


@pytest.mark.parametrize("propensity", [0.0, -0.5, 1.5, float("nan")])
def test_a_propensity_that_is_no_probability_is_refused(propensity: float) -> None:
    log = sampled(LOGGED, EVALUATED, 3, 1)
    first, *others = log.trajectories
    wrong = replace(first, choices=(replace(first.choices[0], propensity=propensity),))
    with pytest.raises(UnsupportedLogError, match="propensity"):
        evaluate(Log((wrong, *others), log.gamma), rng(0))


def test_an_empty_log_is_refused() -> None:
    with pytest.raises(UnsupportedLogError, match="no choice"):
        evaluate(Log(()), rng(0))


def test_the_interval_resamples_people_and_not_their_dialogues() -> None:
    log = sampled(LOGGED, EVALUATED, 8, 50)
    nameless = Log(tuple(replace(one, group="") for one in log.trajectories), log.gamma)
    apart, together = (evaluate(one, rng(1), resamples=100) for one in (nameless, log))
    assert together.groups == 8
    assert apart.groups == len(log)
    assert together.effective_size == apart.effective_size
    # Each of these eight people errs in their own way, so there is less to know.
    assert [e.value for e in together.estimates[:2]] == [e.value for e in apart.estimates[:2]]
    assert together.estimates[0].error != apart.estimates[0].error


def test_what_was_never_risked_is_measured_by_how_often_it_would_be_reached() -> None:
    def choice(propensity: float, target: Floats) -> Choice:
        return Choice(np.eye(2), 0, propensity, 1.0, target)

    sure, split = np.array([1.0, 0.0]), np.array([0.25, 0.75])
    log = Log((Trajectory((choice(0.5, split), choice(1.0, split))),))
    assert log.outside == pytest.approx(
        0.5 * 0.75
    )  # half as likely to get there, then 3 in 4 leave
    assert Log((Trajectory((choice(0.5, split), choice(1.0, sure))),)).outside == 0.0


@pytest.mark.slow
@pytest.mark.parametrize(("people", "lessons", "coarse"), [(200, 1, False), (40, 10, True)])
def test_intervals_hold_the_truth_in_nine_of_ten_of_200_logs(
    people: int, lessons: int, coarse: bool
) -> None:
    right = truth(EVALUATED)
    sampler = Sampler(LOGGED, EVALUATED, people, lessons)
    held: dict[str, int] = {}
    for number in range(200):
        log = sampler.log(rng(number, people), coarse)
        found = evaluate(log, rng(number), resamples=200)
        for one in found.estimates:
            low, high = one.ci95
            held[one.name] = held.get(one.name, 0) + (low <= right <= high)
    print(f"{people} x {lessons}, coarse {coarse}: of 200 intervals held the truth {held}")
    assert len(held) == 3
    assert min(held.values()) >= 180
