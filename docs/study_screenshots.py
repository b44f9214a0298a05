"""Pictures of the example study, as a participant sees it, and of the lab, from the running app.

``python docs/screenshots.py`` takes them with the others.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from textual.pilot import Pilot

from docs.played import Step, do, picture, settled
from verbteach_sessions.study.bundled import EXAMPLE
from verbteach_tui.app import VerbteachApp
from verbteach_tui.beginning import Beginning
from verbteach_tui.lab.jobs import DIALOGUES
from verbteach_tui.options import OpenHome, OpenNew
from verbteach_tui.room import app_options
from verbteach_tui.screens.lab import LabScreen
from verbteach_tui.screens.lab_settings import LabSettings
from verbteach_tui.study.app import StudyApp
from verbteach_tui.study.run import StudyRun

NORMAL, WIDE = (80, 24), (120, 40)
CODE = "k7fq2mzt4w"
"""The code of whoever is seen taking part."""

TAKING_PART = (
    Step(shot="study-consent"),
    Step(key="y"),
    Step(key="enter"),
    Step(key="enter"),
    Step("open the fridge"),
    Step("walk to the fridge", shot="study-showing"),
    Step("open it"),
    Step("that's it", shot="study-goal"),
    Step(key="y"),
    Step(key="enter"),
    Step(key="f10"),
    Step(key="e"),
    Step(key="right"),
    Step(key="tab"),
    Step(key="left", shot="study-questions"),
)


async def take_part(folder: Path) -> dict[str, str]:
    """Take part in the example study, with a robot that sees well; the pictures by name."""
    file = folder / "study.toml"
    text = EXAMPLE.read_text("utf-8").replace('noise = "std3"', 'noise = "perfect"')
    file.write_text(text, "utf-8")
    run = StudyRun.open(file, Beginning(folder / "records", "app"))
    run.code = CODE
    options = app_options(run.beginning, OpenNew(""), speed=0.0)
    app = StudyApp(replace(options, create=lambda scene: run.open_session()), run)
    shots: dict[str, str] = {}
    async with app.run_test(size=NORMAL) as pilot:
        await settled(pilot)
        for step in TAKING_PART:
            await do(pilot, step)
            if step.shot:
                shots[step.shot] = picture(app)
    app.close_sessions()
    run.close()
    return shots


async def train(folder: Path) -> dict[str, str]:
    """Train in the lab, with as few dialogues as it offers, and look at the curve."""
    with _inside(folder):
        app = VerbteachApp(app_options(Beginning(Path("sessions"), "app"), OpenHome()))
        async with app.run_test(size=WIDE) as pilot:
            await settled(pilot)
            await pilot.press("l")
            await settled(pilot)
            await _set_fewest(pilot)
            await pilot.press("enter")
            await _over(pilot)
            await settled(pilot)
            return {"lab": picture(app)}


async def _set_fewest(pilot: Pilot[None]) -> None:
    """Go down to the number of dialogues, and to the fewest."""
    settings = pilot.app.screen.query_one(LabSettings)
    for _ in range(10):
        before = settings.job
        await pilot.press("left")
        if settings.job.dialogues < before.dialogues == DIALOGUES[1]:
            return
        if settings.job != before:
            await pilot.press("right")
        await pilot.press("down")


async def _over(pilot: Pilot[None]) -> None:
    """Wait until the lab's work is over."""
    screen = pilot.app.screen
    assert isinstance(screen, LabScreen)
    for _ in range(6000):
        await pilot.pause(0.1)
        state = screen._seen
        if state is not None and state.job is not None and not state.running:
            return
    raise SystemExit("the lab's work did not come to an end")


@contextmanager
def _inside(folder: Path) -> Iterator[None]:
    """Work in ``folder``, so that what is seen names no place of this machine."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
