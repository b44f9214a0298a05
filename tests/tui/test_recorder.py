"""The demonstration recorder: steps are looked at, inserted, taken away, moved and run."""

from __future__ import annotations

import asyncio
from pathlib import Path

from textual.widgets import OptionList

from tests.tui.room import NARROW, Room, labels, room, said
from verbteach_tui.options import OpenSession
from verbteach_tui.views.recorder import Change, change_rows, step_rows
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.key_bar import KeyBar
from verbteach_tui.widgets.rows_view import RowsView
from verbteach_tui.widgets.scene_view import SceneView
from verbteach_tui.widgets.steps_view import StepsView

FETCH: tuple[str, ...] = ("go to the kettle", "take the kettle", "go to the left burner")


def steps_of(here: Room) -> StepsView:
    return here.teach.query_one(StepsView)


def shown(here: Room) -> tuple[str, ...]:
    return here.teach.snapshot.shown


def changed(here: Room) -> str:
    view = here.teach.query_one("#changed", RowsView)
    return " ".join(plain(row).strip() for row in view.rows)


async def test_a_step_is_inserted_before_another_from_the_lists_by_keyboard(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines("boil the water", *FETCH)
        await here.key("tab", "left")
        steps = steps_of(here)
        assert steps.has_focus
        await here.key("home", "i")
        assert steps.at == 1
        assert here.app.focused is not None
        assert here.app.focused.id == "actions"
        await here.choose("actions", "go to …")
        await here.choose("objects", "tap")
        assert shown(here) == ("go to the tap", *FETCH)
        assert steps.at == 2, "one inserted step follows another"
        await here.line("go to the sink")
        assert here.teach.snapshot.shown[:2] == ("go to the tap", "go to the sink")
        await here.key("f9", "escape")
        assert steps.at is None
        await here.line("set the kettle on the left burner")
        assert here.teach.snapshot.shown[-1] == "set the kettle on the left burner"


async def test_what_fits_where_a_step_is_inserted_is_what_could_be_done_there(
    tmp_path: Path,
) -> None:
    async with room(tmp_path) as here:
        await here.lines("boil the water", *FETCH[:2])
        actions = here.teach.query_one("#actions", OptionList)
        assert "· take …" in labels(actions)
        await here.key("f9", "up", "i")
        assert "take …" in labels(actions), "the robot stood at the kettle then, its hands empty"


async def test_steps_are_taken_away_and_moved_with_one_key_each(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines("boil the water", *FETCH, "go to the tap")
        await here.key("f9", "up", "e")
        assert shown(here) == (*FETCH[:2], "go to the tap", FETCH[2])
        assert steps_of(here).cursor == 2, "the cursor goes with the step"
        await here.key("l")
        assert shown(here) == (*FETCH, "go to the tap")
        await here.key("x")
        assert shown(here) == FETCH
        await here.key("u")
        assert shown(here) == (*FETCH, "go to the tap")
        await here.key("home", "down", "X")
        assert shown(here) == FETCH[:1]


async def test_an_edit_that_cannot_be_is_explained_and_changes_nothing(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines("boil the water", *FETCH, "set the kettle on the left burner")
        before = here.teach.snapshot
        await here.key("f9", "home", "down", "x")
        assert shown(here) == before.shown
        assert here.teach.snapshot.moment.state == before.moment.state
        assert "not holding the kettle" in changed(here)


async def test_the_scene_shows_the_world_after_the_step_under_the_cursor(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines("open the fridge", "go to the fridge", "open the fridge")
        scene = here.teach.query_one(SceneView)
        assert "fridge ✱◫ open" in scene.text
        await here.key("f9", "up", "up")
        assert "fridge ■ shut ◂ robot" in scene.text
        await here.key("space")
        assert "fridge ✱◫ open" in scene.text or "fridge ◫ open" in scene.text


async def test_steps_run_one_after_the_other_at_the_speed_that_was_set(tmp_path: Path) -> None:
    async with room(tmp_path, speed=8.0) as here:
        await here.lines("open the fridge", "go to the fridge", "open the fridge")
        await here.key("f9")
        steps, seen = steps_of(here), list[int]()
        steps.steer("run_steps")
        while steps.running:
            seen.append(steps.cursor)
            await asyncio.sleep(0.02)
        assert sorted(set(seen)) in ([-1, 0], [-1, 0, 1])
        assert steps.cursor == 2, "at the end"


async def test_the_same_by_mouse(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines("boil the water", "go to the tap", *FETCH[:2])
        steps, bar = steps_of(here), here.teach.query_one(KeyBar)
        await here.click_target(steps, "0")
        assert steps.has_focus
        await here.click_target(bar, "remove_step")
        assert shown(here) == FETCH[:2]
        await here.click_target(steps, "0")
        await here.click_target(bar, "insert_here")
        assert steps.at == 1


async def test_edits_are_typed_too(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.lines(
            "boil the water", *FETCH, "insert 1 go to the tap", "insert: 5 wait", "move: 5 4"
        )
        assert shown(here) == ("go to the tap", *FETCH[:2], "wait", FETCH[2])
        await here.lines("move: 4 1", "remove: 1-2")
        assert shown(here) == FETCH


async def test_why_an_action_cannot_be_done_is_said_before_it_is_tried(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await here.line("open the fridge")
        actions = here.teach.query_one("#actions", OptionList)
        actions.highlighted = labels(actions).index("· open …")
        await here.key("enter")
        told = here.teach.query_one("#so-chosen", RowsView)
        words = " ".join(plain(row) for row in told.rows).split()
        assert "not possible yet: the robot is not near the bottom cupboard" in " ".join(words)


async def test_fifty_one_steps_can_be_shown_and_seen(tmp_path: Path) -> None:
    things = ("Tap_1", "Mug_2", "Counter_1")
    steps = [f"do: moveto {things[index % 3]}" for index in range(51)]
    path = said(tmp_path, "command: boil the water", *steps)
    async with room(tmp_path, OpenSession(path), size=NARROW) as here:
        view = steps_of(here)
        assert len(here.teach.snapshot.shown) == 51
        await here.key("f9", "up")
        rows = [view.render_line(y) for y in range(view.size.height)]
        assert any("▸ 51" in row.text for row in rows), "the last step is in view"
        await here.key("e")
        assert view.cursor == 49


def test_steps_are_drawn_with_the_cursor_and_where_the_next_one_comes() -> None:
    drawn = [[plain(row) for row in part] for part in step_rows(("go", "take"), 1, 1, 40)]
    assert drawn == [["   1 go"], ["   + next step here", "▸  2 take"], ["     the end"]]


def test_what_changed_is_told_with_trifles_last() -> None:
    changes = (Change("the robot is near the mug", True), Change("the mug is wet"))
    rows = [plain(row) for row in change_rows(changes, "No.", 2, 40)]
    assert rows == ["✗ No.", "✱ the mug is wet", "· the robot is near the mug"]
    assert [plain(row) for row in change_rows((), "", 0, 40)] == ["Nothing shown yet."]
    assert "Nothing is different" in plain(change_rows((), "", 1, 40)[0])
