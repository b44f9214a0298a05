"""Practice and calibration with a live robot, on few lessons."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from verbteach.experiments.live_practice import Classroom, Practised, practise
from verbteach.experiments.policy_training import Schooling, totals, train_live
from verbteach.experiments.promise_calibration import CalibrationPlan, calibrated
from verbteach.experiments.pupil import LivePractice
from verbteach.perception.noise import NoiseModel
from verbteach.policy.courses import Outcome
from verbteach.policy.sureness import FEATURES, fitted
from verbteach.policy.weights_file import PolicyWeights
from verbteach_scenarios.lessons import load_lessons
from verbteach_scenarios.settings import make_settings

PRACTICE = LivePractice(dialogues=3, warm=2, session=8)


@cache
def room() -> Classroom:
    """Lessons of one verb, so that it is soon carried out."""
    found = [one for one in load_lessons() if one.verb == "turn on" and one.scene == "kitchen-1"]
    return Classroom(tuple(found[:4]), make_settings())


@cache
def practised(seed: int) -> Practised:
    return practise(room(), PRACTICE, [NoiseModel.named("perfect", "literal")], seed)


def test_both_phases_are_practised_and_executions_are_kept() -> None:
    found = practised(1)
    assert set(found.phases) == {"execution", "learning"}
    assert all(len(phase.returns) >= PRACTICE.dialogues for phase in found.phases.values())
    assert all(any(phase.weights.values) for phase in found.phases.values())
    assert found.executions
    assert all("select_hypo" in features for features, _ in found.executions)
    assert 0 <= found.goals_right <= found.goals


def test_equal_seeds_practise_alike() -> None:
    again = practise(room(), PRACTICE, [NoiseModel.named("perfect", "literal")], 1)
    assert again == practised(1)


def test_what_is_practised_is_calibrated_as_a_file_can_hold() -> None:
    schooling = Schooling(noises=("perfect",))
    weights, sureness = train_live(room(), schooling, PRACTICE, "few lessons")
    assert totals(weights)["episodes"] >= 6
    plan = CalibrationPlan(policies=("rl", "split"), noises=("perfect",), lessons=4)
    told: list[tuple[int, int]] = []
    found = calibrated(weights, sureness, room(), plan, lambda *done: told.append(done))
    assert [one.kind for one in found.each] == [
        "rl at perfect (literal)",
        "split at perfect (literal)",
    ]
    assert told[-1] == (8, 8)
    courses = [course for one in found.each for course in one.courses]
    assert any(course.at(0.0).outcome is not Outcome.SHOWN for course in courses)
    whole = replace(weights, calibrations=found)
    assert PolicyWeights.from_json(whole.to_json()) == whole
    with pytest.raises(ValueError, match="she16 cannot be held"):
        calibrated(weights, sureness, room(), replace(plan, policies=("she16",)))


def test_rooms_are_set_apart_by_the_seed_and_never_all() -> None:
    lessons = load_lessons()
    plan = CalibrationPlan()
    apart = plan.set_apart(lessons)
    assert len(apart) == 4
    assert apart == plan.set_apart(lessons)
    assert apart != replace(plan, seed=1).set_apart(lessons)
    assert not replace(plan, lessons=0).set_apart(lessons)
    assert not plan.set_apart(room().lessons)


def test_sureness_rises_with_what_made_executions_right() -> None:
    rows = [
        ({"select_hypo": 1.0, "select_hypo.value": value / 20}, value % 10 > 0 and value > 8)
        for value in range(20)
    ]
    sure = fitted(rows)
    assert set(sure.weights) == set(FEATURES)
    assert sure.of(rows[-1][0]) > 0.6
    assert sure.of(rows[0][0]) < 0.4
    with pytest.raises(ValueError, match="nothing was carried out"):
        fitted([])
    with pytest.raises(ValueError, match="nothing to practise"):
        practise(Classroom((), make_settings()), PRACTICE, [], 0)
