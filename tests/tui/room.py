"""The teaching room under test: an app driven by Pilot, on the bundled scenes."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from time import monotonic

from textual.pilot import Pilot
from textual.widgets import OptionList

from tests.tui.frames import piloted
from verbteach_scenarios.scenes import load_scene, scene_ids
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session
from verbteach_tui.app import VerbteachApp
from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.options import AppOptions, OpenHome, Opening, OpenNew, OpenSession
from verbteach_tui.screens.home import HomeScreen
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.dialogue_view import DialogueView
from verbteach_tui.widgets.rows_view import RowsView

SETTINGS = make_settings()
WIDE, NORMAL, NARROW = (120, 40), (80, 24), (60, 20)
SIZES = (WIDE, NORMAL, NARROW)
AS_STEERED = 0.001
"""Steps a second: so slow that an execution goes on by what is pressed and clicked alone."""
PATIENCE = 60.0
"""Seconds that a test waits for what comes: far longer than it takes, on a busy machine, too."""

OPEN_THE_FRIDGE = ("go to the fridge", "open the fridge")
TO_OPEN = (
    "command: open the fridge", "do: moveto Fridge_1", "do: open Fridge_1", "done", "good",
)  # fmt: skip
SHOWN, ASKED, TAUGHT = TO_OPEN[:3], TO_OPEN[:4], TO_OPEN
"""How the fridge is opened was shown; the goal is read back; the verb is learned."""
BOIL_THE_WATER = (
    "command: boil the water", "do: moveto Kettle_1", "do: grasp Kettle_1", "do: moveto Burner_1",
    "do: set-on Kettle_1 Burner_1", "do: moveto StoveKnob_1", "do: turn StoveKnob_1", "done",
    "good",
)  # fmt: skip


def options(folder: Path, opening: Opening | None = None, speed: float = 0.0) -> AppOptions:
    """Options for an app whose sessions go to ``folder``; executions show at once."""
    return AppOptions(
        settings=SETTINGS,
        scenes=scene_ids,
        create=lambda scene: Session.create(folder, Header.new(scene, interface="app"), SETTINGS),
        resume=lambda path: Session.resume(path, SETTINGS),
        sessions=folder,
        load=load_scene,
        opening=opening or OpenHome(),
        speed=speed,
    )


class Room:
    """An app in a test, with what a person would do as methods."""

    def __init__(self, app: VerbteachApp, pilot: Pilot[None]) -> None:
        self.app, self.pilot = app, pilot

    @property
    def teach(self) -> TeachScreen:
        """The teaching room, in front or behind a dialog."""
        screens = [s for s in self.app.screen_stack if isinstance(s, TeachScreen)]
        assert screens, self.app.screen_stack
        return screens[-1]

    def hurry(self) -> None:
        """Let keys count however fast they come."""
        if isinstance(self.app.screen, HomeScreen):
            self.app.screen.pause = 0.0
        else:
            self.teach.guard = KeyGuard(0.0, 0.0)

    @property
    def phase(self) -> str:
        """What the robot waits for."""
        return self.teach.snapshot.phase.value

    @property
    def dialogue(self) -> str:
        """Everything said, as shown."""
        view = self.teach.query_one(DialogueView)
        return "\n".join(f"{line.speaker}: {line.text}" for line in view.lines)

    async def settle(self) -> None:
        """Wait until the robot has answered and the answer is on the screen, or the app is left."""
        end = monotonic() + PATIENCE
        while monotonic() < end:
            await self.pilot.pause()
            if not self.app.is_running:
                return
            teaching = [s for s in self.app.screen_stack if isinstance(s, TeachScreen)]
            if not any(screen.thinking for screen in teaching) and self._settled_workers():
                await self.pilot.pause()
                return
            await self.pilot.pause(0.01)
        raise AssertionError("the robot does not answer")

    def _settled_workers(self) -> bool:
        return not any(w.is_running for w in self.app.workers if w.group in ("session", "open"))

    async def until(self, come: Callable[[], object], otherwise: str = "it never came") -> None:
        """Wait for what is to ``come``."""
        end = monotonic() + PATIENCE
        while not come():
            assert monotonic() < end, otherwise
            await self.pilot.pause(0.01)

    async def line(self, text: str) -> None:
        """Type a line and press Enter; a long one is put in at once, as by pasting."""
        entry = self.teach.query_one(CommandInput)
        entry.focus()
        entry.value = text
        await self.pilot.press("enter")
        await self.settle()

    async def lines(self, *texts: str) -> None:
        """Type several lines."""
        for text in texts:
            await self.line(text)

    async def key(self, *keys: str) -> None:
        """Press keys, and wait for what comes of each."""
        for key in keys:
            await self.pilot.press(key)
            await self.settle()

    async def choose(self, list_id: str, label: str) -> None:
        """Go to an entry of a list with the arrow keys, and take it with Enter."""
        options = self.app.screen.query_one(f"#{list_id}", OptionList)
        await self.until(lambda: options.has_focus, f"{list_id} has not got the keys")
        for _ in range(options.option_count + 1):
            highlighted = options.highlighted_option
            if highlighted is not None and _text(highlighted.prompt) == label:
                break
            await self.pilot.press("down")
        else:
            raise AssertionError(f"{label!r} is not in {list_id}: {labels(options)}")
        await self.key("enter")

    async def click_target(self, view: RowsView, target: str) -> None:
        """Click what is drawn for ``target`` in ``view``."""
        await self.pilot.pause()
        for y, row in enumerate(view.rows):
            x = 0
            for span in row:
                if span.target == target:
                    left, top = view.gutter.left, view.gutter.top
                    offset = (left + x - view.scroll_offset.x, top + y - view.scroll_offset.y)
                    assert await self.pilot.click(view, offset=offset)
                    await self.settle()
                    return
                x += len(span.text)
        raise AssertionError(f"{target!r} is nowhere to be clicked in {view!r}")


def labels(options: OptionList) -> list[str]:
    """What a list offers."""
    return [_text(option.prompt) for option in options.options]


def _text(prompt: object) -> str:
    return str(getattr(prompt, "plain", prompt))


@asynccontextmanager
async def room(
    folder: Path,
    opening: Opening | None = None,
    *,
    size: tuple[int, int] = WIDE,
    speed: float = 0.0,
    patient: bool = False,
    after: tuple[str, ...] = (),
) -> AsyncIterator[Room]:
    """An app in a room; unless ``patient``, keys count however fast they come.

    With ``after``, in a session in which these lines of a script were said.
    """
    if after:
        opening = OpenSession(said(folder, *after))
    app = VerbteachApp(options(folder, opening or OpenNew("kitchen-1"), speed))
    async with piloted(app, size) as pilot:
        here = Room(app, pilot)
        await here.settle()
        if not patient:
            here.hurry()
        yield here
    app.close_sessions()


def said(folder: Path, *lines: str, scene: str = "kitchen-1") -> Path:
    """A session in which ``lines`` of a script were said; opening it is faster than typing them."""
    with Session.create(folder, Header.new(scene, interface="app"), SETTINGS) as session:
        drive(session, ScriptTeacher(lines))
        return session.path


async def learn_to_open(here: Room) -> None:
    """Teach the robot to open the fridge, by typing."""
    await here.lines("open the fridge", *OPEN_THE_FRIDGE, "done", "yes")
