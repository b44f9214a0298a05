"""Choosing a study on the home screen: only one that fits, and then the app makes room for it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from textual.widgets import Input, Static

from tests.study.files import SMALL
from tests.tui.frames import piloted
from tests.tui.room import NARROW, options
from tests.tui.study.led import study_file
from verbteach_tui.app import VerbteachApp
from verbteach_tui.beginning import Beginning
from verbteach_tui.options import OpenHome, OpenNew
from verbteach_tui.room import app_options
from verbteach_tui.screens.home import HomeScreen
from verbteach_tui.screens.studies import StudyChooser
from verbteach_tui.screens.teach import TeachScreen


async def test_a_study_nearby_is_offered_and_begun_with_a_code(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    file = study_file(tmp_path, SMALL)
    begun: list[tuple[Path, str | None]] = []

    def take_part(file: Path, code: str | None) -> int:
        begun.append((file, code))
        return 7

    chosen = replace(options(tmp_path / "s", OpenHome()), take_part=take_part)
    app = VerbteachApp(chosen)
    async with piloted(app, size=NARROW) as pilot:
        await pilot.pause()
        await pilot.press("s")
        for _ in range(200):
            await pilot.pause(0.02)
            if isinstance(app.screen, StudyChooser) and app.screen._files:
                break
        assert list(app.screen._files) == ["study.toml", "example"]  # type: ignore[attr-defined]
        app.screen.query_one("#file", Input).value = "nowhere.toml"
        app.screen.query_one("#file", Input).focus()
        await pilot.press("enter")
        for _ in range(200):
            await pilot.pause(0.02)
            if "nowhere" in str(app.screen.query_one("#problem", Static).content):
                break
        app.screen.query_one("#file", Input).value = ""
        app.screen.query_one("#code", Input).value = "abcd"
        app.screen.query_one("#studies").focus()
        await pilot.press("enter")
        for _ in range(200):
            await pilot.pause(0.02)
            if app.afterwards is not None:
                break
    assert app.afterwards is not None
    assert app.afterwards() == 7
    assert begun == [(file, "abcd")]


async def test_a_study_with_noise_of_a_kind_that_is_nowhere_is_not_begun(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    study_file(tmp_path, SMALL.replace('policy = "she16"', 'policy = "she16"\nnoise = "0.2,onn=0"'))
    home = app_options(Beginning(tmp_path / "s", "app"), OpenHome())
    app = VerbteachApp(replace(home, take_part=lambda file, code: 0))
    async with piloted(app, size=NARROW) as pilot:
        await pilot.press("s")
        said = ""
        for _ in range(200):
            await pilot.pause(0.02)
            if isinstance(app.screen, StudyChooser) and app.screen._files:
                await pilot.press("enter")
                said = str(app.screen.query_one("#problem", Static).content)
            if said:
                break
        assert "study.toml:27" in said
        assert "'onn'" in said
        assert app.afterwards is None


async def test_who_presses_ctrl_c_is_told_how_to_quit_and_what_becomes_of_it(
    tmp_path: Path,
) -> None:
    app = VerbteachApp(options(tmp_path / "s", OpenNew("kitchen-1")))
    async with piloted(app) as pilot:
        for _ in range(200):
            await pilot.pause(0.02)
            if isinstance(app.screen, TeachScreen):
                break
        await pilot.press("tab", "ctrl+c")
        await pilot.pause()
        (told,) = app._notifications
        assert told.message == "^q quits. All that you taught is kept."


async def test_where_the_app_is_served_there_is_no_study_to_choose(tmp_path: Path) -> None:
    app = VerbteachApp(options(tmp_path / "s", OpenHome()))
    async with piloted(app) as pilot:
        await pilot.press("s")
        await pilot.pause(0.1)
        assert isinstance(app.screen, HomeScreen)
