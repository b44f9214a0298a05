"""Beliefs: thresholds, answers, exclusive fluents, entropy."""

from __future__ import annotations

import json
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.perception.strategies import PLACE, WHERE, beliefs, fluents, states
from verbteach.perception.belief import Belief, change_probability, entropy
from verbteach.world.fluents import Fluent, State

ON = Fluent("on", ("Cup_1", "Tray_1"))
IN = Fluent("in", ("Cup_1", "Sink"))
NEAR = Fluent("near", ("Cup_1", "Sink"))


@given(states())
def test_who_sees_everything_believes_the_state(state: State) -> None:
    belief = Belief.certain(state)
    assert belief.believed() == state
    assert belief.entropy == 0.0


def test_one_half_is_not_believed() -> None:
    belief = Belief.of({ON: 0.5, NEAR: 0.5000001})
    assert belief.believed() == {NEAR}
    assert belief.believed(threshold=0.4) == {ON, NEAR}


@given(beliefs(), fluents, st.booleans())
def test_an_answer_settles_its_fluent_and_nothing_else(
    belief: Belief, fluent: Fluent, truth: bool
) -> None:
    after = belief.answered(fluent, truth)
    assert after[fluent] == float(truth)
    assert (fluent in after.believed()) == truth
    assert after.entropy_of(fluent) == 0.0
    assert {f: c for f, c in after.items() if f != fluent} == {
        f: c for f, c in belief.items() if f != fluent
    }
    assert belief[fluent] == dict(belief.items()).get(fluent, 0.0)


@given(beliefs((PLACE,)), fluents, st.booleans(), st.floats(0.55, 0.95))
def test_an_answer_that_may_be_wrong_moves_its_fluent_alone_and_its_contrary_takes_it_back(
    belief: Belief, fluent: Fluent, truth: bool, trust: float
) -> None:
    after = belief.answered(fluent, truth, trust)
    moved = after[fluent] - belief[fluent]
    assert moved * (1 if truth else -1) >= 0.0
    assert {f for f, c in after.items() if c != belief[f]} <= {fluent}
    assert after.answered(fluent, not truth, trust)[fluent] == pytest.approx(belief[fluent])


@given(beliefs((PLACE,)), fluents)
def test_a_yes_takes_the_rivals_away(belief: Belief, fluent: Fluent) -> None:
    rivals = belief.rivals(fluent)
    after = belief.answered(fluent, True)
    assert all(after[rival] == 0.0 for rival in rivals)
    assert fluent in after.believed()
    assert all({r.args[0], r.predicate} <= {fluent.args[0], "on", "in"} for r in rivals)


@given(beliefs((PLACE,)))
def test_a_believed_state_has_each_thing_in_one_place(belief: Belief) -> None:
    believed = belief.believed()
    placed = [f.args[0] for f in believed if f.predicate in PLACE.predicates]
    assert len(placed) == len(set(placed))
    above = {f for f, confidence in belief.items() if confidence > 0.5}
    for beaten in above - believed:
        assert any(belief[rival] >= belief[beaten] for rival in belief.rivals(beaten))
    assert {f for f in above if f.predicate == "near"} <= believed


@given(beliefs((WHERE,)))
def test_rivals_share_one_probability_and_none_grows(belief: Belief) -> None:
    weighed = belief.weighed()
    assert all(weighed[f] <= c for f, c in belief.items())
    for fluent, confidence in belief.items():
        rivals = belief.rivals(fluent)
        if WHERE.group(fluent) is None or not rivals:
            assert weighed[fluent] == confidence
        else:
            assert weighed[fluent] + sum(weighed[r] for r in rivals) <= 1.0 + 1e-9
            order = sorted((fluent, *rivals), key=lambda f: belief[f])
            assert order == sorted(order, key=lambda f: weighed[f])


@given(beliefs((WHERE,)))
def test_a_no_leaves_joint_rivals_as_if_it_had_never_been_seen(belief: Belief) -> None:
    for fluent, confidence in belief.items():
        if WHERE.group(fluent) is None or confidence > 0.999:
            continue
        others = Belief.of({f: c for f, c in belief.items() if f != fluent}, (WHERE,)).weighed()
        after = belief.weighed().answered(fluent, False)
        assert after[fluent] == 0.0
        for rival in belief.rivals(fluent):
            assert after[rival] == pytest.approx(others[rival], abs=1e-5)


def test_two_places_that_look_alike_are_doubted_where_the_robot_weighs_them() -> None:
    seen = {ON: 0.7, IN: 0.8, NEAR: 0.9}
    weighed = Belief.of(seen, (WHERE,)).weighed()
    assert weighed[IN] == pytest.approx(4.0 / (1.0 + 4.0 + 0.7 / 0.3))
    assert weighed.believed() == {IN, NEAR}
    assert Belief.of({ON: 1.0, IN: 1.0}, (WHERE,)).weighed().believed() == frozenset()
    assert Belief.of(seen, (PLACE,)).weighed() == Belief.of(seen, (PLACE,))


def test_the_likelier_place_wins() -> None:
    belief = Belief.of({ON: 0.7, IN: 0.8, NEAR: 0.9}, (PLACE,))
    assert belief.believed() == {IN, NEAR}
    assert belief.answered(IN, False).believed() == {ON, NEAR}
    assert Belief.of({ON: 0.7, IN: 0.8}).believed() == {ON, IN}


@given(beliefs())
def test_items_are_sorted_and_above_zero(belief: Belief) -> None:
    rows = list(belief.items())
    assert rows == sorted(rows)
    assert all(confidence > 0 for _, confidence in rows)


@given(beliefs())
def test_json_and_pickle_round_trip(belief: Belief) -> None:
    assert Belief.from_json(json.loads(json.dumps(belief.to_json()))) == belief
    assert pickle.loads(pickle.dumps(belief)) == belief


@given(st.floats(0, 1))
def test_entropy_is_symmetric_and_largest_at_one_half(probability: float) -> None:
    assert entropy(probability) == pytest.approx(entropy(1 - probability), abs=1e-9)
    assert 0 <= entropy(probability) <= entropy(0.5) == 1.0


def test_the_probability_of_a_change() -> None:
    before, after = Belief.of({ON: 0.9}), Belief.of({ON: 0.2, NEAR: 0.6})
    assert change_probability(before, after, ON) == pytest.approx(0.2 * 0.1 + 0.9 * 0.8)
    assert change_probability(before, after, NEAR) == pytest.approx(0.6)
    assert change_probability(before, before, IN) == 0.0


def test_what_is_no_confidence_is_refused() -> None:
    with pytest.raises(ValueError, match="between 0 and 1"):
        Belief.of({ON: 1.5})
    with pytest.raises(ValueError, match="not a fluent"):
        Belief.from_json({"": 0.5})
