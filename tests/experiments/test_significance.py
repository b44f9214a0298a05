from __future__ import annotations

import numpy as np
import pytest

from verbteach.experiments.figures import Observation
from verbteach.experiments.significance import holm, paired_permutation


def test_a_permutation_test_finds_a_difference_and_only_a_difference() -> None:
    rng = np.random.default_rng(0)
    noise = rng.normal(size=40)
    base = [[Observation(f"d{i}", value) for i, value in enumerate(noise)]]
    better = [[Observation(o.group, o.value + 0.5) for o in base[0]]]
    other = [[Observation(o.group, o.value + rng.normal()) for o in base[0]]]
    assert paired_permutation(better, base, rng, 999) == pytest.approx(0.001)
    assert paired_permutation(base, base, rng, 99) == 1.0
    assert paired_permutation(other, base, rng, 999) > 0.01


def test_permutations_need_the_same_commands() -> None:
    one, two = [[Observation("a", 1.0)]], [[Observation("b", 1.0)]]
    with pytest.raises(ValueError, match="same commands"):
        paired_permutation(one, two, np.random.default_rng(0), 9)


def test_holm_multiplies_the_smallest_most_and_never_falls() -> None:
    assert holm([0.01, 0.04, 0.03]) == pytest.approx((0.03, 0.06, 0.06))
    assert holm([0.9, 0.8]) == (1.0, 1.0)
