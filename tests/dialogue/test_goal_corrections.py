"""After an execution: how things should be instead, in the teacher's words."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.dialogue.stage import robot, shown, tell
from tests.dialogue.utterances import SETTINGS
from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.turn import RobotTurn
from verbteach.world.fluents import Fluent
from verbteach_sessions.header import Header
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Undo


def taken() -> Robot:
    """A robot that has just taken the blue mug, and awaits judgement."""
    pupil = robot()
    tell(pupil, acts.Command("take the blue mug"), *shown("moveto Mug_2", "grasp Mug_2"))
    tell(pupil, acts.Good(), acts.GoToScene("kitchen-1"), acts.Command("take the blue mug"))
    assert pupil.turn.phase is Phase.JUDGEMENT
    return pupil


def said(pupil: Robot, text: str) -> RobotTurn:
    return tell(pupil, acts.Say(text))


@pytest.mark.parametrize(
    ("text", "holds"),
    [
        ("no, put it in the sink", ["(in Mug_2 Sink_1)"]),
        ("wrong, it should be in the sink", ["(in Mug_2 Sink_1)"]),
        ("no, open the fridge too", ["(grasping Robot Mug_2)", "(open Fridge_1)"]),
        ("no, the tap must be on", ["(grasping Robot Mug_2)", "(is-on Tap_1)"]),
        ("no, put it on the table and open the fridge", ["(on Mug_2 Table_1)", "(open Fridge_1)"]),
        ("no, take it and put it on the table", ["(on Mug_2 Table_1)"]),
    ],
)
def test_the_goal_is_put_right_and_carried_out_from_the_start(text: str, holds: list[str]) -> None:
    pupil = taken()
    turn = said(pupil, text)
    assert turn.phase is Phase.JUDGEMENT
    assert turn.reward < 0
    assert "put everything back" in turn.texts[-1]
    assert {Fluent.parse(one) for one in holds} <= pupil.state.world
    assert tell(pupil, acts.Good()).phase is Phase.COMMAND


def test_how_to_go_about_it_is_to_be_shown() -> None:
    pupil = taken()
    turn = said(pupil, "no, open the cupboard first")
    assert turn.phase is Phase.DEMONSTRATION
    assert "show me one step after the other" in turn.texts[0]
    assert Fluent.parse("(grasping Robot Mug_2)") not in pupil.state.world


def test_the_command_said_again_in_other_words_is_begun_anew() -> None:
    pupil = taken()
    said(pupil, "no, take the plate out of the cupboard")
    assert pupil.state.episode is not None
    assert pupil.state.episode.command == "take the plate out of the cupboard"
    assert Fluent.parse("(grasping Robot Mug_2)") not in pupil.state.world


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("no, put it in the dragon", 'nothing here that I would call "the dragon"'),
        ("no, it belongs in the cupboard", "Which do you mean"),
        ("no, it must be on the counter", "That was so before I began"),
    ],
)
def test_what_cannot_be_done_is_told_with_the_judgement_still_open(text: str, told: str) -> None:
    pupil = taken()
    world = pupil.state.world
    turn = said(pupil, text)
    assert turn.phase is Phase.JUDGEMENT
    assert told in turn.texts[0]
    assert pupil.state.world == world


def test_a_bare_command_may_be_the_next_one_and_corrects_nothing() -> None:
    pupil = taken()
    assert "Say yes if it was right" in said(pupil, "put it in the sink").texts[0]


def test_corrections_in_words_are_undone_and_replayed(tmp_path: Path) -> None:
    session = Session.create(tmp_path, Header.new("kitchen-1"), SETTINGS)
    session.perform(acts.Command("take the blue mug"), raw="", via="pipe")
    for act in (*shown("moveto Mug_2", "grasp Mug_2"), acts.Say("only that you hold the blue mug")):
        session.perform(act, raw="", via="pipe")
    for act in (acts.Good(), acts.GoToScene("kitchen-1"), acts.Command("take the blue mug")):
        session.perform(act, raw="", via="pipe")
    before = session.robot.state.digest
    for text in ("no, put it in the sink", "no, take the plate out of the cupboard"):
        session.perform(acts.Say(text), raw=text, via="pipe")
        assert session.robot.state.digest != before
        session.perform(Undo(), raw="undo", via="pipe")
        assert session.robot.state.digest == before
    session.perform(acts.Say("no, put it in the sink"), raw="", via="pipe")
    session.perform(acts.Good(), raw="", via="pipe")
    session.close()
    (record,) = tmp_path.iterdir()
    assert verify(record, SETTINGS).verified


PUT = ("moveto Mug_2", "grasp Mug_2", "moveto Sink_1", "drop-in Mug_2 Sink_1")


def test_the_command_said_anew_is_learned_with_the_goal_that_it_tells() -> None:
    """What "put X in Y" asks for leads nowhere on a counter; the words say what is meant there."""
    pupil = robot()
    tell(pupil, acts.Command("put the blue mug in the sink"), *shown(*PUT), acts.Good())
    tell(pupil, acts.Command("put the white plate in the sink"))
    turn = said(pupil, "no, put it on the counter")
    assert turn.phase is Phase.JUDGEMENT
    assert turn.reading == "put the white plate on the counter"
    assert Fluent.parse("(on Plate_1 Counter_1)") in pupil.state.world
    tell(pupil, acts.Good(), acts.Command("put the blue plate on the counter"))
    assert Fluent.parse("(on Plate_2 Counter_1)") in pupil.state.world


def test_both_are_two_and_no_third_is_chosen() -> None:
    pupil = taken()
    assert "Which do you mean" in said(pupil, "no, both mugs should be in the sink").texts[0]
    said(pupil, "no, both plates should be in the sink")
    wanted = {Fluent.parse(f"(in {plate} Sink_1)") for plate in ("Plate_1", "Plate_2")}
    assert wanted <= pupil.state.world
