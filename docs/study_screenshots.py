"""Pictures of the example study, as a participant sees it, and of the lab, from the running app.

``python docs/screenshots.py`` takes them with the others.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from docs.played import Step, do, picture, settled
from verbteach_sessions.study.bundled import EXAMPLE
from verbteach_tui.app import VerbteachApp
from verbteach_tui.beginning import Beginning
from verbteach_tui.options import OpenHome, OpenNew
from verbteach_tui.room import app_options
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


async def in_the_lab(folder: Path) -> dict[str, str]:
    """Look into the lab: what can be set, and what it means."""
    with _inside(folder):
        app = VerbteachApp(app_options(Beginning(Path("sessions"), "app"), OpenHome()))
        async with app.run_test(size=WIDE) as pilot:
            await settled(pilot)
            await do(pilot, Step(key="l"))
            await do(pilot, Step(key="down"))
            return {"lab": picture(app)}


@contextmanager
def _inside(folder: Path) -> Iterator[None]:
    """Work in ``folder``, so that what is seen names no place of this machine."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
