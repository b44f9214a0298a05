"""What is typed on the home screen: a first command, a word for the screen itself, or a key."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from textual.widgets import Input

from tests.tui.frames import piloted
from tests.tui.room import NARROW, Room, options, room
from verbteach_scenarios.scenes import scene_ids
from verbteach_tui.app import VerbteachApp
from verbteach_tui.first_words import Begin, FirstWords, Go, first_words
from verbteach_tui.options import OpenHome
from verbteach_tui.screens.help import HelpScreen
from verbteach_tui.screens.home import HomeScreen
from verbteach_tui.screens.lab import LabScreen
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.screens.tour import TourScreen
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.rows_view import RowsView


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("boil the water", Begin(command="boil the water")),
        ("/Put it down.", Begin(command="Put it down.")),
        ("help the cook", Begin(command="help the cook")),
        ("Help!", Go("app.help")),
        ("q", Go("app.quit")),
        ("verbteach lab", Go("app.lab")),
        ("teach", Begin()),
        ("kitchen 3", Begin(scene="kitchen-3")),
        ("go to the living-room-2", Begin(scene="living-room-2")),
        ("go to the fridge", Begin(command="go to the fridge")),
    ],
)
def test_a_line_is_a_first_command_unless_it_speaks_of_the_screen(
    line: str, meant: FirstWords
) -> None:
    assert first_words(line, scene_ids()) == meant


def _typed(here: Room) -> str:
    return here.app.screen.query_one("#line", Input).value


@pytest.mark.parametrize("command", ["put the mug into the sink", "look", "clean it", "squeeze it"])
async def test_a_sentence_is_no_keys_and_is_said_in_the_chosen_room(
    tmp_path: Path, command: str
) -> None:
    async with room(tmp_path, OpenHome(), patient=True, size=NARROW) as here:
        await here.pilot.press("down", *("space" if c == " " else c for c in command))
        assert isinstance(here.app.screen, HomeScreen)
        assert _typed(here) == command
        await here.pilot.press("enter")
        await here.until(lambda: isinstance(here.app.screen, TeachScreen))
        await here.until(lambda: f"teacher: {command}" in here.dialogue, here.dialogue)
        await here.settle()
        assert here.teach.snapshot.scene == "kitchen-2"
        assert _typed(here) == ""


async def test_who_has_begun_with_a_command_is_not_led_about_and_types_on(tmp_path: Path) -> None:
    toured = tmp_path / "toured"
    app = VerbteachApp(replace(options(tmp_path / "s", OpenHome()), toured=toured))
    async with piloted(app, NARROW) as pilot:
        here = Room(app, pilot)
        await pilot.press(*"wash", "space", *"it", "enter", *"hm")
        await here.until(lambda: isinstance(app.screen, TeachScreen))
        await here.until(lambda: "teacher: wash it" in here.dialogue)
        await here.settle()
        assert not any(isinstance(screen, TourScreen) for screen in app.screen_stack)
        assert not toured.exists()
    app.close_sessions()


async def test_a_letter_alone_is_a_key_after_a_moment_and_with_enter_at_once(
    tmp_path: Path,
) -> None:
    async with room(tmp_path, OpenHome(), patient=True) as here:
        await here.pilot.press("l")
        assert isinstance(here.app.screen, HomeScreen)
        await here.until(lambda: isinstance(here.app.screen, LabScreen))
        await here.pilot.press("escape")
        assert isinstance(here.app.screen, HomeScreen)
        assert _typed(here) == ""
        assert not here.app.screen.query_one("#line").has_focus
        await here.pilot.press("h", "e", "l", "p", "enter")
        await here.until(lambda: isinstance(here.app.screen, HelpScreen))
        told = here.app.screen.query_one("#help", RowsView).rows
        assert any("Lab" in plain(row) for row in told), "help about the screen, not its line"
        await here.pilot.press("escape", "q", "enter")
        await here.until(lambda: not here.app.is_running)


async def test_the_keys_named_below_are_clicked_at_once_and_escape_drops_a_line(
    tmp_path: Path,
) -> None:
    async with room(tmp_path, OpenHome(), patient=True) as here:
        await here.pilot.press(*"boil", "escape", "enter")
        await here.until(lambda: isinstance(here.app.screen, TeachScreen))
        assert not [word for word in here.dialogue.split() if word == "boil"]
        await here.key("f10")
        await here.click_target(here.app.screen.query_one(Foot), "l")
        await here.until(lambda: isinstance(here.app.screen, LabScreen))
