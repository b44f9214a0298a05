"""The record says which panels a person could see before each answer, and for how short a time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tests.tui.room import NORMAL, SETTINGS, WIDE, Room, room
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.validate import validate
from verbteach_tui.screens.verbs import VerbsScreen

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
