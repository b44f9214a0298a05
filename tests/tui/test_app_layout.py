"""The layouts: what must be in view is in view at each size, and nothing runs over its edge."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from textual.geometry import Region
from textual.widget import Widget

from tests.tui.room import (
    ASKED,
    BOIL_THE_WATER,
    NARROW,
    NORMAL,
    OPEN_THE_FRIDGE,
    TAUGHT,
    WIDE,
    Room,
    room,
    said,
)
from verbteach_tui.options import OpenSession
from verbteach_tui.screens.help import HelpScreen
from verbteach_tui.screens.verbs import VerbsScreen
from verbteach_tui.views.rows import plain, width_of
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.dialogue_view import DialogueView
from verbteach_tui.widgets.hypothesis_view import HypothesisView
from verbteach_tui.widgets.key_bar import KeyBar
from verbteach_tui.widgets.rows_view import RowsView

PANELS = ("dialogue", "scene", "mind")


def in_view(here: Room, selector: str) -> bool:
    """Whether a widget is on the screen with its whole frame, and has room for something."""
    widget = here.app.screen.query_one(selector)
    whole = Region(0, 0, *here.app.size)
    return bool(
        widget.is_on_screen and widget.region.area > 0 and whole.contains_region(widget.region)
    )


def check_nothing_overflows(here: Room) -> None:
    """Every panel lies within the screen, its rows within the panel, and no two overlap."""
    screen = here.app.screen
    whole = Region(0, 0, *here.app.size)
    for widget in screen.query(Widget):
        if widget.display and widget.region.area and widget.is_on_screen:
            assert whole.contains_region(widget.region), (widget, widget.region)
    for view in screen.query(RowsView):
        if view.is_on_screen and not isinstance(view, HypothesisView):
            room_for = view.scrollable_content_region.width
            assert all(width_of(row) <= room_for for row in view.rows), view
    panels = [w for w in screen.query("#panels > *") if w.is_on_screen and w.region.area]
    for index, one in enumerate(panels):
        for other in panels[index + 1 :]:
            assert not one.region.overlaps(other.region), (one, other)


async def test_input_and_keys_are_in_view_in_every_phase_at_every_size(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        for text in ("open the fridge", *OPEN_THE_FRIDGE, "done", "yes", "scene: kitchen-2"):
            await here.line(text)
            await check_in_view_everywhere(here, "#line", "#keys", "#title")
        await here.line("open the fridge")
        assert here.phase == "judgement"
        await check_in_view_everywhere(here, "#execution")


async def check_in_view_everywhere(here: Room, *selectors: str) -> None:
    for size in (NARROW, NORMAL, WIDE):
        await here.pilot.resize_terminal(*size)
        await here.pilot.pause()
        check_nothing_overflows(here)
        assert all(in_view(here, selector) for selector in selectors), (size, selectors)


async def test_four_things_are_in_view_at_120x40(tmp_path: Path) -> None:
    async with room(tmp_path, size=WIDE) as here:
        for text in ("open the fridge", *OPEN_THE_FRIDGE, "done"):
            await here.line(text)
            assert all(in_view(here, f"#{panel}") for panel in PANELS)
            assert not here.app.screen.query_one("#tabs").display


@pytest.mark.parametrize("size", [NORMAL, NARROW], ids=str)
async def test_panels_are_tabs_where_there_is_no_room(
    tmp_path: Path, size: tuple[int, int]
) -> None:
    async with room(tmp_path, size=size) as here:
        for key, panel in (("f3", "scene"), ("f4", "mind"), ("f2", "dialogue")):
            await here.key(key)
            assert [name for name in PANELS if in_view(here, f"#{name}")] == [panel]
        await here.click_target(here.app.screen.query_one("#tabs", RowsView), "mind")
        assert in_view(here, "#mind")


async def test_the_scene_comes_into_view_when_something_is_to_be_seen_in_it(tmp_path: Path) -> None:
    async with room(tmp_path, size=NORMAL) as here:
        assert in_view(here, "#dialogue")
        await here.line("open the fridge")
        assert in_view(here, "#scene")
        assert in_view(here, "#builder")
        await here.lines(*OPEN_THE_FRIDGE, "done")
        assert in_view(here, "#dialogue")
        assert in_view(here, "#read-back")


async def test_the_newest_line_is_in_view(tmp_path: Path) -> None:
    async with room(tmp_path, size=NARROW, after=ASKED) as here:
        await here.line("yes")
        view = here.app.screen.query_one(DialogueView)
        assert view.scroll_offset.y == view.max_scroll_y > 0
        last = plain(view.rows[-1])
        assert "What should I do next?" in last


async def test_growing_and_shrinking_the_terminal_keeps_everything(tmp_path: Path) -> None:
    async with room(tmp_path, size=WIDE) as here:
        await here.line("open the fridge")
        for size in (NARROW, WIDE, NORMAL, (200, 50), (40, 12), WIDE):
            await here.pilot.resize_terminal(*size)
            await here.pilot.pause(0.05)
            if size != (40, 12):
                check_nothing_overflows(here)
        assert all(in_view(here, f"#{panel}") for panel in PANELS)
        assert here.app.screen.query_one(CommandInput) is not None


async def test_the_hypothesis_graph_is_walked_with_the_arrow_keys(tmp_path: Path) -> None:
    shown = said(tmp_path, *BOIL_THE_WATER[:-1])
    async with room(tmp_path, OpenSession(shown)) as here:
        await here.key("y")
        await here.key("f5")
        view = here.app.screen.query_one(HypothesisView)
        node = here.app.screen.query_one("#node", RowsView)
        seen = {view.chosen}
        for key in ("down", "down", "down", "left", "right", "up"):
            await here.key(key)
            seen.add(view.chosen)
            assert plain(node.rows[0]).startswith(f"{view.chosen}:")
        assert len(seen) > 1
        news = "".join(plain(row) for row in view.rows)
        assert "✱" in news, "what was just learned is marked as new"
        await here.click_target(view, "A")
        assert view.chosen == "A"


async def test_a_click_on_a_verb_in_the_mind_opens_its_graph(tmp_path: Path) -> None:
    async with room(tmp_path, after=TAUGHT) as here:
        await here.click_target(here.teach.query_one("#mind", RowsView), "open/1")
        assert isinstance(here.app.screen, VerbsScreen)


async def test_help_is_about_what_has_the_focus(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        abouts = []
        for target in ("#line", "#dialogue", "#scene", "#mind", "#actions"):
            here.teach.query_one(target).focus()
            await here.key("f1")
            assert isinstance(here.app.screen, HelpScreen)
            abouts.append("\n".join(map(plain, here.app.screen.query_one("#help", RowsView).rows)))
            await here.key("escape")
        assert len(set(abouts)) == len(abouts)
        assert "Show the robot what to do" in abouts[-1]
        assert re.search(r"^d +done$", abouts[-1], re.MULTILINE)


async def test_every_action_is_in_the_palette(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        titles = {command.title for command in here.app.get_system_commands(here.teach)}
        assert titles >= {"Done", "Undo", "Redo", "Flag", "Note", "Verbs", "Other scene", "Leave"}
        assert titles >= {"Theme", "Help", "Quit", "Dialogue", "Scene"}


async def test_without_colour_everything_is_still_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    async with room(tmp_path) as here:
        await here.lines("open the fridge", OPEN_THE_FRIDGE[0])
        drawn = here.app.export_screenshot()
        fills = re.findall(r"-r\d+ \{ fill: #(\w{2})(\w{2})(\w{2})", drawn)
        assert len(fills) > 3
        # The first is the frame that the picture is put in, not the app's.
        assert all(r == g == b for r, g, b in fills[1:])


async def test_the_empty_line_says_what_to_type_or_how_to_come_to_it(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        line = here.teach.query_one(CommandInput)
        assert line.has_focus
        assert line.placeholder.startswith("Say what the robot should do")
        await here.key("tab")
        assert line.placeholder == "Tab or / to type, as in: boil the water"
        await here.key("tab")
        assert line.placeholder.startswith("Say what the robot should do")


async def test_after_an_undo_the_line_names_the_key_that_does_it_again(tmp_path: Path) -> None:
    async with room(tmp_path, size=NARROW) as here:
        await here.line("open the fridge")
        assert here.phase == "demonstration"
        await here.key("u")
        assert here.phase == "command"
        assert here.teach.query_one(CommandInput).has_focus
        bar = " ".join(plain(row) for row in here.teach.query_one(KeyBar).rows)
        assert "^y  redo" in bar
        assert "^z" not in bar
        await here.key("ctrl+y")
        assert here.phase == "demonstration"
