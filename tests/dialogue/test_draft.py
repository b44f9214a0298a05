"""A turn in the making: states are copied with changes, and nothing else of the old one stays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.dialogue.stage import robot
from verbteach.dialogue.draft import Draft, Mind, generator


def draft() -> Draft:
    pupil = robot()
    return Draft(Mind(pupil.parameters, pupil.policy, pupil.setting), pupil.state)


@given(st.text(max_size=9), st.text(max_size=9))
def test_what_is_remembered_is_a_replacement_of_fields(heard: str, suggested: str) -> None:
    made = draft()
    before = made.state
    made.remember(heard=heard, suggested=suggested)
    assert made.state == replace(before, heard=heard, suggested=suggested)
    assert before.heard == ""


def test_a_state_that_has_changed_has_another_digest() -> None:
    made = draft()
    digest = made.state.digest
    made.remember(heard="boil the water")
    assert made.state.digest == replace(made.state).digest != digest


@pytest.mark.parametrize("worked_out", [False, True])
def test_a_misspelt_field_is_refused(worked_out: bool) -> None:
    made = draft()
    if worked_out:  # what a state has worked out stands beside its fields
        assert made.state.digest
    with pytest.raises(TypeError, match="herd"):
        made.remember(herd="boil the water")


def test_counting_adds_to_the_totals_alone() -> None:
    made = draft()
    made.count(questions=2, reward=-1.5)
    made.count(questions=1)
    assert made.state.totals == replace(made.state.totals, questions=3, reward=-1.5)
    assert made.state.totals.episodes == 0


@given(st.lists(st.integers(min_value=0, max_value=2**63 - 1), min_size=1, max_size=6))
def test_a_generator_draws_as_that_of_the_list_of_its_numbers(numbers: list[int]) -> None:
    expected = np.random.default_rng(numbers).random(3).tolist()
    assert generator(*numbers).random(3).tolist() == expected
