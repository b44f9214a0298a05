"""Splits: nobody on both sides, near the shares, the same by the same seed."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verbteach_sessions.corpus.splits import (
    PARTS,
    Member,
    SplitError,
    grouped,
    make_splits,
    read_splits,
)

CODES = st.one_of(st.none(), st.sampled_from("abcdef"))


@st.composite
def corpora(draw: st.DrawFn) -> list[Member]:
    count = draw(st.integers(1, 25))
    names = [f"s{number:02d}" for number in range(count)]
    return [
        Member(
            name,
            draw(CODES),
            tuple(draw(st.lists(st.sampled_from([*names, "elsewhere"]), max_size=1))),
            draw(st.sampled_from([f"h{number}" for number in range(40)])),
        )
        for name in names
    ]


@settings(max_examples=50)
@given(corpora(), st.integers(0, 3))
def test_nothing_that_belongs_together_is_parted(members: list[Member], seed: int) -> None:
    parts = make_splits(members, np.random.default_rng(seed), seed).parts
    assert set(parts) == {one.session for one in members}
    for one in members:
        for other in members:
            same_person = one.participant is not None and one.participant == other.participant
            related = same_person or one.content_hash == other.content_hash
            if related or other.session in one.kin:
                assert parts[one.session] == parts[other.session]


@settings(max_examples=30)
@given(corpora())
def test_the_order_of_the_sessions_does_not_matter(members: list[Member]) -> None:
    shuffled = sorted(members, key=lambda one: one.content_hash, reverse=True)
    one, other = (make_splits(each, np.random.default_rng(3), 3) for each in (members, shuffled))
    assert one == other


def people(count: int, each: int) -> list[Member]:
    return [
        Member(f"{code}-{number}", f"p{code}", (), f"{code}-{number}")
        for code in range(count)
        for number in range(each)
    ]


def test_shares_are_met_as_far_as_people_allow() -> None:
    parts = make_splits(people(50, 2), np.random.default_rng(0), 0, (0.6, 0.2, 0.2)).parts
    counts = [sum(part == name for part in parts.values()) for name in PARTS]
    assert counts == [60, 20, 20]


def test_the_seed_decides_and_nothing_else() -> None:
    one, again, other = (
        make_splits(people(30, 1), np.random.default_rng(s), s).parts for s in (1, 1, 2)
    )
    assert one == again != other


def test_a_chain_of_sessions_is_one_group() -> None:
    members = [
        Member("a", "p", (), "1"),
        Member("b", None, ("a",), "2"),
        Member("c", "q", ("b", "elsewhere"), "3"),
        Member("d", "q", (), "4"),
        Member("e", None, (), "5"),
    ]
    assert grouped(members) == [["a", "b", "c", "d"], ["e"]]


@pytest.mark.parametrize("shares", [(0.5, 0.5, 0.5), (1.2, -0.1, -0.1), (0.0, 0.0, 0.0)])
def test_shares_that_cannot_be_are_refused(shares: tuple[float, float, float]) -> None:
    with pytest.raises(SplitError, match="add up to 1"):
        make_splits(people(3, 1), np.random.default_rng(0), 0, shares)


def test_a_file_of_splits_reads_back(tmp_path: Path) -> None:
    made = make_splits(people(20, 1), np.random.default_rng(0), 0)
    path = tmp_path / "splits.json"
    path.write_text(json.dumps(made.to_json()), "utf-8")
    assert read_splits(path) == made.parts


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        '{"train": [], "validation": []}',
        '{"train": [1], "validation": [], "test": []}',
        '{"train": ["a"], "validation": ["a"], "test": []}',
    ],
)
def test_a_file_that_is_none_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "splits.json"
    path.write_text(text, "utf-8")
    with pytest.raises(SplitError, match=r"splits\.json"):
        read_splits(path)
