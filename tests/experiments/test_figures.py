"""Means and intervals of runs over documents."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.experiments.figures import Figure, Observation, constant, figure, paired

observations = st.builds(Observation, st.sampled_from("abc"), st.floats(0, 1))
runs_ = st.lists(st.lists(observations, min_size=1, max_size=6), min_size=1, max_size=4)


def rng() -> np.random.Generator:
    return np.random.default_rng(0)


@given(runs_)
def test_the_interval_lies_within_the_values_and_is_repeatable(
    runs: list[list[Observation]],
) -> None:
    found = figure(runs, rng(), resamples=50)
    values = [one.value for run in runs for one in run]
    assert min(values) - 1e-9 <= found.ci95[0] <= found.ci95[1] <= max(values) + 1e-9
    assert found == figure(runs, rng(), resamples=50)
    assert found.runs == len(runs)
    assert found.mean == pytest.approx(
        float(np.mean([np.mean([one.value for one in run]) for run in runs]))
    )


def test_the_interval_covers_the_mean_it_estimates() -> None:
    """Over worlds with known mean the 95 % interval covers it about that often."""
    draw = np.random.default_rng(7)
    covered = 0
    for _ in range(200):
        levels = draw.normal(0.5, 0.1, size=40)
        run = [Observation(str(g), float(draw.normal(levels[g], 0.1)))
               for g in range(40) for _ in range(5)]  # fmt: skip
        low, high = figure([run], draw, resamples=200).ci95
        covered += low <= 0.5 <= high
    assert 0.88 <= covered / 200 <= 0.99


def test_documents_that_agree_inside_widen_the_interval() -> None:
    alike = [Observation(str(g), float(g % 2)) for g in range(20) for _ in range(10)]
    mixed = [Observation(str(g), float(i % 2)) for g in range(20) for i in range(10)]
    wide, narrow = figure([alike], rng()).ci95, figure([mixed], rng()).ci95
    assert wide[1] - wide[0] > 0.2
    assert narrow[1] - narrow[0] < 0.01


def test_deviation_is_over_runs() -> None:
    runs = [[Observation("a", value)] for value in (0.2, 0.4, 0.6)]
    found = figure(runs, rng())
    assert found.mean == pytest.approx(0.4)
    assert found.sd == pytest.approx(0.2)
    assert figure(runs[:1], rng()).sd == 0.0


def test_paired_differences_cancel_what_is_common() -> None:
    draw = np.random.default_rng(1)
    one = [Observation(str(i % 9), float(draw.random())) for i in range(90)]
    other = [Observation(o.group, o.value - 0.1) for o in one]
    found = paired([one], [other], rng())
    assert found.mean == pytest.approx(0.1)
    assert list(found.ci95) == pytest.approx([0.1, 0.1])


def test_nothing_has_no_figure() -> None:
    with pytest.raises(ValueError, match="at least one run"):
        figure([], rng())
    with pytest.raises(ValueError, match="observation"):
        figure([[]], rng())


def test_json_has_the_keys_of_the_command_line() -> None:
    assert constant(0.0, 3).to_json() == {"mean": 0.0, "sd": 0.0, "ci95": [0.0, 0.0], "runs": 3}
    assert Figure(0.5, 0.1, (0.4, 0.6), 5).to_json()["ci95"] == [0.4, 0.6]
