"""A name in a list is found by typing it."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.tui.room import NORMAL, room
from verbteach_tui.typed_name import PAUSE, TypedName

NAMES = ("kitchen-1", "kitchen-3", "living-room-1", "living-room-3", "Studio")


@pytest.mark.parametrize(
    ("typed", "name"),
    [("liv", "living-room-1"), ("k3", "kitchen-3"), ("lr3", "living-room-3"), ("S", "Studio"),
     ("kitchen-3", "kitchen-3"), ("room-3", "living-room-3"), ("kk", "kitchen-3"),
     ("kkk", "kitchen-1"), ("kxi", "kitchen-1")],
)  # fmt: skip
def test_letters_say_which(typed: str, name: str) -> None:
    found = TypedName(NAMES)
    current = ""
    for moment, letter in enumerate(typed):
        current = found.type(letter, moment * 0.1, current) or current
    assert current == name


def test_after_a_pause_another_name_begins() -> None:
    found = TypedName(NAMES)
    assert found.type("l", 0.0) == "living-room-1"
    assert found.type("k", PAUSE) == "kitchen-1"
    assert found.type("3", PAUSE + 0.1) == "kitchen-3"
    assert found.back(PAUSE + 0.2) == "kitchen-1"
    assert found.back(PAUSE + 0.3) is None


@given(st.text(max_size=8), st.lists(st.text(min_size=1, max_size=5), max_size=4))
def test_any_letters_find_a_name_of_the_list_or_none(typed: str, names: list[str]) -> None:
    found = TypedName(names)
    for letter in typed:
        assert found.type(letter, 0.0) in {None, *names}


async def test_f6_goes_where_the_name_says(tmp_path: Path) -> None:
    async with room(tmp_path, size=NORMAL) as here:
        await here.key("f6")
        await here.pilot.press(*"k3", "enter")
        await here.settle()
        assert here.teach.snapshot.scene == "kitchen-3"
