"""The app under strain: nasty texts, any keys, failing and slow workers; the record stays whole."""

from __future__ import annotations

import asyncio
import os
import time
from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pytest
from textual import events
from textual.pilot import Pilot
from textual.widgets import OptionList

from tests.tui.frames import piloted
from tests.tui.room import (
    ASKED,
    NORMAL,
    OPEN_THE_FRIDGE,
    PATIENCE,
    SETTINGS,
    SHOWN,
    Room,
    learn_to_open,
    room,
)
from tests.tui.strategies import NASTY
from verbteach_sessions.errors import StorageError
from verbteach_sessions.session import Session
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.options import OpenHome, OpenSession
from verbteach_tui.screens.failure import FailureScreen
from verbteach_tui.screens.note import NoteScreen
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.views.rows import plain
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.dialogue_view import DialogueView
from verbteach_tui.widgets.steps_view import StepsView

MANY_KEYS = int(os.environ.get("VERBTEACH_RANDOM_KEYS", "1500"))
"""How many random keys the slow test presses; 10,000 take a quarter of an hour."""


async def test_nasty_commands_print_as_themselves(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        for text in NASTY:
            if not text.strip():
                continue
            await here.line(text)
            if here.phase != "command":
                await here.key("s")
            view = here.teach.query_one(DialogueView)
            shown = "".join(plain(row) for row in view.rows).replace(" ", "")
            assert visible(text.strip())[:500].replace(" ", "") in shown
        image = here.app.export_screenshot()
        assert "\x1b" not in image
        assert not any(ord(c) < 32 and c not in "\n\t" for c in image)


async def test_what_is_pasted_is_one_line_and_nothing_is_sent_by_it(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        entry = here.teach.query_one(CommandInput)
        here.app.post_message(events.Paste("open the fridge\nquit\n\x1b[31m"))
        await here.settle()
        assert entry.value == "open the fridge, quit, [31m"
        assert here.phase == "command"


PRINTABLE = [*"ynsgbtwrufUmdx?/0123456789 +-e", "space"]
OTHERS = [
    *("tab", "shift+tab", "enter", "escape", "up", "down", "left", "right", "home", "end"),
    *("pageup", "pagedown", "backspace", "delete", "ctrl+z", "ctrl+y", "ctrl+p"),
    *("f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8", "f9"),
]


@pytest.mark.parametrize(
    ("seed", "count"), [(1, 300), pytest.param(2, MANY_KEYS, marks=pytest.mark.slow)]
)
async def test_hundreds_of_random_keys_never_crash_it_and_never_spoil_the_record(
    tmp_path: Path, seed: int, count: int
) -> None:
    rng = np.random.default_rng(seed)
    async with room(tmp_path, size=NORMAL, after=SHOWN) as here:
        path = here.teach.teaching.session.path
        for _ in range(count):
            keys = OTHERS if rng.random() < 0.45 else PRINTABLE
            await here.pilot.press(keys[rng.integers(len(keys))])
            if rng.random() < 0.05 and here.app.screen is here.teach:
                here.teach.query_one(CommandInput).value = str(rng.choice(NASTY))
            elif rng.random() < 0.03:
                here.app.post_message(events.Paste(str(rng.choice(NASTY))))
        await here.settle()
        digest = here.teach.teaching.session.robot.state.digest
    with Session.resume(path, SETTINGS) as again:
        assert again.recovered == ()
        assert again.robot.state.digest == digest


async def test_a_word_typed_where_keys_answer_is_one_answer_at_most(tmp_path: Path) -> None:
    async with room(tmp_path, patient=True, after=ASKED) as here:
        assert here.phase == "read_back"
        before = len(here.teach.snapshot.lines)
        here.teach.guard = KeyGuard()
        await here.pilot.press(*"nope")  # n says wrong, and the rest no more than that
        await here.settle()
        said = [line for line in here.teach.snapshot.lines[before:] if line.speaker == "teacher"]
        assert [line.text for line in said] == ["bad"]


async def test_enter_after_a_key_where_keys_answer_takes_no_step(tmp_path: Path) -> None:
    async with room(tmp_path, patient=True, size=NORMAL) as here:
        await here.line("open the fridge")
        assert here.phase == "demonstration"
        here.teach.guard = KeyGuard()
        lists = here.teach.query_one("#actions", OptionList)
        await here.pilot.press("d", "enter", "enter")
        await here.settle()
        assert here.teach.snapshot.shown == ()
        assert lists.has_focus, "nothing was chosen"


async def test_a_line_that_begins_with_no_key_is_typed_at_once_without_losing_a_letter(
    tmp_path: Path,
) -> None:
    async with room(tmp_path, patient=True, size=NORMAL) as here:
        await here.line("open the fridge")
        here.teach.guard = KeyGuard()
        for character in "go to the fridge":  # all of it before anything of it is dealt with
            here.app.post_message(events.Key("space" if character == " " else character, character))
        await here.until(lambda: here.teach.query_one(CommandInput).value == "go to the fridge")
        await here.key("enter")
        assert here.teach.snapshot.shown == ("go to the fridge",)


async def test_a_demonstration_that_is_dropped_says_how_it_comes_back(tmp_path: Path) -> None:
    async with room(tmp_path, size=NORMAL, after=SHOWN) as here:
        shown = here.teach.snapshot.shown
        await here.key("s")
        assert here.phase == "command"
        assert any("Ctrl+Z" in one.message for one in here.app._notifications)
        await here.key("ctrl+z")
        assert here.teach.snapshot.shown == shown


async def test_looking_at_another_panel_leaves_who_is_typing_in_the_line(tmp_path: Path) -> None:
    async with room(tmp_path, size=NORMAL) as here:
        line, scene = here.teach.query_one(CommandInput), here.teach.query_one("#scene")
        await here.key("f3")
        assert line.has_focus
        await here.key("f3")
        assert scene.has_focus


async def test_a_word_typed_among_the_steps_edits_none(tmp_path: Path) -> None:
    async with room(tmp_path, patient=True, after=SHOWN) as here:
        shown = here.teach.snapshot.shown
        await here.key("f9")
        here.teach.guard = KeyGuard()
        await here.pilot.press("up", *"pixel")
        await here.settle()
        assert here.teach.snapshot.shown == shown
        assert not here.teach.query_one(StepsView).running


async def test_what_is_pasted_goes_into_the_line_whole_and_says_nothing(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        entry = here.teach.query_one(CommandInput)
        assert not entry.has_focus
        here.app.post_message(events.Paste("go to the fridge\n\n  open the fridge\r\n"))
        await here.settle()
        assert entry.value == "go to the fridge, open the fridge"
        assert here.teach.snapshot.shown == ()
        await here.key("enter")
        assert len(here.teach.snapshot.shown) == 2
        assert entry.has_focus
        here.app.post_message(events.Paste("done"))
        await here.settle()
        assert entry.value == "done"


async def test_a_failing_robot_becomes_a_dialog_and_the_session_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with room(tmp_path) as here:
        path = here.teach.teaching.session.path
        with monkeypatch.context() as patch:
            patch.setattr("verbteach.dialogue.robot.Robot.receive", _broken)
            await here.line("open the fridge")
        assert isinstance(here.app.screen, FailureScreen)
        assert here.teach.query_one(CommandInput).value == "open the fridge"
        await here.key("enter")
        assert isinstance(here.app.screen, TeachScreen)
        assert here.phase == "command"
        await learn_to_open(here)
        assert here.teach.snapshot.figures.verbs == 1
    with Session.resume(path, SETTINGS) as again:
        assert again.robot.state.knowledge.verbs == ("open",)


def _broken(self: object, act: object) -> None:
    raise RuntimeError("the [bold]planner[/] fell over \x1b[31m")


async def test_a_full_disk_becomes_a_dialog(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(self: Session, *args: Any, **keywords: Any) -> None:
        raise StorageError(self.path, OSError(28, "No space left on device"))

    async with room(tmp_path) as here:
        with monkeypatch.context() as patch:
            patch.setattr(Session, "perform", full)
            await here.line("open the fridge")
        assert isinstance(here.app.screen, FailureScreen)
        assert not here.app.screen.query(".details"), "a full disk is no puzzle"
        await here.key("escape")
        await here.line("open the fridge")
        assert here.phase == "demonstration"


async def test_a_full_disk_keeps_nobody_in_the_room(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(self: Session, *args: Any, **keywords: Any) -> None:
        raise StorageError(self.path, OSError(28, "No space left on device"))

    async with room(tmp_path) as here:
        path = here.teach.teaching.session.path
        monkeypatch.setattr(Session, "perform", full)
        await here.key("ctrl+q")
        await here.until(lambda: not here.app.is_running)
    monkeypatch.undo()
    with Session.resume(path, SETTINGS) as again:
        assert again.robot.turn.phase.value == "command"


async def test_a_session_that_cannot_be_opened_is_explained_at_home(tmp_path: Path) -> None:
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "events.jsonl").write_text("no log\n")
    async with room(tmp_path, OpenHome()) as here:
        await here.pilot.pause(0.2)
        await here.key("c", "enter")
        assert isinstance(here.app.screen, FailureScreen)
        await here.key("enter")
        assert not isinstance(here.app.screen, TeachScreen)
        await here.key("n", "enter")
        assert here.phase == "command"


async def test_a_session_named_on_the_command_line_that_is_none_is_handed_back(
    tmp_path: Path,
) -> None:
    from tests.tui.room import options
    from verbteach_tui.app import VerbteachApp

    app = VerbteachApp(options(tmp_path, OpenSession(tmp_path / "nowhere")))
    async with piloted(app) as pilot:
        await _until(pilot, lambda: app.failure is not None)
    assert app.failure is not None


async def _until(pilot: Pilot[None], done: Any) -> None:
    end = time.monotonic() + PATIENCE
    while not done():
        assert time.monotonic() < end, "it never came to that"
        await pilot.pause(0.01)


async def test_a_slow_robot_does_not_hold_up_the_screen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from verbteach.dialogue.robot import Robot

    quick = Robot.receive

    def slow(self: Robot, act: Any) -> Any:
        time.sleep(0.6)
        return quick(self, act)

    async with room(tmp_path) as here:
        monkeypatch.setattr(Robot, "receive", slow)
        entry = here.teach.query_one(CommandInput)
        entry.value = "open the fridge"
        entry.focus()
        await here.pilot.press("enter")
        beats = 0
        while here.teach.thinking:
            await asyncio.sleep(0.01)
            beats += 1
        assert beats > 10, "the event loop went on turning"
        await here.settle()
        assert here.phase == "demonstration"


async def test_keys_pressed_while_the_robot_thinks_say_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from verbteach.dialogue.robot import Robot

    quick = Robot.receive

    def slow(self: Robot, act: Any) -> Any:
        time.sleep(0.3)
        return quick(self, act)

    async with room(tmp_path, after=ASKED) as here:
        monkeypatch.setattr(Robot, "receive", slow)
        await here.pilot.press("n", "y", "n", "s")
        await here.settle()
        teacher = [line.text for line in here.teach.snapshot.lines if line.speaker == "teacher"]
        assert teacher[-2:] == ["done", "bad"]


async def typed_at_once(here: Room, monkeypatch: pytest.MonkeyPatch, *lines: str) -> None:
    """Type lines faster than the robot can answer the first."""
    from verbteach.dialogue.robot import Robot

    quick, typed = Robot.receive, Event()

    def slow(self: Robot, act: Any) -> Any:
        typed.wait(60)
        return quick(self, act)

    entry = here.teach.query_one(CommandInput)
    entry.focus()
    with monkeypatch.context() as patch:
        patch.setattr(Robot, "receive", slow)
        for line in lines:
            entry.value = line
            await here.pilot.press("enter")
        assert here.teach.thinking
        typed.set()
        await here.settle()


async def test_steps_typed_ahead_are_taken_in_order(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        await typed_at_once(here, monkeypatch, *OPEN_THE_FRIDGE, "go to the sink")
        assert len(here.teach.snapshot.shown) == len(OPEN_THE_FRIDGE) + 1
        assert here.teach.query_one(CommandInput).value == ""


async def test_what_was_typed_ahead_answers_no_question_that_was_not_seen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with room(tmp_path, after=SHOWN) as here:
        await typed_at_once(here, monkeypatch, "done", "yes", "open the microwave")
        assert here.phase == "read_back"
        entry = here.teach.query_one(CommandInput)
        assert entry.value == "yes, open the microwave"


async def test_after_a_step_that_cannot_be_the_next_ones_wait(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        await typed_at_once(here, monkeypatch, "open the fridge", "close the fridge", "done")
        assert here.teach.snapshot.shown == ()
        assert here.teach.query_one(CommandInput).value == "close the fridge, done"


async def test_a_note_is_kept_and_the_robot_does_not_hear_it(tmp_path: Path) -> None:
    async with room(tmp_path, after=ASKED) as here:
        await here.key("m")
        assert isinstance(here.app.screen, NoteScreen)
        await here.pilot.press(*"odd", "enter")
        await here.settle()
        assert here.teach.snapshot.lines[-1][:2] == ("note", "odd")
        assert here.phase == "read_back"
        await here.key("f")
        assert here.teach.snapshot.lines[-1][:2] == ("note", "flagged")


async def test_why_and_repeat_are_answered_at_once(tmp_path: Path) -> None:
    async with room(tmp_path, after=ASKED) as here:
        asked = here.teach.snapshot.lines[-1].text
        await here.key("r")
        assert here.teach.snapshot.lines[-1].text == asked
        before = len(here.teach.snapshot.lines)
        await here.key("w")
        why = [line.text for line in here.teach.snapshot.lines[before:]]
        assert any("goal" in text for text in why)
        assert len(why) >= 2


async def test_quitting_records_that_the_person_left(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        session = here.teach.teaching.session
        await here.line("open the fridge")
        await here.pilot.press("ctrl+q")
        await _until(here.pilot, lambda: session.ended)
        assert session.ended


async def test_what_is_typed_while_the_robot_thinks_is_a_new_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from verbteach.dialogue.robot import Robot

    quick = Robot.receive

    def slow(self: Robot, act: Any) -> Any:
        time.sleep(0.5)
        return quick(self, act)

    async with room(tmp_path) as here:
        entry = here.teach.query_one(CommandInput)
        monkeypatch.setattr(Robot, "receive", slow)
        await here.pilot.press(*"open", "space", *"it", "enter")
        assert entry.value == "", "the line is on its way"
        await here.pilot.press(*"ab")
        await here.pilot.press("enter")
        assert here.teach.thinking
        await here.settle()
        assert entry.value == "ab", "the robot waits for something else by now: it comes back"
        assert [line.text for line in here.teach.snapshot.lines if line.speaker == "teacher"] == [
            "open it"
        ]


async def test_a_line_that_does_not_fit_comes_back_to_be_changed(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        entry = here.teach.query_one(CommandInput)
        for text in ("scene: nowhere", "scene: a b", "object: Mug_1"):
            await here.line(text)
            assert entry.value == text
            assert here.phase == "command"
        await here.line("open the fridge")
        assert entry.value == ""
