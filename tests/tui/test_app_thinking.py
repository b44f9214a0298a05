"""While the robot thinks: the screen goes on, and what is pressed or typed ahead waits its turn."""

from __future__ import annotations

import asyncio
import time
from pathlib import Path
from threading import Event
from typing import Any

import pytest

from tests.tui.room import ASKED, OPEN_THE_FRIDGE, SHOWN, Room, room
from verbteach_tui.widgets.command_input import CommandInput


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


async def test_steps_and_done_in_one_line_end_the_demonstration(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines("open the fridge", "go to the fridge, open it, done")
        await here.until(lambda: here.phase == "read_back", here.dialogue)
        await here.settle()
        assert not here.teach.query_one("#line").has_focus, "keys answer what was asked"
