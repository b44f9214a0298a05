"""What people say about a goal that was read to them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.language.goal_talk import How, read_goal_talk


@pytest.mark.parametrize(
    ("text", "how", "named"),
    [
        ("only the kettle", How.ONLY, "the kettle"),
        ("only that the kettle is on", How.ONLY, "the kettle is on"),
        ("the kettle must be on, nothing else", How.ONLY, "the kettle must be on"),
        ("everything except the tap", How.ALL_BUT, "the tap"),
        ("all of it but not the tap", How.ALL_BUT, "the tap"),
        ("keep everything except for the tap", How.ALL_BUT, "the tap"),
        ("everything", How.ALL, ""),
        ("not the lid", How.WITHOUT, "the lid"),
        ("no, not the lid", How.WITHOUT, "the lid"),
        ("forget about the lid", How.WITHOUT, "the lid"),
        ("also the lid", How.WITH, "the lid"),
        ("the lid too", How.WITH, "the lid"),
        ("yes, and the burner must be off", How.WITH, "the burner must be off"),
        ("the mug should be clean", How.SAYS, "the mug should be clean"),
        ("no. the mug should be clean", How.SAYS, "the mug should be clean"),
    ],
)
def test_it_is_told_what_becomes_of_what_is_named(text: str, how: How, named: str) -> None:
    talk = read_goal_talk(text)
    assert talk is not None
    assert (talk.how, " ".join(talk.tokens)) == (how, named)


@pytest.mark.parametrize("text", ["", "yes", "no", "no, wrong", "yes, exactly", "well ..."])
def test_a_label_alone_speaks_of_no_part(text: str) -> None:
    assert read_goal_talk(text) is None


def test_the_label_before_it_is_told() -> None:
    for text, label in (("no, the tap", (True, False)), ("yes, the tap", (False, True))):
        talk = read_goal_talk(text)
        assert talk is not None
        assert (talk.said_no, talk.said_yes) == label


def test_right_of_the_sink_is_no_yes() -> None:
    talk = read_goal_talk("right of the sink")
    assert talk is not None
    assert not talk.said_yes


@given(st.text())
def test_any_text_is_read(text: str) -> None:
    read_goal_talk(text)
