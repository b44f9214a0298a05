"""Corrections in words: what was meant, and what it was taken for."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.language.corrections import Correction, read_correction


@pytest.mark.parametrize(
    ("text", "meant", "wrong"),
    [
        ("no, the other pot", "the other pot", ""),
        ("No! Not that one, the other one.", "the other one", ""),
        ("I meant the back burner", "the back burner", ""),
        ("the back burner instead, please", "the back burner", ""),
        ("wrong, it should be on the back burner", "the back burner", ""),
        ("no no, the pot I meant", "the pot", ""),
        ("no, kettle", "kettle", ""),
        ("not the left one, the right one", "the right one", "the left one"),
        ("no, not the kettle but the pot", "the pot", "the kettle"),
        ("the pot, not the kettle", "the pot", "the kettle"),
        ("use the pot instead of the kettle", "the pot", "the kettle"),
    ],
)
def test_what_was_meant_is_read(text: str, meant: str, wrong: str) -> None:
    assert read_correction(text) == Correction(meant, wrong, " on the " in text)


@pytest.mark.parametrize(
    "text", ["", "no", "yes", "stop", "not the kettle", "boil it again", "kettle", "that was wrong"]
)
def test_other_words_correct_nothing(text: str) -> None:
    assert read_correction(text) is None


@given(st.text(alphabet=st.sampled_from("no ,.tiheamwrgbus"), max_size=40) | st.text())
def test_any_text_is_read(text: str) -> None:
    found = read_correction(text)
    assert found is None or found.meant.strip() == found.meant != ""
