"""Keys and lines: which of them is meant, and what was typed or pasted is neither lost nor sent."""

from __future__ import annotations

from pathlib import Path

from textual import events
from textual.widgets import OptionList

from tests.tui.room import ASKED, NORMAL, SHOWN, room
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.screens.note import NoteScreen
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.steps_view import StepsView


async def test_what_is_pasted_is_one_line_and_nothing_is_sent_by_it(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        entry = here.teach.query_one(CommandInput)
        here.app.post_message(events.Paste("open the fridge\nquit\n\x1b[31m"))
        await here.settle()
        assert entry.value == "open the fridge, quit, [31m"
        assert here.phase == "command"


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


async def test_a_line_that_does_not_fit_comes_back_to_be_changed(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        entry = here.teach.query_one(CommandInput)
        for text in ("scene: nowhere", "scene: a b", "object: Mug_1"):
            await here.line(text)
            assert entry.value == text
            assert here.phase == "command"
        await here.line("open the fridge")
        assert entry.value == ""
