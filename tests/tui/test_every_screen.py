"""Every screen at every size: nothing over an edge, nothing cut off, nothing empty.

Each test goes through screens as a person would, and at each stop the terminal
takes all sizes in turn.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.study.files import SMALL, study
from tests.tui.fits import SIZES, check_fits_everywhere
from tests.tui.frames import piloted
from tests.tui.lab.test_lab import ROW, SLOW, worker
from tests.tui.room import BOIL_THE_WATER, Room, options, room, said
from tests.tui.study.led import on_screen
from tests.tui.test_app_layout import in_view
from verbteach_tui.app import VerbteachApp
from verbteach_tui.lab.jobs import COMPARE, Job
from verbteach_tui.lab.results import lab_folder, save_job, save_rows
from verbteach_tui.options import OpenHome, OpenRecord, OpenSession
from verbteach_tui.screens.failure import FailureScreen
from verbteach_tui.screens.help import HelpScreen
from verbteach_tui.screens.lab import LabScreen
from verbteach_tui.screens.lab_runs import EarlierRuns
from verbteach_tui.screens.note import NoteScreen
from verbteach_tui.screens.scenes import ScenePicker
from verbteach_tui.screens.studies import StudyChooser
from verbteach_tui.screens.tour import STOPS, TourScreen
from verbteach_tui.screens.turns import TurnPicker
from verbteach_tui.screens.verbs import VerbsScreen
from verbteach_tui.study.leaving_screen import LeavingScreen
from verbteach_tui.study.lesson_screen import LessonScreen
from verbteach_tui.study.questionnaire_screen import QuestionnaireScreen
from verbteach_tui.study.reading_screen import ReadingScreen

TWENTY_STEPS = (
    *BOIL_THE_WATER[:-2],
    *("do: moveto Fridge_1", "do: moveto Sink_1") * 7,
)


async def test_asking_and_showing(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        await check_fits_everywhere(here.pilot)
        await here.line("wash the mug")
        await check_fits_everywhere(here.pilot)
        await here.key("w")
        await check_fits_everywhere(here.pilot)
        await here.key("s", "f5")
        assert isinstance(here.app.screen, VerbsScreen)
        await check_fits_everywhere(here.pilot)
        await here.key("escape")
        await here.line("open the fridge")
        await check_fits_everywhere(here.pilot)


async def test_a_long_demonstration_and_the_goal_read_back(tmp_path: Path) -> None:
    async with room(tmp_path, OpenSession(said(tmp_path, *TWENTY_STEPS))) as here:
        assert len(here.teach.snapshot.shown) == len(TWENTY_STEPS) - 1
        await check_fits_everywhere(here.pilot)
        await here.key("f9", "up")
        await check_fits_everywhere(here.pilot)
        await here.key("d")
        assert here.phase == "read_back"
        await check_fits_everywhere(here.pilot)


async def test_carrying_out_and_looking_around(tmp_path: Path) -> None:
    again = said(tmp_path, *BOIL_THE_WATER, "scene: kitchen-3", "command: boil the water")
    async with room(tmp_path, OpenSession(again)) as here:
        assert here.phase == "judgement"
        await check_fits_everywhere(here.pilot)
        await here.key("f7")
        await check_fits_everywhere(here.pilot)
        await here.key("g")
        here.app.push_screen(FailureScreen("trying", RuntimeError("it fell over")))
        for key, screen in (
            ("", FailureScreen), ("f5", VerbsScreen), ("f6", ScenePicker), ("f8", TurnPicker),
            ("f1", HelpScreen),
        ):  # fmt: skip
            await here.key(*([key] if key else []))
            await here.pilot.pause(0.15)
            assert isinstance(here.app.screen, screen)
            await check_fits_everywhere(here.pilot)
            await here.key("escape")
        here.teach.say_word("note", "m", "key")
        await here.pilot.pause()
        assert isinstance(here.app.screen, NoteScreen)
        await check_fits_everywhere(here.pilot)


@pytest.mark.parametrize("size", [SIZES[0], SIZES[2]], ids=str)
async def test_the_tour(tmp_path: Path, size: tuple[int, int]) -> None:
    async with room(tmp_path, size=size) as here:
        here.teach.action_tour()
        for _ in STOPS:
            await here.pilot.pause()
            assert isinstance(here.app.screen, TourScreen)
            tour = here.app.screen.query_one("#tour")
            assert in_view(here, "#tour")
            stop = here.app.screen.stop.panel
            if stop in ("line", "keys"):
                assert not tour.region.overlaps(here.teach.query_one(f"#{stop}").region)
            await here.pilot.press("enter")


async def test_the_ways_in(tmp_path: Path) -> None:
    said(tmp_path, *BOIL_THE_WATER[:2])
    app = VerbteachApp(replace(options(tmp_path, OpenHome()), take_part=lambda file, code: 0))
    async with piloted(app) as pilot:
        await pilot.pause(0.3)
        await check_fits_everywhere(pilot)
        await pilot.press("s")
        await Room(app, pilot).until(lambda: isinstance(app.screen, StudyChooser))
        await check_fits_everywhere(pilot)
    app.close_sessions()


async def test_playing_back(tmp_path: Path) -> None:
    record = said(tmp_path, *BOIL_THE_WATER)
    async with room(tmp_path, OpenRecord(record), patient=True) as here:
        await check_fits_everywhere(here.pilot)
        await here.pilot.press("right", "right", "right")
        await check_fits_everywhere(here.pilot)
        assert not here.app.screen.query_one("#lists").display, "nothing can be done to a record"


async def test_the_lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    worker(monkeypatch, SLOW)
    folder = tmp_path / "sessions"
    earlier = lab_folder(folder) / "20300101-000000-abcdefgh"
    save_job(earlier, Job(kind=COMPARE, seed=3))
    save_rows(earlier, [ROW, {**ROW, "policy": "rl"}])
    async with room(folder, OpenHome()) as here:
        await here.pilot.press("l")
        await here.pilot.pause(0.2)
        assert isinstance(here.app.screen, LabScreen)
        await check_fits_everywhere(here.pilot)
        here.app.screen.query_one(EarlierRuns).focus()
        await here.pilot.pause()
        shown = here.app.screen.query_one("#outcome")
        assert shown.border_title == f"Policies of {earlier.name}"
        await here.pilot.press("enter")
        assert here.app.screen.query_one("LabSettings").job.seed == 3  # type: ignore[attr-defined]
        await here.pilot.press("enter")
        await here.pilot.pause(0.3)
        await check_fits_everywhere(here.pilot)
        await here.pilot.press("x")
        await here.pilot.pause(0.3)
        await check_fits_everywhere(here.pilot)


async def test_a_study(tmp_path: Path) -> None:
    text = SMALL.replace("Do you agree?", "You teach a robot. " * 60)
    async with on_screen(tmp_path, text=text) as here:
        await here.come(ReadingScreen)
        await check_fits_everywhere(here.pilot)
        await here.pilot.resize_terminal(60, 20)
        await here.pilot.pause()
        page = here.app.screen.query_one("#text")
        assert page.border_subtitle == "more below: ↓"
        await here.press("end")
        await here.pilot.pause(0.5)
        assert not page.border_subtitle
        await here.press("y")
        await here.come(ReadingScreen)
        await check_fits_everywhere(here.pilot)
        await here.press("enter")
        await here.come(ReadingScreen)
        await here.press("enter")
        await here.come(LessonScreen)
        await check_fits_everywhere(here.pilot)
        await here.line("open the fridge")
        await check_fits_everywhere(here.pilot)
        await here.press("f10")
        assert isinstance(here.app.screen, LeavingScreen)
        await check_fits_everywhere(here.pilot)
        await here.press("e")
        await here.come(ReadingScreen)
        await check_fits_everywhere(here.pilot)
        here.app.push_screen(QuestionnaireScreen("A study", study().questionnaire))
        await here.come(QuestionnaireScreen)
        await check_fits_everywhere(here.pilot)
