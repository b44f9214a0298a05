"""Where a second reader reads a command differently, the robot asks before it acts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import pytest

from tests.dialogue.stage import BOIL, provider, robot, shown, tell
from verbteach.dialogue import acts
from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Setting
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.language.agreement import SecondReader
from verbteach.language.frames import VerbFrame
from verbteach.language.grammar import parse
from verbteach.policy.demonstration_only import DemonstrationOnlyPolicy
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action

PUT = "put the red mug on the table"
BOTH = "take the red mug and put it on the table"


class Reads:
    """A second reader that reads one text as if another had been said, and counts."""

    def __init__(self, instead: Mapping[str, str]) -> None:
        self.instead = instead
        self.heard: list[str] = []

    def read(self, text: str) -> tuple[VerbFrame, ...]:
        self.heard.append(text)
        return parse(self.instead.get(text, text))


def listening(second: SecondReader) -> Robot:
    def settings(scene: str) -> Setting:
        return replace(provider(scene), second=second)

    found = Robot(settings, DemonstrationOnlyPolicy())
    found.open("kitchen-1")
    return found


def same_talk(one: Robot, other: Robot, *said: acts.TeacherAct) -> None:
    for act in said:
        assert one.receive(act) == other.receive(act)
        assert one.state.digest == other.state.digest


def test_where_both_agree_nothing_is_different() -> None:
    said = [acts.Command("boil the water"), *shown(*BOIL), acts.Good(), acts.Command(BOTH)]
    same_talk(listening(Reads({})), robot(), *said)


def test_a_second_reader_that_finds_nothing_disputes_nothing() -> None:
    same_talk(listening(Reads({PUT: ""})), robot(), acts.Command(PUT))


@pytest.mark.parametrize(
    "other",
    [
        "take the red mug on the table",
        "put the red mug under the table",
        "put the table on the mug",
    ],
    ids=["verb", "role", "heads"],
)
def test_another_reading_is_asked_about_before_anything_is_done(other: str) -> None:
    listener = listening(Reads({PUT: other}))
    before = listener.state
    turn = tell(listener, acts.Command(PUT))
    asked = turn.waiting_act
    assert isinstance(asked, acts.AskRephrase)
    assert asked.reason == f"I read that as: {PUT}. Is that what you mean?"
    assert turn.texts == (asked.reason,)
    assert turn.phase is Phase.COMMAND
    assert listener.state.suggested == PUT
    assert listener.state.episode is None
    assert listener.state.world == before.world
    assert listener.state.totals == before.totals


def test_a_yes_goes_on_with_just_the_reading_that_was_offered() -> None:
    second = Reads({PUT: "take the red mug", "yes": "take the red mug"})
    listener = listening(second)
    tell(listener, acts.Command(PUT))
    turn = tell(listener, acts.Command("yes"))
    plain = robot()
    assert turn == tell(plain, acts.Command(PUT))
    assert listener.state.episode == plain.state.episode
    assert second.heard == [PUT]
    assert listener.state.digest == plain.state.digest


def test_a_command_of_several_clauses_is_offered_whole() -> None:
    listener = listening(Reads({BOTH: "take the red mug"}))
    tell(listener, acts.Command(BOTH))
    offered = listener.state.offered
    assert [frame.verb for frame in offered] == ["take", "put"]
    assert ", then put" in listener.turn.texts[-1]
    tell(listener, acts.Command("yes"))
    assert listener.state.episode is not None
    assert listener.state.episode.frame.verb == "take"
    assert listener.state.clauses == offered[1:]


def test_a_no_asks_for_other_words_and_forgets_the_reading() -> None:
    listener = listening(Reads({PUT: "take the red mug"}))
    turn = tell(listener, acts.Command(PUT), acts.Command("no"))
    assert turn.waiting_act == acts.AskRephrase("Then please say it in other words.")
    assert listener.state.offered == ()
    assert listener.state.suggested == ""
    assert tell(listener, acts.Command("boil the water")).phase is Phase.DEMONSTRATION


def test_other_words_instead_of_an_answer_are_a_command_that_can_be_disputed_too() -> None:
    listener = listening(Reads({PUT: "take the red mug", "open the fridge": "close the fridge"}))
    turn = tell(listener, acts.Command(PUT), acts.Command("open the fridge"))
    assert turn.texts[-1].startswith("I read that as: open the fridge.")


def test_a_word_that_was_meant_is_disputed_like_any_other_command() -> None:
    listener = listening(Reads({"boil the water": "boil water off the stove"}))
    tell(listener, acts.Command("boil the water"), acts.Command("yes"), *shown(*BOIL), acts.Good())
    tell(listener, acts.Command("boik the water"))
    assert listener.state.suggested == "boil the water"
    assert listener.state.offered == ()
    assert tell(listener, acts.Command("yes")).texts[-1].startswith("I read that as: boil")


def test_going_elsewhere_takes_the_offer_back() -> None:
    listener = listening(Reads({PUT: "take the red mug"}))
    tell(listener, acts.Command(PUT), acts.GoToScene("kitchen-3"))
    assert listener.state.offered == ()
    assert isinstance(tell(listener, acts.Command("yes")).waiting_act, acts.AskRephrase)
    assert listener.state.episode is None


def test_what_is_offered_is_part_of_the_states_digest() -> None:
    listener = listening(Reads({PUT: "take the red mug"}))
    tell(listener, acts.Command(PUT))
    state = listener.state
    assert replace(state, offered=state.offered[:0]).digest != state.digest


def test_the_simulated_teacher_confirms_the_reading_of_its_lesson() -> None:
    steps = tuple(Action.parse(step) for step in BOIL)
    goal = frozenset({Literal(Fluent("hot", ("Water",)))})
    said = "boil the water"
    lesson = Lesson("boil", "kitchen-1", said, "boil", {"the water": ("Water",)}, steps, goal)
    listener = listening(Reads({said: "boil off the water"}))
    teacher = SimulatedTeacher((lesson,), listener.settings)
    answers = []
    while (act := teacher.reply(listener.turn, listener.state)) is not None:
        answers.append(act)
        listener.receive(act)
        assert len(answers) < 50
    assert answers[:2] == [acts.Command(said), acts.Command("yes")]
    assert listener.state.knowledge.verbs == ("boil",)
