"""A goal that was read back, put right in a person's own words."""

from __future__ import annotations

import pytest

from tests.dialogue.stage import BOIL, robot, shown, tell
from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.world.fluents import Goal, Literal


def asked_to_boil() -> Robot:
    pupil = robot()
    tell(pupil, acts.Command("boil the water"), *shown(*BOIL))
    return pupil


def goal(pupil: Robot) -> Goal:
    episode = pupil.state.episode
    assert episode is not None
    assert episode.read_back is not None
    return episode.read_back.goal


def literals(*texts: str) -> Goal:
    return frozenset(map(Literal.parse, texts))


HOT, PLACED, LIT = "(hot Water)", "(on Kettle_1 Burner_1)", "(is-on Burner_1)"


@pytest.mark.parametrize(
    ("said", "left"),
    [
        ("only the water", {HOT}),
        ("the kettle should be on the burner and the water hot", {HOT, PLACED}),
        ("the burner must be on too", {HOT, PLACED, LIT}),
        ("the water need not be hot", {PLACED}),
        ("not the kettle", {HOT}),
        ("the burner does not matter", {HOT}),
        ("only the water and the burner", {HOT, LIT}),
        ("the water and the kettle should be hot", {HOT, "(hot Kettle_1)"}),
    ],
)
def test_the_goal_is_what_was_said(said: str, left: set[str]) -> None:
    pupil = asked_to_boil()
    assert goal(pupil) == literals(HOT, PLACED)
    turn = tell(pupil, acts.Say(said))
    assert turn.phase is Phase.READ_BACK
    assert goal(pupil) == literals(*left)
    assert isinstance(turn.waiting_act, acts.IncludeFluent)


def test_what_was_said_is_kept_once_it_was_read_back() -> None:
    pupil = asked_to_boil()
    tell(pupil, acts.Say("only the water"), acts.Say("yes"))
    (frame,) = pupil.state.knowledge.frames.values()
    assert any(
        [str(one) for one in node.literals] == ["(hot ?0)"] and node.confirmed
        for node in frame.nodes.values()
    )


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("the burner must be off", "the left burner is on now"),
        ("not the lid", 'nothing here that I would call "the lid"'),
        ("not the fridge", "Nothing of what changed is about the fridge"),
        ("the water should sing", '"sing"'),
    ],
)
def test_what_cannot_be_taken_in_is_told_and_changes_nothing(said: str, told: str) -> None:
    pupil = asked_to_boil()
    turn = tell(pupil, acts.Say(said))
    assert told in turn.texts[0]
    assert goal(pupil) == literals(HOT, PLACED)


def test_a_yes_that_says_the_goal_again_is_a_yes() -> None:
    pupil = asked_to_boil()
    assert tell(pupil, acts.Say("yes, the water must be hot")).phase is Phase.COMMAND
