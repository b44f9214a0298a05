"""Noise levels and readings, against the distributions they claim."""

from __future__ import annotations

import math
from statistics import NormalDist

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.perception.strategies import states
from verbteach.perception.belief import Belief
from verbteach.perception.noise import LEVELS, READINGS, NoiseModel, perceive, perceive_both
from verbteach.world.fluents import Fluent, State

MANY = frozenset(Fluent("on", (f"Cup_{i}", "Tray_1")) for i in range(20_000))
PHANTOMS = frozenset(Fluent("in", (f"Cup_{i}", "Sink")) for i in range(20_000))


def confidences(noise: NoiseModel, seed: int = 1) -> np.ndarray:
    seen = perceive(MANY, (), noise, np.random.default_rng(seed))
    return np.array([seen[fluent] for fluent in sorted(MANY)])


@pytest.mark.parametrize(
    ("level", "reading", "missed"),
    [
        ("perfect", "literal", 0.0),
        ("std3", "literal", 0.095),
        ("std5", "literal", 0.285),
        ("uniform", "literal", 0.5),
        ("std3", "phantom", 0.048),
        ("std5", "phantom", 0.159),
        ("uniform", "phantom", 0.5),
    ],
)
def test_the_share_of_true_fluents_not_believed(level: str, reading: str, missed: float) -> None:
    drawn = confidences(NoiseModel.named(level, reading))
    assert ((drawn >= 0) & (drawn <= 1)).all()
    assert (drawn <= 0.5).mean() == pytest.approx(missed, abs=0.012)


@pytest.mark.parametrize("spread", [0.3, 0.5, 1.0])
def test_truncated_draws_follow_the_truncated_normal(spread: float) -> None:
    drawn = np.sort(confidences(NoiseModel(spread)))
    normal = NormalDist(1.0, spread)
    low, high = normal.cdf(0.0), normal.cdf(1.0)
    claimed = np.array([(normal.cdf(x) - low) / (high - low) for x in drawn])
    empirical = np.arange(1, len(drawn) + 1) / len(drawn)
    # Kolmogorov-Smirnov at one in a thousand, for 20,000 draws.
    assert np.abs(claimed - empirical).max() < 1.95 / math.sqrt(len(drawn))


@given(st.floats(0, 1, exclude_max=True), st.floats(0, 3), st.booleans())
def test_confidence_stays_in_the_interval(uniform: float, spread: float, clipped: bool) -> None:
    assert 0.0 <= NoiseModel(spread, clipped=clipped).confidence("on", uniform) <= 1.0


@given(states(), states(), st.sampled_from(sorted(LEVELS)), st.sampled_from(READINGS))
def test_what_each_reading_gives_to_false_fluents(
    state: State, possible: State, level: str, reading: str
) -> None:
    noise = NoiseModel.named(level, reading)
    seen = perceive(state, possible, noise, np.random.default_rng(3))
    assert {fluent for fluent, _ in seen.items()} <= state | (possible if noise.phantoms else state)
    if noise.exact:
        assert seen.believed() == state


def test_phantoms_mirror_true_fluents() -> None:
    noise = NoiseModel.named("std5", "phantom")
    seen = perceive(MANY, PHANTOMS, noise, np.random.default_rng(5))
    believed = seen.believed()
    assert len(believed & PHANTOMS) / len(PHANTOMS) == pytest.approx(0.159, abs=0.012)
    assert len(believed & MANY) / len(MANY) == pytest.approx(1 - 0.159, abs=0.012)


@given(states(), st.integers(0, 2**32))
def test_the_same_seed_sees_the_same(state: State, seed: int) -> None:
    noise = NoiseModel.named("std3")
    shuffled = frozenset(sorted(state, reverse=True))
    first = perceive(state, (), noise, np.random.default_rng(seed))
    assert perceive(shuffled, (), noise, np.random.default_rng(seed)) == first


def test_before_and_after_are_independent_unless_shared() -> None:
    gone, come = Fluent("on", ("Cup_0", "Tray_1")), Fluent("in", ("Cup_0", "Sink"))
    end = (MANY - {gone}) | {come}
    for shared in (False, True):
        noise = NoiseModel(0.5, shared=shared)
        before, after = perceive_both((MANY, end), (), noise, np.random.default_rng(2))
        same = [before[f] == after[f] for f in sorted(MANY & end)]
        assert all(same) if shared else not any(same)
        assert after[come] > 0
        assert after[gone] == 0


def test_a_predicate_has_its_own_reliability() -> None:
    noise = NoiseModel.named("uniform").with_spreads({"on": 0.0})
    state = frozenset({Fluent("on", ("Cup_1", "Tray_1")), Fluent("in", ("Cup_2", "Sink"))})
    seen = perceive(state, (), noise, np.random.default_rng(0))
    assert seen[Fluent("on", ("Cup_1", "Tray_1"))] == 1.0
    assert 0 < seen[Fluent("in", ("Cup_2", "Sink"))] < 1
    assert not noise.exact
    assert isinstance(seen, Belief)


def test_kinds_of_fluents_are_seen_as_the_text_has_it() -> None:
    assert NoiseModel.named("0.2") == NoiseModel(0.2)
    assert NoiseModel.named("std3, on = perfect, in=0.4") == NoiseModel(
        0.3, spreads={"on": 0.0, "in": 0.4}
    )
    phantom = NoiseModel.named("perfect,on=std5", "phantom")
    assert phantom == NoiseModel(0.0, clipped=True, phantoms=True, spreads={"on": 0.5})
    phantom.check_kinds({"on", "near"})
    with pytest.raises(ValueError, match="'on': no such kind of fluent here; there are in, near"):
        phantom.check_kinds({"near", "in"})


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("loud", "no noise level 'loud'"),
        ("-1", "0 or more"),
        ("nan", "0 or more"),
        ("", "no noise level ''"),
        ("std3,on", "put as on=0.1"),
        ("std3,=0.1", "put as on=0.1"),
        ("std3,on=often", "no noise level 'often'"),
        ("std3,on=0.1,on=0.2", "given twice"),
        ("on=0.1", "no noise level 'on=0.1'"),
    ],
)
def test_what_is_no_noise_is_refused_with_what_there_is(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        NoiseModel.named(text)


@pytest.mark.parametrize("spread", [-0.1, math.nan])
def test_a_spread_that_is_none_is_refused(spread: float) -> None:
    with pytest.raises(ValueError, match="spread"):
        NoiseModel(spread)


def test_unknown_names_are_refused_by_name() -> None:
    with pytest.raises(ValueError, match="std3"):
        NoiseModel.named("loud")
    with pytest.raises(ValueError, match="phantom"):
        NoiseModel.named("std3", "ghost")
