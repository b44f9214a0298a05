"""What the pictures have in common: keys and lines given to the running app, and its SVG."""

from __future__ import annotations

import re
from typing import NamedTuple

from textual.app import App
from textual.pilot import Pilot

from verbteach_tui.keyguard import KeyGuard
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.widgets.command_input import CommandInput


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
    screen = pilot.app.screen
    if isinstance(screen, TeachScreen):
        screen.guard = KeyGuard(0.0, 0.0)
    if step.line:
        line = screen.query_one(CommandInput)
        line.focus()
        line.value = step.line
    if step.line or step.key:
        await pilot.press(step.key or "enter")
    await settled(pilot)
    _check(pilot, step)


async def settled(pilot: Pilot[None]) -> None:
    """Wait until no worker runs and all that they did is drawn."""
    for _ in range(1500):
        await pilot.pause(0.02)
        screen = pilot.app.screen
        thinking = isinstance(screen, TeachScreen) and screen.thinking
        if not thinking and not any(worker.is_running for worker in pilot.app.workers):
            break
    await pilot.pause(0.2)


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
