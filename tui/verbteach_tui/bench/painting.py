"""How long a key takes to show on the screen in a session with a long log.

`python -m verbteach_tui.bench.painting SESSION` opens such a session in the app
without a terminal, and prints the milliseconds of each key: keys that type, and
keys that take a turn back and do it again.
"""

from __future__ import annotations

import asyncio
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from verbteach_tui.bench.apart import measured_apart, tell

if TYPE_CHECKING:
    from textual.pilot import Pilot

    from verbteach_tui.app import VerbteachApp

SIZE = (120, 40)
ROUNDS = 12
TYPING = ("a", "b", "backspace", "backspace")
TURNING = ("ctrl+z", "ctrl+y")
PRESSED = (ROUNDS - 1) * (len(TYPING) + len(TURNING))  # keys that are timed
PATIENCE = 2.0


def key_to_paint(
    session: Path, seconds: float, done: Callable[[int], None], without: Sequence[str] = ()
) -> dict[str, list[float]]:
    """Milliseconds from a key to its paint, of ``typing`` and of ``turning`` keys."""
    words = (str(session),)
    found = measured_apart("verbteach_tui.bench.painting", words, seconds, done, without)
    return found or {"typing": [], "turning": []}


async def run(session: Path) -> dict[str, list[float]]:
    """Open the session, and press keys in it."""
    from verbteach_tui.app import VerbteachApp
    from verbteach_tui.beginning import Beginning
    from verbteach_tui.options import OpenSession
    from verbteach_tui.room import app_options
    from verbteach_tui.screens.teach import TeachScreen

    beginning = Beginning(session.parent, "app")
    app = VerbteachApp(app_options(beginning, OpenSession(session), speed=0.0))
    async with app.run_test(size=SIZE) as pilot:
        while not isinstance(app.screen, TeachScreen):
            await asyncio.sleep(0.01)
        await pilot.pause(0.5)
        await pilot.press("slash")  # to the input, whatever the robot waits for
        times = await _pressed(app, pilot)
    app.close_sessions()
    return times


async def _pressed(app: VerbteachApp, pilot: Pilot[None]) -> dict[str, list[float]]:
    painted = _Painted(app)
    times: dict[str, list[float]] = {"typing": [], "turning": []}
    for name, keys in (("typing", TYPING), ("turning", TURNING)):
        for number in range(ROUNDS):
            for key in keys:
                taken = await painted.after(key, name == "turning")
                if number:  # the first round only warms up
                    times[name].append(taken)
                    tell(len(times["typing"]) + len(times["turning"]))
                await pilot.pause(0.1)
    return times


class _Painted:
    """Sees when the app writes to its screen."""

    def __init__(self, app: VerbteachApp) -> None:
        self._app, self._last, self._changed = app, 0.0, 0.0
        shown: Any = app
        display = shown._display

        def noted(screen: Any, renderable: Any) -> None:
            # Without a terminal the app leaves out what it would write; that takes time, too.
            if hasattr(renderable, "render_segments"):
                renderable.render_segments(app.console)
            display(screen, renderable)
            self._last = time.perf_counter()

        shown._display = noted

    async def after(self, key: str, turn: bool) -> float:
        """Milliseconds from ``key`` until what it did is on the screen."""
        screen: Any = self._app.screen
        before, start, self._changed = screen.snapshot, time.perf_counter(), 0.0
        self._app.simulate_key(key)
        while time.perf_counter() - start < PATIENCE:
            await asyncio.sleep(0)
            if turn and screen.snapshot is before:
                continue
            if turn and not self._changed:
                self._changed = time.perf_counter()
            if self._last > (self._changed if turn else start):
                return (self._last - start) * 1000
        return PATIENCE * 1000


if __name__ == "__main__":
    tell(asyncio.run(run(Path(sys.argv[1]))))
