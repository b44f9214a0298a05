"""Which of several things is meant, in the words that people use for it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.language.choices import Choice, Chosen, read_choice
from verbteach.language.wordlist import word_set

VERBS = {"open", "put", "boil"}


@pytest.mark.parametrize(
    ("text", "named", "denied"),
    [
        ("the blue one, please", ("the blue one",), ()),
        ("I think it's the blue one", ("the blue one",), ()),
        ("on the table", ("the one on the table",), ()),
        ("the one that's on the table", ("the one on the table",), ()),
        ("first", ("the first one",), ()),
        ("the blue one or the red one", ("the blue one", "the red one"), ()),
        ("not the red one", (), ("the red one",)),
        ("anything but the red one", (), ("the red one",)),
        ("not the red one but the blue one", ("the blue one",), ("the red one",)),
        ("the blue one, not the red one", ("the blue one",), ("the red one",)),
        ("open ones", ("open ones",), ()),
    ],
)
def test_words_for_things_are_told_from_those_for_others(
    text: str, named: tuple[str, ...], denied: tuple[str, ...]
) -> None:
    assert read_choice(text, VERBS) == Choice(Chosen.NAMED, named, denied)


@pytest.mark.parametrize(
    ("text", "index"), [("2", 1), ("two", 1), ("number two", 1), ("no. 2", 1), ("the 3", 2)]
)
def test_a_number_counts_in_the_list(text: str, index: int) -> None:
    assert read_choice(text).index == index


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("any of them", Chosen.ANY),
        ("you choose", Chosen.ANY),
        ("both", Chosen.ALL),
        ("the first two", Chosen.ALL),
        ("the red and the blue one", Chosen.ALL),
        ("that one", Chosen.POINTED),
        ("something else", Chosen.OTHER),
        ("there's no banjo here", Chosen.ABSENT),
        ("open the fridge", Chosen.NONE),
        ("where is it?", Chosen.NONE),
        ("", Chosen.NONE),
    ],
)
def test_what_names_no_single_thing_is_of_another_kind(text: str, kind: Chosen) -> None:
    assert read_choice(text, VERBS).kind is kind


_WORDS = st.sampled_from(
    sorted(word_set("the not but no one two first or and blue mug on it is i think any please 2 ,"))
)


@given(st.lists(_WORDS, max_size=9).map(" ".join) | st.text(max_size=30))
def test_any_text_is_read_and_names_are_words(text: str) -> None:
    choice = read_choice(text, VERBS)
    assert all(words.strip() == words != "" for words in (*choice.named, *choice.denied))
    assert choice.index is None or choice.index >= 0
