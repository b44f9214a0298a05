"""A participant in a test: led through a study in plain lines, or on the screen by a pilot."""

from __future__ import annotations

import io
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import replace
from pathlib import Path
from time import monotonic
from typing import Any

from tests.study.files import SMALL
from tests.tui.frames import piloted
from tests.tui.room import PATIENCE, WIDE, Room
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.study.progress import VISIT_NAME
from verbteach_tui.beginning import Beginning
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.options import OpenNew
from verbteach_tui.plain import lead
from verbteach_tui.room import app_options
from verbteach_tui.study import reading_screen
from verbteach_tui.study.app import StudyApp
from verbteach_tui.study.lesson_screen import LessonScreen
from verbteach_tui.study.plain_study import StudyTalk
from verbteach_tui.study.reading_screen import ReadingScreen
from verbteach_tui.study.run import StudyRun

SHOW = ("open the fridge", "go to the fridge", "open the fridge", "done", "yes")
WHOLE = """
yes
next
{show}
{show}
open the fridge
good
50
33
skip
0
100
7
nothing more
""".format(show="\n".join(SHOW))


def study_file(folder: Path, text: str = SMALL) -> Path:
    """The study's file, written."""
    path = folder / "study.toml"
    path.write_text(text, "utf-8")
    return path


def begun(folder: Path, code: str | None, text: str = SMALL, interface: str = "plain") -> StudyRun:
    """A run whose records go to ``folder / "records"``."""
    beginning = Beginning(folder / "records", interface)
    return StudyRun.open(study_file(folder, text), beginning, code)


def plainly(folder: Path, lines: str, code: str | None = "pppp", text: str = SMALL) -> str:
    """What is printed while ``lines`` are said."""
    out = io.StringIO()
    talk = StudyTalk(begun(folder, code, text))
    try:
        assert lead(talk, io.StringIO(lines), out) == 0
    finally:
        talk.close()
    return out.getvalue()


class Led(Room):
    """A participant at the screen."""

    @property
    def study(self) -> StudyApp:
        """The app."""
        assert isinstance(self.app, StudyApp)
        return self.app

    async def come(self, kind: type[Any]) -> None:
        """Wait until a screen of this kind is in front and everything has settled."""
        end = monotonic() + PATIENCE
        while monotonic() < end:
            await self.pilot.pause(0.01)
            if isinstance(self.app.screen, kind) and not self._busy():
                await self.pilot.pause()
                if isinstance(self.app.screen, LessonScreen):
                    self.hurry()
                if isinstance(self.app.screen, ReadingScreen):
                    await self.pilot.pause(reading_screen.TOO_SOON)
                return
        raise AssertionError(f"no {kind.__name__}, but {self.app.screen}")

    def _busy(self) -> bool:
        groups = ("session", "open", "study")
        return any(w.is_running for w in self.app.workers if w.group in groups)

    async def press(self, *keys: str) -> None:
        """Press keys without waiting for a robot."""
        await self.pilot.press(*keys)
        await self.pilot.pause()

    def hurry(self) -> None:
        """Let keys count however fast they come."""
        self.teach.guard = KeyGuard(0.0, 0.0)


@asynccontextmanager
async def on_screen(
    folder: Path, code: str | None = "ssss", text: str = SMALL, size: tuple[int, int] = WIDE
) -> AsyncIterator[Led]:
    """The app of a study, led by a pilot."""
    run = begun(folder, code, text, "app")
    options = app_options(run.beginning, OpenNew(""), speed=0.0)
    app = StudyApp(replace(options, create=lambda scene: run.open_session()), run)
    async with piloted(app, size) as pilot:
        yield Led(app, pilot)
    app.close_sessions()
    run.close()


def visit_events(folder: Path, code: str) -> list[tuple[str, dict[str, Any]]]:
    """What the record of the visit says, without when and where."""
    reader = LogReader(folder / "records" / code / VISIT_NAME)
    outside = {"created", "interface", "participant", "session", "completion"}
    return [(e.type, {k: v for k, v in e.data.items() if k not in outside}) for e in reader]


def sessions_of(folder: Path, code: str) -> list[Path]:
    """The sessions of a participant, in order."""
    home = folder / "records" / code
    reader = LogReader(home / VISIT_NAME)
    return [home / event.data["session"] for event in reader if event.type == "began"]
