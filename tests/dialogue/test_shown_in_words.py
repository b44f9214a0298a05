"""A newcomer's first demonstration, typed as people type: steps, asides, an end."""

from __future__ import annotations

import pytest

from tests.dialogue.stage import provider, robot, taught_to_boil, tell
from verbteach.dialogue import acts
from verbteach.dialogue.moves import IllegalMoveError, Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.robot import Robot
from verbteach.perception.noise import NoiseModel
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy


def asked(command: str = "boil the water", scene: str = "kitchen-1") -> Robot:
    pupil = robot(scene)
    tell(pupil, acts.Command(command))
    return pupil


def said(pupil: Robot, *lines: str) -> str:
    return " ".join(tell(pupil, *(acts.Say(line) for line in lines)).texts)


def phase(pupil: Robot) -> Phase:
    return pupil.turn.phase


def steps(pupil: Robot) -> list[str]:
    episode = pupil.state.episode
    assert episode is not None
    assert episode.demonstrated is not None
    return [str(action) for action in episode.demonstrated.actions]


def test_a_verb_is_taught_in_a_persons_own_words() -> None:
    pupil = asked()
    said(pupil, "walk to the kettle", "pick it up", "go over to the left burner")
    said(pupil, "put the kettle on the burner", "now go to the left knob", "turn it on")
    assert "the water must be hot" in said(pupil, "that's it")
    assert pupil.turn.phase is Phase.READ_BACK
    said(pupil, "yes that's right")
    assert "boil" in pupil.state.knowledge.verbs


def test_several_steps_in_one_line_are_watched_in_order() -> None:
    pupil = asked()
    turn = tell(pupil, acts.Say("go to the kettle, take it and then go to the left burner"))
    assert [type(act) for act in turn.acts] == [acts.ObserveStep] * 3
    assert turn.reading.count(";") == 2
    assert len(steps(pupil)) == 3


def test_steps_need_no_mark_between_them_and_the_end_may_stand_behind() -> None:
    pupil = asked("open the fridge")
    turn = tell(pupil, acts.Say("go to fridge open it and i am done"))
    assert turn.phase is Phase.READ_BACK
    assert turn.reading == "moveto Fridge_1; open Fridge_1"


def test_the_end_behind_a_step_that_cannot_be_done_ends_nothing() -> None:
    pupil = asked("open the fridge")
    assert tell(pupil, acts.Say("open the fridge, done")).phase is Phase.DEMONSTRATION


def test_a_line_ends_at_the_step_that_cannot_be_done() -> None:
    pupil = asked()
    assert "not near the left burner" in said(
        pupil, "go to the kettle, take it, put it on the left burner and go to the fridge"
    )
    assert len(steps(pupil)) == 2


def test_which_of_several_is_asked_once_and_the_answer_is_the_step() -> None:
    pupil = asked()
    said(pupil, "go to the kettle and take it", "go to the right burner")
    assert "Which one?" in said(pupil, "turn on the stove")
    assert "not near the right knob" in said(pupil, "the right one")
    assert "What is to be done with the right one?" in said(pupil, "the right one")


@pytest.mark.parametrize("text", ["help", "what?", "what should i do", "hello", "ok"])
def test_asides_get_a_hint_and_change_nothing(text: str) -> None:
    pupil = asked()
    assert "one step after the other" in said(pupil, text)
    assert pupil.turn.phase is Phase.DEMONSTRATION
    assert steps(pupil) == []


def test_giving_up_in_words_leaves_the_demonstration() -> None:
    pupil = asked()
    said(pupil, "never mind")
    assert pupil.turn.phase is Phase.COMMAND
    assert pupil.state.knowledge.verbs == ()


def test_a_slip_is_to_be_undone() -> None:
    pupil = asked()
    assert "say undo" in said(pupil, "go to the kettle", "no not that one")
    assert len(steps(pupil)) == 1


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("help", "Tell me what to do"),
        ("skip", "nothing that I am asking"),
        ("hello robot", "Hello."),
        ("bye", "say quit"),
        ("no not that one", "say undo"),
        ("asdf qwer", "none of these words"),
        ("opn the fridge", 'Did you mean "open"'),
        ("", "I heard nothing"),
    ],
)
def test_what_is_no_command_is_answered_with_how_to_go_on(text: str, hint: str) -> None:
    pupil = robot()
    assert hint in " ".join(tell(pupil, acts.Command(text)).texts)
    assert pupil.turn.phase is Phase.COMMAND


