"""The fitted user: what is counted, what comes of it, and what its file may hold."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.sessions.people.corpus import answer, answers_of
from verbteach_sessions.errors import NotASessionError
from verbteach_sessions.people.fitted_user import FittedUser, FittedUserError
from verbteach_sessions.people.fitting import is_user, load_user, save_user
from verbteach_sessions.people.habits import ASKED
from verbteach_sessions.people.observations import GAVE_UP, NO, UNREAD, UNSURE, YES
from verbteach_sessions.people.population import RATES


def test_each_answer_counts_for_the_rates_it_bears_on_and_no_other() -> None:
    user = FittedUser.of(
        [
            answer("a", given=YES, truth=True, words="yep"),
            answer("a", given=NO, truth=True),
            answer("a", given=NO, truth=None, asked=3),
            answer("a", given=UNSURE),
            answer("a", given=GAVE_UP, asked=7),
            answer("a", given=UNREAD, truth=None, words="eh?"),
        ]
    )
    assert user.counts["a"]["goal_pred_ynq"] == {
        "gives_up.first": (0, 4),
        "gives_up.later": (0, 1),
        "gives_up.late": (1, 1),
        "unsure": (1, 4),
        "error": (1, 2),
        "yes": (1, 3),
        "words": (2, 5),
    }
    assert user.asked("goal_pred_ynq") == 6
    assert user.gold_known == {**dict.fromkeys(ASKED, (0, 0)), "goal_pred_ynq": (2, 4)}
    assert user.wording == {YES: (("yep", 1),), NO: (), UNSURE: ()}


def test_rates_come_back_from_answers_given_by_them() -> None:
    rng = np.random.default_rng(0)
    rates = {"gives_up": 0.1, "unsure": 0.2, "error": 0.3}
    people = [one for n in range(30) for one in answers_of(f"p{n}", rates, 40, rng)]
    spread = FittedUser.of(people).population.spread["goal_pred_ynq"]
    assert spread["gives_up.first"].mean == pytest.approx(0.1, abs=0.03)
    assert spread["unsure"].mean == pytest.approx(0.2, abs=0.03)
    assert spread["error"].mean == pytest.approx(0.3, abs=0.04)


def test_a_careless_person_is_told_from_the_careful_ones() -> None:
    rng = np.random.default_rng(0)
    people = [x for n in range(9) for x in answers_of(f"p{n}", {"error": 0.02}, 30, rng)]
    user = FittedUser.of([*people, *answers_of("careless", {"error": 0.5}, 30, rng)])
    errors = {name: user.individual(name).rates["goal_pred_ynq"].error for name in user.counts}
    assert max(errors, key=lambda name: errors[name]) == "careless"
    assert 0.2 < errors["careless"] < 0.5
    with pytest.raises(KeyError):
        user.individual("nobody")


def test_a_question_that_was_seldom_asked_takes_the_rates_of_all_questions() -> None:
    rng = np.random.default_rng(1)
    people = [x for n in range(10) for x in answers_of(f"p{n}", {"error": 0.4}, 30, rng)]
    spread = FittedUser.of(people).population.spread
    assert set(spread) == set(ASKED)
    assert all(set(betas) == set(RATES) for betas in spread.values())
    assert spread["env_pred_ynq"]["error"].mean == pytest.approx(0.4, abs=0.06)


def test_people_drawn_from_it_differ_and_average_to_it() -> None:
    rng = np.random.default_rng(1)
    people = [x for n in range(20) for x in answers_of(f"p{n}", {"error": 0.5 * (n % 2)}, 20, rng)]
    population = FittedUser.of(people).population
    drawn = [population.person(rng).rates["goal_pred_ynq"].error for _ in range(400)]
    assert np.std(drawn) > 0.1
    assert np.mean(drawn) == pytest.approx(population.mean().rates["goal_pred_ynq"].error, abs=0.04)


def test_nothing_answered_is_refused() -> None:
    with pytest.raises(FittedUserError, match="nothing to fit"):
        FittedUser.of([])


def test_the_file_gives_the_same_user_back(tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    people = [*answers_of("a", {"error": 0.1}, 20, rng), answer("b", words="yep")]
    user = FittedUser.of(people, [("20260101-x", "0" * 64)])
    path = tmp_path / "user.json"
    save_user(path, user)
    assert is_user(path)
    assert load_user(path) == user
    assert load_user(path).population == user.population


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"format": "other"}, "no fitted user"),
        ({"version": 2}, "version 2"),
        ({"people": {"a": {"goal_pred_ynq": {"error": [3, 2]}}}}, "no count"),
        ({"people": {"a": {"goal_pred_ynq": {"error": ["1", 2]}}}}, "no count"),
        ({"people": [1]}, "cannot be read"),
        ({"wording": {"yes": [["yep", 0]]}}, "less than once"),
        ({"sessions": 3}, "cannot be read"),
    ],
)
def test_a_file_that_does_not_fit_is_refused_with_its_reason(
    tmp_path: Path, change: dict[str, object], reason: str
) -> None:
    path = tmp_path / "user.json"
    path.write_text(json.dumps({**FittedUser.of([answer()]).to_json(), **change}))
    with pytest.raises(FittedUserError, match=reason) as refused:
        load_user(path)
    assert str(path) in str(refused.value)


def test_what_is_no_json_or_no_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "user.json"
    path.write_bytes(b"[" * 100_000)
    with pytest.raises(FittedUserError, match="nested too deeply"):
        load_user(path)
    assert not is_user(path)
    with pytest.raises(NotASessionError):
        load_user(tmp_path)
