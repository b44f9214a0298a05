"""Rates over people: the most probable Beta, and what it does to those who answered little."""

from __future__ import annotations

from math import lgamma, log

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verbteach_sessions.people.population import Beta
from verbteach_sessions.people.shrinkage import Count, Prior, fit

COUNTS = st.lists(
    st.integers(0, 30).flatmap(lambda n: st.integers(0, n).map(lambda k: Count(k, n))), max_size=8
)


def log_posterior(counts: list[Count], beta: Beta, prior: Prior) -> float:
    """The same density by the textbook's formula, from the log of the gamma function."""

    def log_beta(a: float, b: float) -> float:
        return lgamma(a) + lgamma(b) - lgamma(a + b)

    a, b = beta.a, beta.b
    told = sum(log_beta(a + k, b + n - k) - log_beta(a, b) for k, n in counts)
    mean = (prior.rare - 1) * log(beta.mean) + (prior.common - 1) * log(1 - beta.mean)
    return told + mean - 0.5 * ((log(a + b) - log(prior.alike)) / prior.spread) ** 2


@given(COUNTS)
@settings(max_examples=25, deadline=None)
def test_no_beta_near_it_is_more_probable(counts: list[Count]) -> None:
    found = fit(counts)
    best = log_posterior(counts, found, Prior())
    for mean in (-0.2, 0.0, 0.2):
        for size in (-0.3, 0.0, 0.3):
            logit = log(found.mean / (1 - found.mean)) + mean
            share = 1 / (1 + np.exp(-logit))
            total = (found.a + found.b) * np.exp(size)
            other = Beta(share * total, (1 - share) * total)
            assert log_posterior(counts, other, Prior()) <= best + 1e-3


@given(COUNTS, st.integers(0, 20), st.integers(0, 20))
@settings(max_examples=25, deadline=None)
def test_a_person_lies_between_themselves_and_the_others(
    counts: list[Count], times: int, others: int
) -> None:
    beta = fit(counts)
    own = beta.after(times, times + others).mean
    if times + others:
        low, high = sorted((beta.mean, times / (times + others)))
        assert low - 1e-9 <= own <= high + 1e-9
    else:
        assert own == beta.mean


def test_the_more_somebody_answered_the_less_they_are_drawn_to_the_others() -> None:
    beta = fit([Count(1, 20)] * 10)
    pulled = [beta.after(n // 2, n).mean for n in (2, 10, 50, 5000)]
    assert pulled == sorted(pulled)
    assert pulled[0] < 0.2
    assert pulled[-1] == pytest.approx(0.5, abs=0.02)


def test_what_nobody_did_is_rare_and_never_impossible() -> None:
    assert 0.0 < fit([Count(0, 100)] * 20).mean < 0.01
    assert fit([Count(0, 3)]).mean > fit([Count(0, 100)] * 20).mean


def test_alike_people_give_a_narrow_beta_and_unlike_ones_a_wide_one() -> None:
    alike = fit([Count(10, 40)] * 20)
    unlike = fit([Count(0, 40), Count(20, 40)] * 10)
    assert alike.mean == pytest.approx(0.25, abs=0.03)
    assert unlike.mean == pytest.approx(0.25, abs=0.1)
    assert alike.a + alike.b > 5 * (unlike.a + unlike.b)


def test_many_people_give_their_own_beta_back() -> None:
    rng = np.random.default_rng(2)
    rates = rng.beta(2.0, 8.0, size=400)
    found = fit([Count(int(rng.binomial(30, rate)), 30) for rate in rates])
    assert found.mean == pytest.approx(0.2, abs=0.02)
    assert found.a + found.b == pytest.approx(10.0, rel=0.25)
