"""Conditions come out balanced whenever recruiting stops, and the same from the same seed."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from tests.study.files import SMALL, study
from verbteach_sessions.study.counterbalance import (
    balanced_latin_square,
    order_of,
    orders,
    seed_of,
)
from verbteach_sessions.study.design import Study


def made(seed: int, within: bool, third: bool = False) -> Study:
    text = SMALL.replace("seed = 7", f"seed = {seed}")
    if within:
        text = text.replace("[study]", '[study]\ndesign = "within"')
    if third:
        text += '\n[[condition]]\nid = "third"\npolicy = "split"\n'
    return study(text)


@given(st.integers(0, 2**63 - 1), st.booleans(), st.booleans(), st.integers(1, 40))
def test_no_order_is_ever_more_than_one_ahead(
    seed: int, within: bool, third: bool, people: int
) -> None:
    small = made(seed, within, third)
    counts = Counter(order_of(small, slot) for slot in range(people))
    every = [counts[order] for order in orders(small)]
    assert max(every) - min(every) <= 1
    assert sum(every) == people


def test_blocks_are_drawn_each_anew_and_the_same_from_the_same_seed() -> None:
    first = [order_of(made(1, False), slot) for slot in range(20)]
    assert first == [order_of(made(1, False), slot) for slot in range(20)]
    assert len({tuple(first[i : i + 2]) for i in range(0, 20, 2)}) == 2
    assert any([order_of(made(s, False), 0) for s in range(20)][i] != first[0] for i in range(20))


@given(st.integers(1, 9))
def test_in_a_square_each_follows_each_other_equally_often(size: int) -> None:
    rows = balanced_latin_square(size)
    assert all(sorted(row) == list(range(size)) for row in rows)
    for place in range(size):
        assert len(set(Counter(row[place] for row in rows).values())) == 1
    follows = Counter(pair for row in rows for pair in pairwise(row))
    assert len(follows) == size * (size - 1)
    assert len(set(follows.values())) <= 1


def test_every_session_has_a_seed_of_its_own() -> None:
    small = made(3, True)
    seeds = {seed_of(small, slot, part) for slot in range(30) for part in range(3)}
    assert len(seeds) == 90
    assert seed_of(small, 4, 1) == seed_of(made(3, True), 4, 1) != seed_of(made(4, True), 4, 1)
