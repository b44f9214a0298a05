"""What an answer came to, in one line."""

from __future__ import annotations

import pytest

from tests.dialogue.stage import robot, tell
from verbteach.dialogue import acts
from verbteach.dialogue.speech import Speech
from verbteach_tui.consequences import consequence


@pytest.mark.parametrize(
    ("command", "answer", "line"),
    [
        ("take the plate", "the blue one", 'I am now sure that "the plate" is the blue plate.'),
        (
            "take the unicorn",
            "there is none",
            'I go on without "the unicorn"; to leave the command, skip.',
        ),
        ("take the plate", "I don't know", ""),
    ],
)
def test_an_answer_is_followed_by_what_it_came_to(command: str, answer: str, line: str) -> None:
    listener = robot()
    tell(listener, acts.Command(command))
    before = listener.state.episode
    speech = Speech.of(listener.setting, listener.state.world)
    tell(listener, acts.Say(answer))
    assert consequence(before, listener.state.episode, speech) == line
