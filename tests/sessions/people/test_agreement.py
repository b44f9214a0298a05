"""Held-out agreement: foretold from other people only, and beside simpler guesses."""

from __future__ import annotations

import numpy as np
import pytest

from tests.sessions.people.corpus import answer, answers_of
from verbteach_sessions.people.agreement import agreement, chances
from verbteach_sessions.people.fitted_user import FittedUser, FittedUserError
from verbteach_sessions.people.observations import OBJECT, Observed


def people(rates: dict[str, float], count: int = 12, each: int = 25) -> list[Observed]:
    rng = np.random.default_rng(5)
    return [one for n in range(count) for one in answers_of(f"p{n:02}", rates, each, rng)]


def test_people_who_never_err_are_foretold_and_the_usual_answer_is_not_enough() -> None:
    found = agreement(people({}), np.random.default_rng(0))
    assert found.likeliest.mean == 1.0
    assert found.never_errs.mean == 1.0
    assert found.majority.mean < 0.75
    assert found.brier_never_errs.mean == 0.0


def test_people_who_err_are_foretold_with_fitting_probabilities() -> None:
    found = agreement(people({"error": 0.2, "unsure": 0.1, "gives_up": 0.1}), rng())
    rates = found.rates["goal_pred_ynq"]
    for predicted, observed in rates.values():
        assert predicted == pytest.approx(observed, abs=0.06)
    assert found.brier.mean < found.brier_never_errs.mean
    low, high = found.likeliest.ci95
    assert low < found.likeliest.mean < high


def test_nobody_is_foretold_from_their_own_answers() -> None:
    """One person in two is always wrong: seen from the other, each is a surprise."""
    always = answers_of("wrong", {"error": 1.0}, 40, rng())
    never = answers_of("right", {}, 40, rng())
    found = agreement([*always, *never], rng(), folds=2)
    assert found.likeliest.mean == 0.0


def test_the_chances_of_an_answer_sum_to_one_whatever_is_known() -> None:
    spread = FittedUser.of(people({"error": 0.2, "unsure": 0.1})).population.spread
    asked = [
        answer(truth=True),
        answer(truth=False),
        answer(truth=None),
        answer(question="np_grd_whq", given=OBJECT, truth=None),
    ]
    for one in asked:
        assert sum(chances(one, spread[one.question]).values()) == pytest.approx(1.0)


def test_a_single_person_is_too_few() -> None:
    with pytest.raises(FittedUserError, match="two people"):
        agreement(answers_of("a", {}, 10, rng()), rng())


def rng() -> np.random.Generator:
    return np.random.default_rng(7)
