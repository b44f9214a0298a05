"""The record says which panels a person could see before each answer, and for how short a time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.tui.room import NARROW, NORMAL, SETTINGS, WIDE, Room, room
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.validate import validate
from verbteach_tui.screens.verbs import VerbsScreen
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.latest_words import LatestWords
from verbteach_tui.widgets.scene_view import SceneView

ALWAYS = ["dialogue", "mind", "scene"]


def seen(here: Room) -> list[Any]:
    """The panels in view before each of the person's acts."""
    path = here.teach.teaching.session.path
    return [e.data["in_view"] for e in LogReader(path) if "answered_at" in e.data]


async def test_the_robots_view_and_the_verbs_count_once_they_were_looked_at(tmp_path: Path) -> None:
    async with room(tmp_path, size=WIDE) as here:
        await here.line("wash the mug")
        await here.key("f7", "f7", "1")
        await here.key("s")
        await here.key("f5")
        assert isinstance(here.app.screen, VerbsScreen)
        await here.key("escape")
        await here.line("wash the mug")
        before, belief, after, verbs = seen(here)
        path = here.teach.teaching.session.path
    assert before == ALWAYS
    assert belief == ["belief", *ALWAYS], "what was hidden again had been seen all the same"
    assert after == ALWAYS
    assert verbs == [*ALWAYS, "verbs"]
    assert validate(path, SETTINGS).valid


async def test_where_panels_are_tabs_only_those_looked_at_count(tmp_path: Path) -> None:
    async with room(tmp_path, size=NORMAL) as here:
        await here.line("wash the mug")
        await here.key("f4", "f2", "?")
        assert seen(here) == [["dialogue"], ["dialogue", "mind"]]


@pytest.mark.parametrize("size", [NARROW, NORMAL])
async def test_what_the_robot_says_is_to_be_read_on_every_tab(
    tmp_path: Path, size: tuple[int, int]
) -> None:
    async with room(tmp_path, size=size) as here:
        assert words_below(here) == ""
        await here.line("open the fridge")
        assert here.phase == "demonstration"
        assert words_below(here).endswith("could you show me an example?")
        await here.key("f4")
        assert words_below(here).endswith("could you show me an example?")
        await here.key("f2")
        assert words_below(here) == "", "the dialogue is in view itself"


async def test_where_all_panels_are_in_view_nothing_is_said_twice(tmp_path: Path) -> None:
    async with room(tmp_path, size=WIDE) as here:
        await here.line("open the fridge")
        assert words_below(here) == ""


def words_below(here: Room) -> str:
    """What stands below the panels of what the robot said last."""
    latest = here.teach.query_one(LatestWords)
    return " ".join(plain(row).strip() for row in latest.rows) if latest.size.height else ""


async def test_where_the_robot_went_comes_into_view(tmp_path: Path) -> None:
    async with room(tmp_path, size=NORMAL) as here:
        await here.lines("open the fridge", "go to the bottom cupboard")
        scene = here.teach.query_one(SceneView)
        await here.pilot.pause(0.1)
        top = scene.scroll_offset.y
        shown = [plain(row) for row in scene.rows[top : top + scene.size.height]]
        assert any("bottom cupboard" in row and "robot" in row for row in shown), shown
