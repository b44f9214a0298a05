from __future__ import annotations

from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.experiments.metrics import ied, sji
from verbteach.verbs.agreement import edit_distance
from verbteach.verbs.change import StateChange
from verbteach.world.fluents import Fluent
from verbteach.world.plan import Action

ACTIONS = st.sampled_from([Action.parse(t) for t in ("grasp Mug", "grasp Cup", "moveto Mug")])
SEQUENCES = st.lists(ACTIONS, max_size=7).map(tuple)
FLUENTS = st.frozensets(st.sampled_from([Fluent("on", (x, "sink")) for x in "abcde"]))
STATES = st.tuples(FLUENTS, FLUENTS)
CHANGES = STATES.map(lambda states: StateChange.between(*states))


def recursive_distance(left: tuple[Action, ...], right: tuple[Action, ...]) -> int:
    """The definition, word by word; the oracle for the table."""

    @cache
    def distance(i: int, j: int) -> int:
        if i == 0 or j == 0:
            return i + j
        replaced = distance(i - 1, j - 1) + (left[i - 1] != right[j - 1])
        return min(replaced, distance(i - 1, j) + 1, distance(i, j - 1) + 1)

    return distance(len(left), len(right))


@given(SEQUENCES, SEQUENCES)
def test_edit_distance_is_its_recursive_definition(
    left: tuple[Action, ...], right: tuple[Action, ...]
) -> None:
    assert edit_distance(left, right) == recursive_distance(left, right)


@given(SEQUENCES, SEQUENCES)
def test_ied_is_symmetric_and_bounded(left: tuple[Action, ...], right: tuple[Action, ...]) -> None:
    assert ied(left, right) == ied(right, left)
    assert 0 <= ied(left, right) <= 1


@given(SEQUENCES, SEQUENCES)
def test_ied_is_one_only_for_equal_sequences(
    left: tuple[Action, ...], right: tuple[Action, ...]
) -> None:
    assert (ied(left, right) == 1) == (left == right)


@given(SEQUENCES, SEQUENCES, SEQUENCES)
def test_edit_distance_keeps_the_triangle(
    a: tuple[Action, ...], b: tuple[Action, ...], c: tuple[Action, ...]
) -> None:
    assert edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c)


def test_ied_compares_whole_actions() -> None:
    gold = [Action.parse(t) for t in ("moveto Mug", "grasp Mug", "moveto Sink", "keep-on Mug Sink")]
    other = [
        Action.parse(t) for t in ("moveto Mug", "grasp Mug", "moveto Sink", "keep-on Cup Sink")
    ]
    assert ied(gold, other) == 0.75
    assert ied(gold, gold[:2]) == 0.5
    assert ied(gold, []) == 0


@given(CHANGES, CHANGES)
def test_sji_is_symmetric_and_bounded(left: StateChange, right: StateChange) -> None:
    assert sji(left, right) == sji(right, left)
    assert 0 <= sji(left, right) <= 1


@given(CHANGES, CHANGES)
def test_sji_is_one_only_for_equal_changes(left: StateChange, right: StateChange) -> None:
    assert (sji(left, right) == 1) == (left == right and len(left) > 0)


@given(CHANGES)
def test_doing_nothing_scores_nothing(change: StateChange) -> None:
    assert sji(change, StateChange()) == 0


def test_added_and_removed_are_items_of_their_own() -> None:
    here, there = Fluent("on", ("Mug", "Table")), Fluent("on", ("Mug", "Sink"))
    moved = StateChange(frozenset({there}), frozenset({here}))
    back = StateChange(frozenset({here}), frozenset({there}))
    assert sji(moved, back) == 0
    assert sji(moved, StateChange(frozenset({there}))) == pytest.approx(0.5)
