"""The stop rule: what is promised holds for commands that are exchangeable with the calibration."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.policy.courses import Course, Outcome, Piece
from verbteach.policy.stopping import (
    CONFIDENCE,
    START,
    UnkeepablePromiseError,
    cut_for,
    kept,
    of_all,
    of_carried_out,
)

RIGHT, WRONG, SHOWN = Outcome.RIGHT, Outcome.WRONG, Outcome.SHOWN
LAST = Piece(math.inf, SHOWN, 3)


def drawn(rng: np.random.Generator, count: int) -> list[Course]:
    """Commands that are asked on about up to twice; what is surer is right more often.

    An execution may turn from right to wrong while the robot asks on.
    """
    found = []
    for _ in range(count):
        bounds = np.sort(rng.random(int(rng.integers(1, 4)))).tolist()
        pieces = [
            Piece(bound, RIGHT if rng.random() < bound**0.4 else WRONG, asked)
            for asked, bound in enumerate(bounds)
        ]
        found.append(Course((*pieces, LAST)))
    return found


@pytest.mark.parametrize("rate", [0.6, 0.8, 0.9])
def test_of_all_commands_few_enough_go_wrong_on_average(rate: float) -> None:
    rng = np.random.default_rng(7)
    wrong, acted = [], []
    for _ in range(400):
        *seen, new = drawn(rng, 61)
        piece = new.at(of_all(seen, rate))
        wrong.append(piece.outcome is WRONG)
        acted.append(piece.outcome is not SHOWN)
    assert np.mean(wrong) <= 1 - rate + 0.03
    assert np.mean(acted) > 0.1


@pytest.mark.parametrize("rate", [0.6, 0.8])
def test_of_what_is_carried_out_enough_is_right_in_nearly_every_calibration(rate: float) -> None:
    rng = np.random.default_rng(11)
    population = drawn(rng, 4000)
    broken = made = 0
    for _ in range(200):
        seen = [population[i] for i in rng.permutation(len(population))[:150]]
        try:
            cut = of_carried_out(seen, rate)
        except UnkeepablePromiseError:
            continue
        made += 1
        real = kept(population, cut)
        broken += real.right / real.carried_out < rate
    assert made > 50
    assert broken <= (1 - CONFIDENCE) * made


def test_more_is_promised_by_doing_less() -> None:
    courses = drawn(np.random.default_rng(2), 600)
    cuts = [cut_for(courses, rate).sure for rate in (0.6, 0.7, 0.8)]
    assert cuts == sorted(cuts)
    shares = [kept(courses, cut).carried_out for cut in cuts]
    assert shares == sorted(shares, reverse=True)


def test_both_bounds_are_kept() -> None:
    courses = drawn(np.random.default_rng(5), 400)
    cut = cut_for(courses, 0.75)
    assert cut.sure == max(of_all(courses, 0.75), of_carried_out(courses, 0.75))
    assert cut.lessons == 400


@given(st.integers(0, 2**32 - 1), st.integers(20, 60))
def test_counting_along_the_cuts_is_counting_at_each(seed: int, count: int) -> None:
    """The cut of the tests is the lowest that an oracle finds by counting anew at every cut."""
    courses = drawn(np.random.default_rng(seed), count)
    cuts = sorted({p.upto for c in courses for p in c.pieces if p.outcome is not SHOWN})[::-1]
    found, begun = [], False
    for cut in cuts:
        one = kept(courses, cut)
        begun = begun or one.carried_out >= START * count
        if begun:
            if binomial(one.wrong, one.carried_out, 0.4) > 1 - CONFIDENCE:
                break
            found.append(cut)
    if not found:
        with pytest.raises(UnkeepablePromiseError):
            of_carried_out(courses, 0.6)
    else:
        assert of_carried_out(courses, 0.6) == min(found)


def binomial(wrong: int, among: int, share: float) -> float:
    return sum(
        math.comb(among, k) * share**k * (1 - share) ** (among - k) for k in range(wrong + 1)
    )


def test_a_promise_that_rests_on_too_little_is_refused() -> None:
    right = [Course((Piece(0.9, RIGHT, 0), LAST))]
    with pytest.raises(UnkeepablePromiseError, match="it takes 9 or more"):
        cut_for(right * 8, 0.9)
    with pytest.raises(UnkeepablePromiseError, match="it takes 16 or more"):
        cut_for(right * 12, 0.9)
    assert cut_for(right * 16, 0.9).sure == 0.9
    wrong = [Course((Piece(0.9, WRONG, 0), LAST))]
    with pytest.raises(UnkeepablePromiseError, match="at most 50% was right"):
        cut_for((right + wrong) * 60, 0.8)
    surest = [Course((Piece(0.95, RIGHT, 0), LAST))]
    with pytest.raises(UnkeepablePromiseError, match="at most 58% was right"):
        cut_for(surest * 20 + (right + wrong) * 50, 0.8)
    certain = [Course((Piece(math.inf, WRONG, 0),))]
    with pytest.raises(UnkeepablePromiseError, match="however sure"):
        cut_for(certain * 60, 0.8)
    for rate in (0.0, 1.0):
        with pytest.raises(ValueError, match="between 0 and 1"):
            cut_for(right * 50, rate)
