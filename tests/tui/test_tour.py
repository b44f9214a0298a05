"""The tour: short, skippable, repeatable, and shown by itself only once."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.tui.frames import piloted
from tests.tui.room import NARROW, WIDE, Room, options
from verbteach_tui.app import VerbteachApp
from verbteach_tui.options import OpenNew
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.screens.tour import STOPS, TourScreen
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.rows_view import RowsView

WORDS_A_MINUTE = 180


def test_it_takes_less_than_two_minutes_to_read() -> None:
    words = sum(len(f"{stop.title} {stop.text}".split()) for stop in STOPS)
    assert words / WORDS_A_MINUTE < 2


@pytest.mark.parametrize("size", [WIDE, NARROW])
async def test_it_comes_by_itself_once_and_speaks_of_what_is_in_view(
    tmp_path: Path, size: tuple[int, int]
) -> None:
    toured = tmp_path / "state" / "toured"
    app = VerbteachApp(replace(options(tmp_path, OpenNew("kitchen-1")), toured=toured))
    async with piloted(app, size=size) as pilot:
        here = Room(app, pilot)
        await here.settle()
        await pilot.pause()
        assert toured.exists()
        for stop in STOPS:
            tour = app.screen
            assert isinstance(tour, TourScreen)
            assert tour.stop == stop
            told = tour.query_one("#told", RowsView)
            text = " ".join(plain(row) for row in told.rows)
            assert "skip the tour" in text
            assert tour.query_one("#tour").region.height > len(told.rows), "all of it is in view"
            if stop.panel:
                panel = here.teach.query_one(f"#{stop.panel}")
                assert panel.has_class("-toured")
                assert panel.region.height
            await pilot.press("enter")
            await pilot.pause()
        assert isinstance(app.screen, TeachScreen)
        assert not here.teach.query(".-toured")
        await here.line("open the fridge")
        assert here.phase == "demonstration"
    app.close_sessions()


async def test_it_is_skipped_with_one_key_and_repeated_from_the_palette(tmp_path: Path) -> None:
    toured = tmp_path / "toured"
    toured.touch()
    app = VerbteachApp(replace(options(tmp_path, OpenNew("kitchen-1")), toured=toured))
    async with piloted(app, size=WIDE) as pilot:
        here = Room(app, pilot)
        await here.settle()
        assert isinstance(app.screen, TeachScreen), "it was offered before"
        entry = {title: action for title, _, action in here.teach.palette()}
        entry["Tour"]()
        await pilot.pause()
        assert isinstance(app.screen, TourScreen)
        await pilot.press("escape")
        await pilot.pause()
        assert isinstance(app.screen, TeachScreen)
    app.close_sessions()


async def test_who_types_a_command_instead_has_it_in_the_line(tmp_path: Path) -> None:
    app = VerbteachApp(replace(options(tmp_path, OpenNew("kitchen-1")), toured=tmp_path / "toured"))
    async with piloted(app) as pilot:
        here = Room(app, pilot)
        await here.settle()
        await pilot.pause()
        assert isinstance(app.screen, TourScreen)
        await pilot.press(*"switch on")
        await pilot.pause()
        assert isinstance(app.screen, TeachScreen)
        line = here.teach.query_one(CommandInput)
        assert line.value == "switch on"
        assert line.has_focus
        assert not here.teach.query(".-toured")
        await pilot.press("enter")
        await here.settle()
    app.close_sessions()
