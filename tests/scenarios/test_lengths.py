from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach_scenarios.lengths import Lengths


@given(st.lists(st.integers(0, 60), min_size=2, max_size=50))
def test_lengths_are_summarised_as_a_sample(lengths: list[int]) -> None:
    found = Lengths.of(lengths)
    assert found.mean == pytest.approx(np.mean(lengths))
    assert found.sd == pytest.approx(np.std(lengths, ddof=1))
    assert (found.min, found.max) == (min(lengths), max(lengths))


def test_few_lengths_have_no_spread() -> None:
    assert Lengths.of([]) == Lengths(0.0, 0.0, 0, 0)
    assert Lengths.of([7]) == Lengths(7.0, 0.0, 7, 7)
