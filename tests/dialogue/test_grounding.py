"""The grounding belief: probabilities, answers, and what they settle."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.dialogue.grounding import GroundingBelief

WEIGHTS = st.dictionaries(st.sampled_from(["A", "B", "C", "D"]), st.floats(0.01, 10), min_size=1)


@given(WEIGHTS)
def test_chances_sum_to_one_and_come_the_likeliest_first(weights: dict[str, float]) -> None:
    chances = [p for _, p in GroundingBelief.of({"mug": weights})["mug"]]
    assert math.isclose(sum(chances), 1.0)
    assert chances == sorted(chances, reverse=True)


@given(WEIGHTS, st.sampled_from(["A", "B", "C", "D"]))
def test_a_yes_sets_one_and_a_no_sets_zero(weights: dict[str, float], thing: str) -> None:
    belief = GroundingBelief.of({"mug": weights, "sink": {"S": 1.0}})
    assert belief.confirm("mug", thing)["mug"] == ((thing, 1.0),)
    assert "mug" in belief.confirm("mug", thing).settled
    after = belief.deny("mug", thing)
    assert thing not in dict(after["mug"])
    assert not after["mug"] or math.isclose(sum(p for _, p in after["mug"]), 1.0)
    assert after["sink"] == belief["sink"]


def test_margin_and_entropy_tell_clear_from_unclear() -> None:
    belief = GroundingBelief.of({"mug": {"A": 1, "B": 1}, "sink": {"S": 1}, "unicorn": {}})
    assert belief.margin("mug") == 0.0
    assert belief.entropy("mug") == pytest.approx(math.log(2))
    assert belief.margin("sink") == 1.0
    assert belief.best("unicorn") is None
    assert belief.margin("unicorn") == 0.0
    assert belief.grounded == ("mug", "sink")


def test_narrowing_to_one_object_settles_the_phrase() -> None:
    belief = GroundingBelief.of({"mug": {"A": 1, "B": 1, "C": 1}})
    assert belief.restrict("mug", {"A": 1, "B": 1}).settled == frozenset()
    assert belief.restrict("mug", {"B": 1}).settled == {"mug"}
