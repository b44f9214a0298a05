"""How the teaching room looks, picture by picture; the sizes, the themes and the session are fixed.

After a change that is meant to be seen: ``pytest tests/tui/test_snapshots.py --snapshot-update``,
and a look at each picture that changed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from textual.pilot import Pilot

from tests.tui.frames import at_rest
from tests.tui.room import BOIL_THE_WATER, NARROW, NORMAL, WIDE, options, said
from verbteach_tui.app import VerbteachApp
from verbteach_tui.options import OpenSession
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.key_bar import KeyBar

VERY_WIDE = (200, 50)
ASKED = ("command: wash the mug",)
SHOWING = (
    *ASKED, "object: Mug_2", "skip", "command: boil the water", "do: moveto Kettle_1",
    "do: grasp Kettle_1", "do: moveto Burner_1",
)  # fmt: skip

Compare = Callable[..., bool]


@pytest.fixture
def looks(snap_compare: Compare, tmp_path: Path) -> Callable[..., bool]:
    """Whether a session looks in a size and a theme as it did."""

    def compare(lines: tuple[str, ...], size: tuple[int, int], theme: str = "evening") -> bool:
        opening = OpenSession(said(tmp_path, *lines))
        app = VerbteachApp(replace(options(tmp_path, opening), theme=theme))
        same: bool = snap_compare(app, terminal_size=size, run_before=settled)
        app.close_sessions()
        return same

    return compare


async def settled(pilot: Pilot[Any]) -> None:
    """Wait until the session is on the screen, its cursor at rest, and nothing changes any more."""

    def ready() -> bool:
        screen = pilot.app.screen
        if not isinstance(screen, TeachScreen) or not screen.query("KeyBar"):
            return False
        screen.query_one(CommandInput).cursor_blink = False
        return bool(screen.query_one(KeyBar).rows)

    await at_rest(pilot, ready)


@pytest.mark.parametrize("size", [NARROW, NORMAL, WIDE, VERY_WIDE], ids=lambda s: f"{s[0]}x{s[1]}")
def test_a_demonstration(looks: Callable[..., bool], size: tuple[int, int]) -> None:
    assert looks(SHOWING, size)


@pytest.mark.parametrize("theme", ["evening", "daylight", "clear"])
def test_a_question_in_three_themes(looks: Callable[..., bool], theme: str) -> None:
    assert looks(ASKED, WIDE, theme)


@pytest.mark.parametrize("theme", ["daylight", "clear"])
def test_a_demonstration_in_other_themes(looks: Callable[..., bool], theme: str) -> None:
    assert looks(SHOWING, NORMAL, theme)


@pytest.mark.parametrize("theme", ["evening", "daylight", "clear"])
def test_a_goal_read_back_in_three_themes(looks: Callable[..., bool], theme: str) -> None:
    assert looks(BOIL_THE_WATER[:-1], WIDE, theme)
