"""Fluents, changes, goals and actions in English, with a lexicon and without."""

from __future__ import annotations

import pytest

from tests.language.rooms import looks
from verbteach.language.distinguish import distinguish
from verbteach.language.grammar import parse
from verbteach.language.lexicon import Lexicon
from verbteach.language.wording import Wording
from verbteach.world.fluents import Literal
from verbteach.world.plan import Action


def _wording() -> Wording:
    room = looks()
    return Wording(room.lexicon, lambda thing: distinguish(thing, room))


def _bare() -> Wording:
    return Wording(Lexicon(), lambda thing: f"the {thing.partition('_')[0].lower()}")


def test_a_change_and_a_goal_are_lists_in_a_fixed_order() -> None:
    change = [Literal.parse(t) for t in ("(not (is-on Burner_1))", "(hot Kettle_1)", "(hot Water)")]
    assert _wording().changes(change) == (
        "the kettle is now hot, the water is now hot and the left burner is now off"
    )
    assert _wording().changes(reversed(change)) == _wording().changes(change)
    (boil,) = parse("boil the water")
    assert _wording().read_back(boil, change[:2]) == (
        "after boiling the water, the kettle must be hot and the left burner must be off"
    )
    assert _wording().read_back(boil, []).endswith("nothing has to be different")


def test_need_not_takes_a_goal_back() -> None:
    assert _wording().need_not(Literal.parse("(hot Kettle_1)")) == "the kettle need not be hot"
    assert _wording().need_not(Literal.parse("(not (hot Kettle_1))")) == "the kettle may be hot"


def test_why_an_action_cannot_be_done() -> None:
    room = looks()
    needs = [Literal.parse("(open Fridge_1)"), Literal.parse("(not (dirty Mug_1))")]
    assert _wording().why_not(needs, room.state) == "the fridge is closed"
    assert _wording().why_not([]) == ""


def test_actions_in_three_forms() -> None:
    go = Action("moveto", ("Kettle_1",))
    assert _wording().action(go) == "go to the kettle"
    assert _wording().acting(go) == "going to the kettle"
    assert _wording().acts(go) == "goes to the kettle"


@pytest.mark.parametrize(
    ("text", "clause", "doing"),
    [
        ("fill the cup with water", "fill the cup with water", "filling the cup with water"),
        ("turn the tv on", "turn on the tv", "turning on the tv"),
        ("turn it on", "turn it on", "turning it on"),
        ("don't open it", "not open it", "not opening it"),
        ("don't open the window", "not open the window", "not opening the window"),
        ("put it there", "put it there", "putting it there"),
        ("put the lid on the pot", "put the lid on the pot", "putting the lid on the pot"),
    ],
)
def test_commands_as_clauses_and_gerunds(text: str, clause: str, doing: str) -> None:
    (frame,) = parse(text)
    assert _wording().clause(frame) == clause
    assert _wording().doing(frame) == doing


@pytest.mark.parametrize(
    ("fluent", "text"),
    [
        ("(On Mug_1 Table_1)", "the mug is on the table"),
        ("(next-to Mug_1 Table_1)", "the mug is next to the table"),
        ("(Grasping Robot Mug_1)", "the robot is grasping the mug"),
        ("(IsGraspable Mug_1)", "the mug is graspable"),
        ("(is-on Tv_1)", "the tv is on"),
        ("(contains Mug_1 Water)", "the mug contains the water"),
        ("(washes Robot Mug_1)", "the robot washes the mug"),
        ("(filled Mug_1 Water)", "the mug is filled with the water"),
        ("(colour Mug_1 Red)", "the colour of the mug is the red"),
        ("(dark)", "it is dark"),
        ("(not (hot Mug_1))", "the mug is not hot"),
        ("(between Mug_1 Cup_1 Bowl_1)", "the mug is between the cup and the bowl"),
    ],
)
def test_a_predicate_without_wording_is_read_off_its_name(fluent: str, text: str) -> None:
    assert _bare().describe(Literal.parse(fluent)) == text


@pytest.mark.parametrize(
    ("action", "text"),
    [
        ("moveto Mug_1", "move to the mug"),
        ("put-on Mug_1 Table_1", "put the mug on the table"),
        ("pour-into Mug_1 Bowl_1", "pour the mug into the bowl"),
        ("turn-on Tv_1", "turn on the tv"),
        ("cut Bread_1 Knife_1", "cut the bread with the knife"),
        ("wait", "wait"),
    ],
)
def test_an_action_without_wording_is_read_off_its_name(action: str, text: str) -> None:
    assert _bare().action(Action.parse(action)) == text
