"""Near words: the distance is a metric on what people mistype, and short words stay alone."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from verbteach.language.typos import bound, distance, suggest

WORD = st.text("abcde", min_size=0, max_size=8)


def test_the_four_errors_cost_one_each() -> None:
    assert distance("table", "tabel") == 1
    assert distance("table", "tabl") == 1
    assert distance("table", "tabble") == 1
    assert distance("table", "tadle") == 1
    assert distance("table", "table") == 0
    assert distance("", "mug") == 3


@given(WORD, WORD)
def test_it_is_symmetric_and_bounded_by_the_longer_word(one: str, other: str) -> None:
    assert distance(one, other) == distance(other, one)
    assert abs(len(one) - len(other)) <= distance(one, other) <= max(len(one), len(other))
    assert (distance(one, other) == 0) == (one == other)


@given(st.text("abcde", min_size=4, max_size=10), st.lists(WORD, max_size=20))
def test_suggestions_are_known_near_and_never_the_word_itself(word: str, known: list[str]) -> None:
    found = suggest(word, known)
    assert set(found) <= set(known) - {word}
    assert all(distance(word, one) <= bound(word) for one in found)


def test_short_words_get_no_suggestion_and_the_nearest_comes_first() -> None:
    assert suggest("cup", ["cap", "cups"]) == ()
    assert suggest("tabel", ["table", "label", "cable"]) == ("label", "table")
    assert suggest("microwve", ["microwave", "kettle"]) == ("microwave",)
    assert suggest("unicorn", ["kettle", "mug"]) == ()
