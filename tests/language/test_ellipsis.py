"""Commands that lean on the last one, and those that only look like it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.language.rooms import phrase
from verbteach.language.ellipsis import applied, read_ellipsis
from verbteach.language.grammar import parse
from verbteach.language.notation import write_frames


@pytest.mark.parametrize(
    ("text", "about"),
    [
        ("again", ""),
        ("Do it again, please!", ""),
        ("same with the mug", "the mug"),
        ("do the same with the plastic mug", "the plastic mug"),
        ("now the plastic one", "the plastic one"),
        ("and the kettle too", "the kettle"),
        ("another one", "another one"),
    ],
)
def test_the_last_command_is_leant_on(text: str, about: str) -> None:
    found = read_ellipsis(text)
    assert found is not None
    assert found.about == about


@pytest.mark.parametrize(
    "text",
    ["", "the mug", "take the mug again", "now open the fridge", "and put it in the sink",
     "now the fridge is open", "do it with the sponge"],
)  # fmt: skip
def test_whole_commands_and_statements_are_not(text: str) -> None:
    assert read_ellipsis(text) is None


def test_another_thing_takes_the_place_of_the_object() -> None:
    (frame,) = parse("put the mug in the sink")
    told = write_frames([applied(frame, phrase("the red plate"))])
    assert told == "put(obj=plate[red]; in=sink)"


@given(st.text(max_size=40))
def test_any_text_is_read(text: str) -> None:
    found = read_ellipsis(text)
    assert found is None or found.about.strip() == found.about
