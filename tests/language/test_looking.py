"""Questions in the clothes of commands."""

from __future__ import annotations

import pytest

from verbteach.language.grammar import parse
from verbteach.language.looking import asks_whether_able, is_looking, what_it_can


@pytest.mark.parametrize(
    ("text", "asks"),
    [
        ("can you fly?", True),
        ("hey robot, can you sing", True),
        ("are you able to swim?", True),
        ("could you dance", True),
        ("could you please dance", False),
        ("can you dance for me?", False),
        ("you can dance", False),
        ("dance", False),
    ],
)
def test_whether_it_asks_what_the_robot_can(text: str, asks: bool) -> None:
    assert asks_whether_able(text) is asks


def test_what_is_asked_for_is_what_stands_behind() -> None:
    assert what_it_can("Can you open the fridge?") == "open the fridge?"
    assert what_it_can("open the fridge") == ""


@pytest.mark.parametrize(
    ("command", "looks"),
    [
        ("look at the fridge", True),
        ("find the mug", True),
        ("search for the mug", True),
        ("show me the kettle", True),
        ("show the kettle", False),
        ("open the fridge", False),
    ],
)
def test_whether_only_a_look_is_asked_for(command: str, looks: bool) -> None:
    (frame,) = parse(command)
    assert is_looking(frame) is looks
