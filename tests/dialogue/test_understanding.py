"""What the teacher's words mean in a room: sources, "the one ...", and typing errors."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.dialogue.stage import robot, shown, taught_to_boil, tell
from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.turn import RobotTurn
from verbteach.world.fluents import Fluent, Literal


def asked(listener: Robot, *said: str) -> RobotTurn:
    command, *answers = said
    return tell(listener, acts.Command(command), *map(acts.Say, answers))


def meant(listener: Robot, phrase: str) -> set[str]:
    episode = listener.state.episode
    assert episode is not None
    return {thing for thing, _ in episode.grounding[phrase]}


@pytest.mark.parametrize(
    ("command", "phrases"),
    [
        ("take the apple from the bowl", {"apple": "Apple_1", "bowl": "Bowl_1"}),
        ("take the mug out of the cupboard", {"mug": "Mug_3", "cupboard": "Cupboard_1"}),
        ("grab the mug off the table", {"mug": "Mug_1", "table": "Table_1"}),
    ],
)
def test_what_is_taken_from_somewhere_is_there(command: str, phrases: dict[str, str]) -> None:
    listener = robot()
    asked(listener, command)
    for word, thing in phrases.items():
        assert meant(listener, f"the {word}") == {thing}


def test_where_nothing_is_there_both_phrases_stay_open() -> None:
    listener = robot()
    asked(listener, "take the cup from the bowl")
    assert len(meant(listener, "the cup")) > 1
    assert meant(listener, "the bowl") == {"Bowl_1", "Bowl_2"}


def test_the_one_is_one_of_those_that_were_asked_about() -> None:
    """The sponge is next to the sink, and is no plate."""
    listener = robot()
    turn = asked(listener, "take the plate", "the one next to the sink")
    assert meant(listener, "the plate") == {"Plate_1", "Plate_2"}
    assert any("next to the sink" in text for text in texts(turn))
    tell(listener, acts.Say("the one on the table"))
    assert meant(listener, "the plate") == {"Plate_2"}


def test_the_other_one_means_nothing_before_anything_was_spoken_of() -> None:
    listener = robot()
    asked(listener, "grab the other one")
    assert meant(listener, "the other one") == set()


def test_a_misspelled_description_is_offered_and_not_taken() -> None:
    listener = robot()
    turn = asked(listener, "take the plate", "the bleu one")
    assert any('Did you mean "the blue one"?' in text for text in texts(turn))
    assert meant(listener, "the plate") == {"Plate_1", "Plate_2"}


def test_a_noun_and_the_word_before_it_may_both_be_misspelled() -> None:
    turn = asked(robot(), "boil teh watter")
    assert isinstance(turn.waiting_act, acts.NpGrdYnq)
    assert turn.waiting_act.object == "Water"


GRAB = ("moveto Mug_2", "grasp Mug_2")


@pytest.mark.parametrize(
    ("said", "corrected", "things"),
    [
        (["grab the spoon"], "no, the wooden one", {"Ladle_1"}),
        (["grab the red mug", "the plastic one"], "no, the other one", {"Mug_1"}),
        (["grab the plastic mug"], "no, the ceramic one", {"Mug_1", "Mug_2"}),
    ],
)
def test_a_correction_names_another_thing_or_several(
    said: list[str], corrected: str, things: set[str]
) -> None:
    listener = robot()
    tell(listener, acts.Command("grab the blue mug"), *shown(*GRAB), acts.Good())
    turn = asked(listener, *said)
    assert turn.phase is Phase.JUDGEMENT
    tell(listener, acts.Say(corrected))
    assert meant(listener, said[0].removeprefix("grab ")) == things


@pytest.mark.parametrize(
    ("said", "burner"),
    [
        ("no, the back burner", "Burner_2"),
        ("I meant the back burner", "Burner_2"),
        ("no, the other one", "Burner_2"),
        ("not the front burner, the back one", "Burner_2"),
        ("no, the front burner", None),
        ("no, the window", None),
        ("no, the water", None),
    ],
)
def test_a_correction_names_a_thing_that_the_robot_chose_itself(
    said: str, burner: str | None
) -> None:
    """Nobody had spoken of a burner in kitchen-3, which has two."""
    listener = taught_to_boil()
    before = tell(listener, acts.GoToScene("kitchen-3"), acts.Command("boil the water"))
    start = listener.state.episode.start if listener.state.episode else frozenset()
    assert "Burner_1" in str(before.waiting_act)
    turn = tell(listener, acts.Say(said))
    if burner is None:
        assert turn.phase is Phase.DEMONSTRATION
        assert listener.state.world == start
    else:
        assert turn.phase is Phase.JUDGEMENT
        assert Fluent("on", ("Kettle_1", burner)) in listener.state.world
        assert turn.reward < 0
        assert "put everything back" in turn.texts[-1]
        assert "You said" in listener.explain()[0]
        tell(listener, acts.Good())
        assert listener.turn.phase is Phase.COMMAND


def test_a_correction_turns_what_should_have_left_a_place_round() -> None:
    """The kettle stands on the back burner, so that a goal may say that it should not any more."""
    listener = taught_to_boil()
    tell(listener, acts.GoToScene("kitchen-3"), acts.Command("boil the water"))
    episode = listener.state.episode
    assert episode is not None
    assert episode.execution is not None
    gone = Literal(Fluent("on", ("Kettle_1", "Burner_2")), positive=False)
    execution = replace(episode.execution, goal=episode.execution.goal | {gone})
    listener.state = replace(listener.state, episode=replace(episode, execution=execution))
    waiting = tell(listener, acts.Say("no, the back burner")).waiting_act
    assert isinstance(waiting, acts.SelectHypo)
    assert Literal(Fluent("on", ("Kettle_1", "Burner_1")), positive=False) in waiting.goal
    assert Fluent("on", ("Kettle_1", "Burner_2")) in listener.state.world


def test_words_that_correct_nothing_are_asked_about_again() -> None:
    listener = taught_to_boil()
    tell(listener, acts.GoToScene("kitchen-3"))
    turn = asked(listener, "boil the water", "the window")
    assert turn.phase is Phase.JUDGEMENT
    assert any("Say yes if it was right" in text for text in texts(turn))


def texts(turn: RobotTurn) -> list[str]:
    return [act.reason for act in turn.acts if isinstance(act, acts.AskAgain)]
