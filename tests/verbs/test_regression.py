"""The fitted criterion: what it learns, and that small goals cannot outvote a good one."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.strategies import FEW, PLANNER, TOY, spaces
from verbteach.verbs.application import Evidence, Situation, evidence, uniform
from verbteach.verbs.criteria import MOST_FREQUENT
from verbteach.verbs.features import NAMES, votes
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.regression import FittingParameters, Judged, Regression, fit
from verbteach.verbs.selection import SelectionParameters, candidates, select
from verbteach.verbs.space import HypothesisSpace


def judged(reward: float, **features: float) -> tuple[float, list[float]]:
    return reward, [features.get(name, 0.0) for name in NAMES]


def command(*rows: tuple[float, list[float]]) -> Judged:
    """A development command with one vote for each of its goals."""
    rewards, features = zip(*rows, strict=True)
    return Judged(np.array(features), np.ones(len(rows)), np.array(rewards), ("d",) * len(rows))


def situations(found: list[HypothesisSpace]) -> Situation:
    key = found[0].demonstration.frame
    belief = uniform((TOY.boxes,) * key.arity)
    return Situation(key, ("the box",) * key.arity, belief, TOY.start, TOY.surroundings)


@FEW
@given(st.lists(spaces(), min_size=1, max_size=4))
def test_every_demonstration_votes_with_features_between_zero_and_one(
    found: list[HypothesisSpace],
) -> None:
    gathered = evidence(VerbKnowledge.merged(found), situations(found))
    for one in gathered:
        cast = list(votes(one))
        assert len(cast) == sum(len(support.uses) for support in one.supports)
        for vote in cast:
            assert len(vote.features) == len(NAMES)
            assert all(0.0 <= value <= 1.0 + 1e-9 for value in vote.features)
            assert 0.0 < vote.probability <= 1.0 + 1e-9


@FEW
@given(st.lists(spaces(), min_size=1, max_size=4))
def test_without_weights_it_counts_as_most_frequent_does(found: list[HypothesisSpace]) -> None:
    for one in evidence(VerbKnowledge.merged(found), situations(found)):
        assert Regression().score(one) == pytest.approx(MOST_FREQUENT.score(one))


@FEW
@given(st.lists(spaces(), min_size=2, max_size=4))
def test_votes_hang_on_no_other_demonstration(found: list[HypothesisSpace]) -> None:
    """Leaving a demonstration out of knowledge is leaving out its votes."""

    def cast(gathered: tuple[Evidence, ...]) -> list[tuple[object, ...]]:
        rows = [(one.key, vote) for one in gathered for vote in votes(one)]
        return sorted(r for r in rows if r[1].demonstration.id == "kept")

    kept = replace(found[0], demonstration=found[0].demonstration._replace(id="kept"))
    alone = evidence(VerbKnowledge.merged([kept]), situations(found))
    among = evidence(VerbKnowledge.merged([kept, *found[1:]]), situations(found))
    assert cast(alone) == cast(among)


def test_fitting_finds_the_feature_that_pays() -> None:
    draw = np.random.default_rng(0)
    commands = [
        command(
            *(
                judged(float(paid), same_objects=float(paid), size=float(draw.random()))
                for paid in (True, False, False)
            )
        )
        for _ in range(30)
    ]
    weights = dict(zip(NAMES, fit(commands).weights, strict=True))
    assert weights["same_objects"] > 1
    assert abs(weights["size"]) < 0.3
    strict = fit(commands, FittingParameters(ridge=10.0)).weights
    assert max(map(abs, strict)) < 0.1


def test_each_command_weighs_the_same() -> None:
    """One command with many goals that praise a feature; nine with few that condemn it."""
    loud = command(*[judged(1.0, size=1.0)] * 200, *[judged(0.0)] * 200)
    quiet = command(judged(0.0, size=1.0), judged(1.0))
    weights = dict(zip(NAMES, fit([loud, *[quiet] * 9]).weights, strict=True))
    assert weights["size"] < 0


@given(st.permutations([0, 1, 2, 3]))
def test_the_order_of_commands_hardly_matters(order: list[int]) -> None:
    commands = [
        command(judged(0.1 * i, phrases=0.2 * i), judged(0.5, least=1.0), judged(0.3))
        for i in range(4)
    ]
    one, other = fit(commands), fit([commands[i] for i in order])
    assert one.weights == pytest.approx(other.weights, abs=2e-6)


def test_nothing_to_learn_from() -> None:
    assert fit([]) == Regression()
    assert fit([command(judged(0.5, size=1.0), judged(0.5))]) == Regression()


def test_weights_travel_as_json() -> None:
    one = Regression(tuple(float(i) / 8 for i in range(len(NAMES))))
    assert Regression.from_json(json.loads(json.dumps(one.to_json()))) == one
    short = {"weights": dict.fromkeys(NAMES[1:], 0.0)}
    with pytest.raises(ValueError, match=NAMES[0]):
        Regression.from_json(short)


@FEW
@given(st.lists(spaces(), min_size=1, max_size=3))
def test_it_selects_as_any_criterion_does(found: list[HypothesisSpace]) -> None:
    parameters = SelectionParameters(Regression((0.5,) * len(NAMES)))
    wanted = candidates(VerbKnowledge.merged(found), situations(found), parameters)
    chosen = select(wanted, TOY.start, PLANNER, parameters)
    assert chosen is None or chosen.plan.actions
