"""The robot speaks of itself as "I", and of everything else as before."""

from __future__ import annotations

import pytest

from verbteach.language.first_person import first_person
from verbteach.language.inflection import past
from verbteach_scenarios.lexicon_file import load_lexicon


@pytest.mark.parametrize(
    ("told", "said"),
    [
        ("So far: the robot is now near the cup.", "So far: I am now near the cup."),
        (
            "That cannot be done: the robot is not near it.",
            "That cannot be done: I am not near it.",
        ),
        ("Is the robot holding the cup?", "Am I holding the cup?"),
        ("the robot no longer has both hands full", "I no longer have both hands full"),
        ("The robot has both hands full.", "I have both hands full."),
        ("does the robot have both hands full?", "do I have both hands full?"),
        ("the robot does not have both hands full", "I do not have both hands full"),
        ("the robot must be near the cup", "I must be near the cup"),
        ("Should the robot be near the cup?", "Should I be near the cup?"),
        ("the robot need not be near it", "I need not be near it"),
        ("I see the toy robot, is that the robot?", "I see the toy robot, is that the robot?"),
        ("the robot vacuum is on", "the robot vacuum is on"),
    ],
)
def test_of_itself_the_robot_says_i(told: str, said: str) -> None:
    assert first_person(told) == said


def test_nothing_the_bundled_words_say_of_the_robot_stays_in_the_third_person() -> None:
    fluents = load_lexicon().fluents
    for predicate in ("near", "grasping", "carrying", "hands-full"):
        for sentence in vars(fluents[predicate]).values():
            own = first_person(sentence.format("the robot", "the cup"))
            assert "the robot" not in own, sentence
            assert "I " in own, sentence


def test_the_past_of_every_bundled_action_is_english() -> None:
    verbs = {words.split()[0] for words in load_lexicon().actions.values()}
    assert {verb: past(verb) for verb in verbs if past(verb) != f"{verb}ed"} == {
        "close": "closed", "cut": "cut", "drizzle": "drizzled", "drop": "dropped",
        "empty": "emptied", "go": "went", "light": "lit", "put": "put",
        "set": "set", "squeeze": "squeezed", "stir": "stirred", "stop": "stopped",
        "take": "took", "tip": "tipped", "wipe": "wiped",
    }  # fmt: skip
