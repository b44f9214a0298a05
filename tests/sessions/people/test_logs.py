"""Records as logs of choices: all that was earned is in them, and who never explored is refused."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.sessions.people.corpus import read_all
from tests.sessions.records import forge
from tests.sessions.rooms import TAUGHT, recorded
from verbteach_scenarios.weights import starting_weights
from verbteach_sessions.errors import SessionError
from verbteach_sessions.people.evaluating import NOTHING, evaluate_policy
from verbteach_sessions.people.logs import log_of, logged
from verbteach_sessions.people.recorded import Recorded, read_recorded
from verbteach_sessions.people.targets import TARGETS, UnknownTargetError, target


def of_policy(records: tuple[Recorded, ...], name: str) -> list[Recorded]:
    return [one for one in records if one.header.method.policy.name == name]


def test_phases_end_where_the_paper_ends_them_and_hold_every_choice(
    records: tuple[Recorded, ...],
) -> None:
    for record in of_policy(records, "random"):
        phases = list(logged(record))
        assert phases
        for one in phases:
            assert {choice.phase for choice in one.choices} == {one.phase}
            *asked, last = (choice.candidates[choice.chosen].act.name for choice in one.choices)
            ends = ("select_hypo", "include_fluent", "request_demonstration")
            assert last in ends or last.endswith("q")  # the person may take over
            assert not set(asked) & {"select_hypo", "include_fluent"}


def test_what_was_earned_in_a_session_is_earned_in_its_phases(
    records: tuple[Recorded, ...],
) -> None:
    (record, *_) = of_policy(records, "random")
    total = record.said[-1].reply.data["after"]["totals"]["reward"]
    earned = sum(choice.reward for one in logged(record) for choice in one.choices)
    outside = [
        one.reply.data["reward"] for one in record.said if one.before.waiting.name == "np_grd_whq"
    ]
    assert earned == pytest.approx(total, abs=-sum(outside) if outside else 1e-9)


def test_random_choices_have_the_propensity_of_one_in_so_many(
    records: tuple[Recorded, ...],
) -> None:
    for record in of_policy(records, "random"):
        for one in logged(record):
            for choice in one.choices:
                assert choice.propensity == pytest.approx(1.0 / len(choice.candidates))


def test_a_policy_that_asks_about_words_only_makes_no_choices(tmp_path: Path) -> None:
    (record,) = read_all([recorded(tmp_path, TAUGHT + "good\n")])
    assert list(logged(record)) == []
    reports = evaluate_policy([record], target("random", starting_weights()), rng())
    assert all(NOTHING in one.refused and not one.tells for one in reports.values())


@pytest.mark.parametrize("name", TARGETS)
def test_each_target_spreads_one_over_the_candidates(
    name: str, records: tuple[Recorded, ...]
) -> None:
    chances = target(name, starting_weights(), 0.2)
    for record in of_policy(records, "random"):
        for one in logged(record):
            for choice in one.choices:
                spread = chances(one.phase, choice.candidates)
                assert spread.sum() == pytest.approx(1.0)
                assert spread.min() >= 0.2 / len(choice.candidates) - 1e-12


def test_the_policy_that_was_logged_is_worth_what_it_earned(records: tuple[Recorded, ...]) -> None:
    random = of_policy(records, "random")
    reports = evaluate_policy(random, target("random", starting_weights()), rng(), minimum=1.0)
    for phase, report in reports.items():
        assert report.tells
        assert report.evaluation is not None
        phases = [x for record in random for x in logged(record) if x.phase == phase]
        log = log_of(phases, target("random", starting_weights()), 0.99)
        first = report.evaluation.estimates[0]
        assert first.value == pytest.approx(log.returns.mean())


def test_sessions_under_a_rule_are_left_out_by_name_with_the_reason(
    records: tuple[Recorded, ...],
) -> None:
    reports = evaluate_policy(records, target("random", starting_weights()), rng(), minimum=1.0)
    left_out = {name: why for one in reports.values() for name, why in one.left_out.items()}
    assert "never does" in left_out["split"]
    assert "random" not in left_out
    for report in reports.values():
        assert report.to_json()["left_out"] == report.left_out


def test_few_sessions_are_declined(records: tuple[Recorded, ...]) -> None:
    reports = evaluate_policy(records, target("split", starting_weights()), rng())
    told = [report.evaluation for report in reports.values() if report.evaluation]
    assert told
    assert all("at least 30 are needed" in one.declined for one in told)


def test_an_unknown_policy_is_named_with_those_there_are() -> None:
    with pytest.raises(UnknownTargetError, match=r"'she16'.*rl, manual"):
        target("she16", starting_weights())


def rng() -> np.random.Generator:
    return np.random.default_rng(0)


@pytest.mark.parametrize(
    "change",
    [
        {"chosen": 99},
        {"chosen": -1},
        {"candidates": [], "chosen": 0},
        {"candidates": [{"act": {"act": "sing"}, "features": {}, "q": None}]},
    ],
)
def test_a_decision_that_cannot_be_read_is_named(
    change: dict[str, object], example: tuple[Path, ...], tmp_path: Path
) -> None:
    path = tmp_path / example[0].name
    shutil.copytree(example[0], path)

    def forged(events: list[dict[str, Any]]) -> None:
        event = next(e for e in events if e["type"] == "robot" and e["data"]["decisions"])
        event["data"]["decisions"][0].update(change)

    forge(path, forged)
    with pytest.raises(SessionError, match=r"event \d+: a decision"):
        list(logged(read_recorded(path)))
