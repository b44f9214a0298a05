"""What a typed line means: the script's words, short keys, and the rest by what is waited for."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.tui.room import SETTINGS
from tests.tui.strategies import texts
from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.world.plan import Action
from verbteach_sessions import session_acts
from verbteach_sessions.header import Header
from verbteach_sessions.script import LineSyntaxError, ScriptAct, parse_line
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Quit
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.keys import ALSO, ANSWERS, ANYTIME, answer_keys, word_of
from verbteach_tui.observer import Observer
from verbteach_tui.prompts import command_example, prompt_of, step_example
from verbteach_tui.reading import Reader, lines_of
from verbteach_tui.views.labels import Labels
from verbteach_tui.views.steps import StepBook, StepMenu
from verbteach_tui.views.wording import Wording

SETTING = SETTINGS("kitchen-1")
BOOK = StepBook(SETTING.task, Wording(Labels.of(SETTING.scene), SETTING.lexicon))
MENU = StepMenu(BOOK, SETTING.scene.initial)
GO = Action("moveto", ("Fridge_1",))


@pytest.mark.parametrize(
    ("phase", "line", "act"),
    [
        (Phase.COMMAND, "boil the water", acts.Command("boil the water")),
        (Phase.COMMAND, "  boil it  ", acts.Command("boil it")),
        (Phase.COMMAND, "command: undo", acts.Command("undo")),
        (Phase.COMMAND, "yes", acts.Command("yes")),
        (Phase.COMMAND, "# 1 priority", acts.Command("# 1 priority")),
        (Phase.COMMAND, "undo", session_acts.Undo()),
        (Phase.COMMAND, "u", session_acts.Undo()),
        (Phase.COMMAND, "Undo that.", session_acts.Undo()),
        (Phase.JUDGEMENT, "UNDO", session_acts.Undo()),
        (Phase.COMMAND, "Undo it, please.", session_acts.Undo()),
        (Phase.EXECUTION, "why?", session_acts.Why()),
        (Phase.EXECUTION, "Why do you ask?", session_acts.Why()),
        (Phase.LEARNING, "Say that again, please!", session_acts.Repeat()),
        (Phase.COMMAND, "Bye!", session_acts.Quit()),
        (Phase.COMMAND, "go to the kitchen 3", acts.GoToScene("kitchen-3")),
        (Phase.COMMAND, "Go to living room number 2.", acts.GoToScene("living-room-2")),
        (Phase.COMMAND, "go to mug 2", acts.Command("go to mug 2")),
        (Phase.COMMAND, "go to the kitchen", acts.Command("go to the kitchen")),
        (Phase.COMMAND, "undo the knot", acts.Command("undo the knot")),
        (Phase.COMMAND, "scene: kitchen-2", acts.GoToScene("kitchen-2")),
        (Phase.COMMAND, "note: odd", session_acts.Note("odd")),
        (Phase.EXECUTION, "y", acts.Yes()),
        (Phase.EXECUTION, "?", acts.Unsure()),
        (Phase.EXECUTION, "nope, the red one", acts.Say("nope, the red one")),
        (Phase.EXECUTION, "2", acts.Point("Mug_2")),
        (Phase.EXECUTION, "object: Mug_1", acts.Point("Mug_1")),
        (Phase.EXECUTION, "# one", acts.Say("# one")),
        (Phase.JUDGEMENT, "g", acts.Good()),
        (Phase.JUDGEMENT, "yes", acts.Good()),
        (Phase.JUDGEMENT, "n", acts.Bad()),
        (Phase.JUDGEMENT, "stop: 3", acts.Stop(3)),
        (Phase.JUDGEMENT, "stop", acts.Stop()),
        (Phase.DEMONSTRATION, "stop", acts.Say("stop")),
        (Phase.READ_BACK, "no", acts.Bad()),
        (Phase.READ_BACK, "y", acts.Good()),
        (Phase.DEMONSTRATION, "go to the fridge", acts.Do(GO)),
        (Phase.DEMONSTRATION, "Go To Fridge", acts.Do(GO)),
        (Phase.DEMONSTRATION, "moveto Fridge_1", acts.Do(GO)),
        (Phase.DEMONSTRATION, "do: moveto Fridge_1", acts.Do(GO)),
        (Phase.DEMONSTRATION, "fetch a unicorn", acts.Say("fetch a unicorn")),
        (Phase.DEMONSTRATION, "d", acts.Done()),
        (Phase.DEMONSTRATION, "done", acts.Done()),
    ],
)
def test_a_line_is_read_by_what_the_robot_waits_for(
    phase: Phase, line: str, act: ScriptAct
) -> None:
    assert Reader(phase, {"1": "Mug_1", "2": "Mug_2"}, MENU).read(line) == act


@given(st.sampled_from(list(Phase)), texts())
def test_any_line_is_an_act_or_an_explained_mistake(phase: Phase, line: str) -> None:
    reader = Reader(phase, {}, MENU)
    try:
        act = reader.read(line)
    except LineSyntaxError:
        with pytest.raises(LineSyntaxError, match=r"."):
            parse_line(line.strip())
    else:
        assert (act is None) == (not line.strip())


def test_every_key_says_a_word_of_the_script() -> None:
    for phase in Phase:
        for key in (*answer_keys(phase), *ANYTIME):
            act = parse_line(f"{key.word}: x" if key.word == "note" else key.word)
            assert act is not None
            assert not isinstance(act, acts.Say), key
            assert word_of(key.key, phase) == key.word


def test_no_key_means_two_things_at_once() -> None:
    for phase in Phase:
        keys = [key.key for key in (*ANSWERS[phase], *ALSO.get(phase, ()), *ANYTIME)]
        assert len(set(keys)) == len(keys)


def test_only_what_fits_is_offered_and_what_cannot_be_done_now_comes_last() -> None:
    for choice in MENU.names:
        for first in MENU.objects(choice.id):
            assert any(
                ground.action.name == choice.id and ground.action.args[0] == first.id
                for ground in SETTING.task.actions
            )
    possible = [choice.possible for choice in MENU.names]
    assert possible == sorted(possible, reverse=True)
    assert [c.id for c in MENU.names if c.possible] == ["moveto", "wait"]


def test_completion_continues_what_was_typed_to_the_letter() -> None:
    assert MENU.complete("go to the fri") == "go to the fridge"
    assert MENU.complete("GO TO FRI") == "GO TO FRIdge"
    assert MENU.complete("moveto Fri") == "moveto Fridge_1"
    assert MENU.complete("boil") is None
    assert MENU.complete("") is None


def test_a_typed_word_answers_once_however_long_it_is() -> None:
    guard, answers = KeyGuard(), 0
    for index, letter in enumerate("nope, the red one, not the yellow"):
        now = 10 + index * 0.25
        if not guard.typing(letter, now) and guard.answers(now):
            answers += 1
    assert answers == 1


def test_a_key_held_down_answers_once() -> None:
    guard = KeyGuard()
    counted = [t for t in range(40) if not guard.typing("1", t / 33) and guard.answers(t / 33)]
    assert len(counted) == 4, "a digit is no typing, but it is debounced: four times in 1.2 s"
    letters = [t for t in range(40) if not guard.typing("y", 9 + t / 33)]
    assert letters == [0]


def test_answers_given_one_after_the_other_all_count() -> None:
    guard = KeyGuard()
    assert all(not guard.typing("y", t) and guard.answers(t) for t in (1.0, 1.7, 2.4, 3.1))


def test_enter_belongs_to_the_word_or_the_answer_before_it() -> None:
    guard = KeyGuard()
    assert not guard.ends(1.0)
    assert guard.answers(1.0)
    assert guard.ends(1.3)
    assert not guard.ends(1.7)
    guard.typing("o", 2.0)
    guard.typing("k", 2.5)
    assert guard.ends(3.0)
    assert not guard.ends(3.2)


def test_a_key_that_repeats_does_so_but_not_within_a_word() -> None:
    guard = KeyGuard()
    assert [guard.typing("x", t / 10, repeats=True) for t in range(4)] == [False] * 4
    assert [guard.typing(c, 9.0, repeats=c in "lei") for c in "lie"] == [False, True, True]
    assert guard.typing("e", 9.2, repeats=True), "the word goes on"
    assert not guard.typing("e", 10.0, repeats=True)


@pytest.mark.parametrize(
    ("line", "act"),
    [
        ("/quit", Quit()),
        ("/scene: kitchen-3", acts.GoToScene("kitchen-3")),
        ("/scene kitchen-3", acts.GoToScene("kitchen-3")),
        ("scene kitchen-3", acts.GoToScene("kitchen-3")),
        ("Go to living-room-2.", acts.GoToScene("living-room-2")),
        ("go to the sink", acts.Command("go to the sink")),
        ("go to plate 3", acts.Command("go to plate 3")),
        ("/boil the water", acts.Command("boil the water")),
        ("/", acts.Command("/")),
    ],
)
def test_words_may_begin_with_a_slash_and_rooms_be_named_as_they_are_called(
    line: str, act: ScriptAct
) -> None:
    assert Reader(Phase.COMMAND).read(line) == act


def test_a_room_is_no_answer() -> None:
    assert Reader(Phase.EXECUTION).read("go to kitchen-3") == acts.Say("go to kitchen-3")
    assert Reader(Phase.EXECUTION).read("/yes") == acts.Yes()


@pytest.mark.parametrize(
    ("scene", "command", "step"),
    [
        ("kitchen-1", "boil the water", "go to the sink"),
        ("living-room-1", "turn on the tv", "go to the couch"),
        ("living-room-2", "open the window", "go to the sofa"),
    ],
)
def test_examples_speak_of_what_is_there(
    tmp_path: Path, scene: str, command: str, step: str
) -> None:
    with Session.create(tmp_path, Header.new(scene), SETTINGS) as session:
        snapshot = Observer(session).look()
        assert (command_example(snapshot), step_example(snapshot)) == (command, step)
        assert command in prompt_of(snapshot).placeholder


@pytest.mark.parametrize(
    ("line", "parts"),
    [
        ("open it, done", ("open it", "done")),
        ("go to the fridge, open it and that's it.", ("go to the fridge, open it", "that's it")),
        ("turn it on. Done!", ("turn it on", "Done")),
        ("open it, and then I'm done", ("open it", "I'm done")),
        ("done", ("done",)),
        ("get it done", ("get it done",)),
        ("is it done", ("is it done",)),
    ],
)
def test_steps_and_the_end_behind_them_are_two_lines(line: str, parts: tuple[str, ...]) -> None:
    assert lines_of(line, Phase.DEMONSTRATION) == parts
    assert lines_of(line, Phase.COMMAND) == (line,)
