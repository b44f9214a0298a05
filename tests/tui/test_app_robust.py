"""The app under strain: nasty texts, any keys, what fails below it; the record stays whole."""

from __future__ import annotations

import os
import time
from dataclasses import replace
from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pytest
from textual import events
from textual.pilot import Pilot
from textual.widgets import Static

from tests.tui.frames import piloted
from tests.tui.room import NORMAL, PATIENCE, SETTINGS, SHOWN, learn_to_open, options, room
from tests.tui.strategies import NASTY
from verbteach_sessions.errors import StorageError
from verbteach_sessions.session import Session
from verbteach_tui.app import VerbteachApp
from verbteach_tui.options import OpenHome, OpenNew, OpenSession
from verbteach_tui.screens.failure import FailureScreen
from verbteach_tui.screens.opening import OpeningScreen
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.views.rows import plain
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.dialogue_view import DialogueView

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


async def test_what_is_typed_while_the_room_opens_stands_in_its_line(tmp_path: Path) -> None:
    ready = Event()
    chosen = options(tmp_path, OpenNew("kitchen-1"))

    def create(scene: str) -> Session:
        assert ready.wait(PATIENCE)
        return chosen.create(scene)

    app = VerbteachApp(replace(chosen, create=create))
    async with piloted(app) as pilot:
        await pilot.press(*"/opem", "backspace", *"n it")
        assert isinstance(app.screen, OpeningScreen)
        assert "open it" in str(app.screen.query_one("#opening", Static).content)
        ready.set()
        for _ in range(300):
            await pilot.pause(0.02)
            if any(line.value for line in app.screen.query(CommandInput)):
                break
        assert isinstance(app.screen, TeachScreen)
        assert app.screen.query_one(CommandInput).value == "open it"
    app.close_sessions()


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


async def test_quitting_records_that_the_person_left(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        session = here.teach.teaching.session
        await here.line("open the fridge")
        await here.pilot.press("ctrl+q")
        await _until(here.pilot, lambda: session.ended)
        assert session.ended
