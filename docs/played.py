"""What the pictures have in common: keys and lines given to the running app, and its SVG."""

from __future__ import annotations

import re
from collections.abc import Callable
from time import monotonic
from typing import NamedTuple

from textual.app import App
from textual.pilot import Pilot

from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.study.reading_screen import ReadingScreen
from verbteach_tui.widgets.command_input import CommandInput

PATIENCE = 120.0
"""Seconds after which something is taken for stuck: far longer than it takes."""


class Step(NamedTuple):
    """Type ``line``, else press ``key``; then take the picture ``shot``, if it has a name.

    ``phase`` is what the robot must wait for afterwards, where that matters.
    """

    line: str = ""
    key: str = ""
    shot: str = ""
    phase: str = ""


async def do(pilot: Pilot[None], step: Step) -> None:
    """Take a step, and wait until all that it led to is drawn."""
    app = pilot.app
    if step.line:
        await _until(pilot, lambda: bool(app.screen.query(CommandInput)), step)
    screen = app.screen
    if isinstance(screen, ReadingScreen):
        await _until(pilot, lambda: screen.is_readable, step)
    if isinstance(screen, TeachScreen):
        screen.guard = KeyGuard(0.0, 0.0)
    if step.line:
        line = screen.query_one(CommandInput)
        line.cursor_blink = False  # a picture does not hang on when it is taken
        line.focus()
        await _until(pilot, lambda: line.has_focus, step)
        line.value = step.line
    if step.line or step.key:
        await pilot.press(step.key or "enter")
    if isinstance(screen, ReadingScreen) and step.key in screen.keys:
        await _until(pilot, lambda: app.screen is not screen, step)
    await settled(pilot)
    _check(pilot, step)


async def settled(pilot: Pilot[None]) -> None:
    """Wait until no worker runs, twice in a row, and all that they did is drawn."""
    idle = 0

    def at_rest() -> bool:
        nonlocal idle
        screen = pilot.app.screen
        thinking = isinstance(screen, TeachScreen) and screen.thinking
        busy = thinking or any(worker.is_running for worker in pilot.app.workers)
        idle = 0 if busy else idle + 1
        return idle > 1

    await _until(pilot, at_rest, Step())
    await pilot.pause(0.2)


async def _until(pilot: Pilot[None], come: Callable[[], bool], step: Step) -> None:
    """Wait for what is to ``come``, on a busy machine, too."""
    end = monotonic() + PATIENCE
    while not come():
        if monotonic() > end:
            at = f" at {step.line or step.key!r}" if step.line or step.key else ""
            raise SystemExit(f"{type(pilot.app.screen).__name__} does not go on{at}")
        await pilot.pause(0.02)


def picture(app: App[None]) -> str:
    """The screen as SVG, without the fonts that it would fetch from elsewhere."""
    svg = re.sub(
        r"@font-face \{.*?\}\s*", "", app.export_screenshot(title="verbteach"), flags=re.DOTALL
    )
    return svg.replace("Fira Code", "DejaVu Sans Mono, Menlo, Consolas")


def _check(pilot: Pilot[None], step: Step) -> None:
    screen = pilot.app.screen
    if step.phase and isinstance(screen, TeachScreen):
        phase = screen.snapshot.phase.value
        if phase != step.phase:
            raise SystemExit(f"after {step.line or step.key!r} the robot waits for {phase}")