def test_the_example_command_fits_the_room() -> None:
    assert "open the window" in " ".join(tell(robot(), acts.Command("help")).texts)


def test_a_made_up_verb_may_be_taught() -> None:
    turn = tell(robot(), acts.Command("blick the kettle"))
    assert turn.phase is Phase.DEMONSTRATION


def test_an_unknown_word_for_an_article_is_asked_about() -> None:
    turn = tell(robot("kitchen-1"), acts.Command("open ze fridge"))
    assert turn.texts == ('I do not know "ze fridge". Do you mean the fridge?',)


def test_fingers_that_turn_an_article_round_are_understood() -> None:
    turn = tell(robot("kitchen-1"), acts.Command("open teh fridge"))
    assert turn.phase is Phase.DEMONSTRATION
    assert turn.reading == "open the fridge"


def test_of_several_things_one_is_asked_for_in_good_english() -> None:
    turn = tell(robot(), acts.Command("wash the dishes"))
    assert 'Which one do you mean by "the dishes"' in turn.texts[-1]


@pytest.mark.parametrize("text", ["there is none", "skip it", "never mind"])
def test_a_question_can_be_passed_over_in_words(text: str) -> None:
    pupil = asked("wash the dishes")
    assert phase(pupil) is Phase.EXECUTION
    said(pupil, text)
    assert phase(pupil) is Phase.DEMONSTRATION


def test_a_puzzled_answer_is_told_how_to_go_on() -> None:
    assert "say why" in said(asked("wash the dishes"), "what do you mean?")


def test_an_unclear_verdict_is_asked_for_again_in_whole_sentences() -> None:
    pupil = asked("move the bread")
    said(pupil, "go to the bread and take it", "go to the counter", "put it down", "done")
    assert phase(pupil) is Phase.READ_BACK
    for text in ("maybe", "what?", "the bread"):
        assert said(pupil, text).startswith("Say yes if this is the goal")
    said(pupil, "never mind")
    assert phase(pupil) is Phase.COMMAND


@pytest.mark.parametrize(
    ("act", "words"),
    [(acts.Yes(), "to be shown: a step, or done"), (acts.Command("stop"), "to be shown")],
)
def test_a_misfit_says_in_plain_words_what_would_fit(act: acts.TeacherAct, words: str) -> None:
    with pytest.raises(IllegalMoveError, match=words):
        asked().receive(act)


def test_a_room_that_lacks_what_was_learned_is_told_why() -> None:
    pupil = taught_to_boil()
    turn = tell(pupil, acts.GoToScene("kitchen-4"), acts.Command("boil the water"))
    assert turn.phase is Phase.DEMONSTRATION
    assert turn.texts[-1].startswith("I know boiling the water from elsewhere, but I see no burner")


def test_what_was_done_is_told_in_the_past() -> None:
    pupil = taught_to_boil()
    turn = tell(pupil, acts.GoToScene("kitchen-3"), acts.Command("boil the water"))
    assert "I went to the kettle, took the kettle" in turn.texts[-1]


def test_uncertain_eyes_say_that_they_are_uncertain() -> None:
    blurred = RobotParameters(seed=2, noise=NoiseModel.named("std3", "literal"))
    pupil = Robot(provider, DemonstrationOnlyPolicy(), blurred)
    pupil.open("kitchen-1")
    tell(pupil, acts.Command("open the fridge"))
    told = said(pupil, "go to the fridge, open it", "done")
    assert told.index("the fridge must be open") < told.index("the apple must be"), "handled first"


def test_what_uncertain_eyes_only_believe_to_have_changed_is_said_so_and_briefly() -> None:
    blurred = RobotParameters(seed=3, noise=NoiseModel.named("std3", "literal"))
    pupil = Robot(provider, DemonstrationOnlyPolicy(), blurred)
    pupil.open("kitchen-1")
    tell(pupil, acts.Command("open the fridge"))
    told = said(pupil, "go to the fridge, open it", "done")
    assert "It looks to me as if" in told
    assert "and 3 more things have changed, but I am not sure" in told


def test_an_action_without_its_object_is_asked_for_and_leaving_is_told() -> None:
    pupil = asked()
    assert 'Say it as "open …"' in said(pupil, "open")
    assert "say quit" in said(pupil, "how do I leave")
    assert phase(pupil) is Phase.DEMONSTRATION
