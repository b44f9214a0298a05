"""The lab's screen: starts, shows and cancels work without ever waiting for it."""

from __future__ import annotations

import asyncio
import time
from pathlib import Path

import pytest

from tests.tui.lab.test_lab import ROW, SLOW, worker
from tests.tui.room import NARROW, NORMAL, WIDE, Room, room
from tests.tui.test_app_layout import check_nothing_overflows
from verbteach_tui.lab.jobs import COMPARE, Job
from verbteach_tui.lab.results import lab_folder, save_job, save_rows
from verbteach_tui.options import OpenHome
from verbteach_tui.screens.home import HomeScreen
from verbteach_tui.screens.lab import LabScreen
from verbteach_tui.screens.lab_runs import EarlierRuns
from verbteach_tui.screens.lab_settings import LabSettings
from verbteach_tui.views.rows import plain
from verbteach_tui.widgets.rows_view import RowsView

BUSY = """
import json, sys, time
sys.stdin.readline()
for n in range(1, 2000):
    line = {"stage": "learning", "done": n, "total": 2000, "figures": [n % 7]}
    print(json.dumps(line), flush=True)
    if n > 100: time.sleep(0.005)
"""
TWO_ROWS = f"""
import json, sys
sys.stdin.readline()
for policy in ("silent", "manual"):
    print(json.dumps({{"row": {{**{ROW!r}, "policy": policy}}}}), flush=True)
print(json.dumps({{"saved": "x"}}), flush=True)
"""


def text(here: Room, name: str) -> str:
    return "\n".join(plain(row) for row in here.app.screen.query_one(f"#{name}", RowsView).rows)


async def until(here: Room, name: str, word: str) -> None:
    for _ in range(600):
        await here.pilot.pause(0.05)
        if word in text(here, name):
            return
    raise AssertionError(text(here, name))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "sessions"


@pytest.mark.parametrize("size", [NARROW, NORMAL, WIDE, (200, 50)], ids=str)
async def test_a_run_is_started_shown_and_cancelled(
    folder: Path, size: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    worker(monkeypatch, SLOW)
    async with room(folder, OpenHome(), size=size) as here:
        await here.pilot.press("l")
        await here.pilot.pause()
        assert isinstance(here.app.screen, LabScreen)
        check_nothing_overflows(here)
        await here.pilot.press("enter")
        await until(here, "progress", "1 of 9")
        check_nothing_overflows(here)
        await here.pilot.press("x")
        await until(here, "progress", "Cancelled")
        await here.pilot.press("escape")
        assert isinstance(here.app.screen, HomeScreen)


async def test_the_curve_takes_the_room_that_the_settings_leave(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker(monkeypatch, BUSY)
    async with room(folder, OpenHome(), size=NARROW) as here:
        await here.pilot.press("l", "enter")
        await until(here, "outcome", "return of a dialogue")
        assert not here.app.screen.query_one("#side").display
        await here.pilot.press("x")
        await here.pilot.pause(0.3)
        assert here.app.screen.query_one(LabSettings).has_focus


async def test_policies_are_compared_side_by_side(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker(monkeypatch, TWO_ROWS)
    async with room(folder, OpenHome()) as here:
        await here.pilot.press("l", "right", "enter")
        await until(here, "progress", "Done")
        assert here.app.screen.query_one(LabSettings).job.kind == COMPARE
        assert "silent" in text(here, "outcome")
        assert "manual" in text(here, "outcome")


async def test_earlier_runs_are_looked_at_in_a_small_window_too(folder: Path) -> None:
    earlier = lab_folder(folder) / "20300101-000000-abcdefgh"
    save_job(earlier, Job(kind=COMPARE, seed=3))
    save_rows(earlier, [{**ROW, "policy": name} for name in ("silent", "manual", "split", "rl")])
    async with room(folder, OpenHome(), size=NARROW) as here:
        await here.pilot.press("l")
        runs = here.app.screen.query_one(EarlierRuns)
        await here.until(lambda: runs.display)
        assert "▸" not in text(here, "earlier")
        await here.pilot.press("tab", "tab")
        assert runs.has_focus
        assert "▸ 20300101" in text(here, "earlier")
        shown = here.app.screen.query_one("#outcome")
        assert shown.scrollable_content_region.height > len(("head", "a", "b", "c", "d"))
        await here.pilot.press("enter")
        assert here.app.screen.query_one(LabSettings).job.seed == 3
        assert "▸" not in text(here, "earlier")


async def test_work_goes_on_while_the_person_is_elsewhere_and_ends_with_the_app(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker(monkeypatch, SLOW)
    async with room(folder, OpenHome()) as here:
        await here.pilot.press("l", "enter")
        await until(here, "progress", "1 of 9")
        lab = here.app._lab
        assert lab is not None
        await here.pilot.press("escape", "l")
        await until(here, "progress", "1 of 9")
        assert lab.state.running
    assert lab.state.phase == "cancelled"


async def test_the_screen_stays_quick_while_the_worker_is_busy(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker(monkeypatch, BUSY)
    async with room(folder, OpenHome()) as here:
        await here.pilot.press("l", "enter")
        await until(here, "outcome", "learning")
        worst = 0.0
        for _ in range(40):
            began = time.perf_counter()
            await asyncio.sleep(0.02)
            worst = max(worst, time.perf_counter() - began - 0.02)
        assert worst < 0.25  # 100 ms on a machine of one's own
        await here.pilot.press("x")
