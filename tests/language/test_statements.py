"""Sentences about how things should be, read as statements."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.language.statements import Statement, read_statements
from verbteach.language.tokens import spelled_out, tokenise


def read(text: str) -> list[tuple[str, str, bool, bool]]:
    found = read_statements(tokenise(spelled_out(text)))
    return [(" ".join(s.subject), " ".join(s.said), s.positive, s.needed) for s in found]


@pytest.mark.parametrize(
    ("text", "subject", "said", "positive", "needed"),
    [
        ("the mug should be in the sink", "the mug", "in the sink", True, True),
        ("the mug must not be in the sink", "the mug", "in the sink", False, True),
        ("the mug shouldn't be in the sink", "the mug", "in the sink", False, True),
        ("mug must in sink", "mug", "in sink", True, True),
        ("it's supposed to be open", "it", "open", True, True),
        ("the tap has to be off at the end", "the tap", "off", True, True),
        ("make sure that the tap is closed", "the tap", "closed", True, True),
        ("should be in the sink", "it", "in the sink", True, True),
        ("the cup belongs in the cupboard", "the cup", "in the cupboard", True, True),
        ("the tap doesn't have to be off", "the tap", "off", True, False),
        ("the tap need not be off", "the tap", "off", True, False),
        ("the tap does not matter", "the tap", "", True, False),
        ("the tap isn't important at all", "the tap", "", True, False),
        ("the tap matters", "the tap", "", True, True),
        ("i want the mug on the table", "", "the mug on the table", True, True),
    ],
)
def test_a_statement_is_parted(
    text: str, subject: str, said: str, positive: bool, needed: bool
) -> None:
    assert read(text) == [(subject, said, positive, needed)]


def test_several_statements_are_read_in_order_and_those_without_a_verb_stay_whole() -> None:
    found = read("the mug should be in the sink and the tap closed, but the light need not be on")
    assert found == [
        ("the mug", "in the sink", True, True),
        ("", "the tap closed", True, True),
        ("the light", "on", True, False),
    ]


def test_what_was_says_nothing_of_what_should_be() -> None:
    assert read("it was already open") == [("", "it was already open", True, True)]


@given(
    st.lists(
        st.sampled_from(
            [
                "the",
                "mug",
                "tap",
                "should",
                "be",
                "not",
                "in",
                "sink",
                "and",
                ",",
                ".",
                "only",
                "is",
            ]
        )
    )
)
def test_no_words_are_invented(words: list[str]) -> None:
    for statement in read_statements(words):
        assert isinstance(statement, Statement)
        assert {*statement.subject, *statement.said} <= {*words, "it"}
