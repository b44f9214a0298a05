"""Apps under Pilot, seen as often as a test looks: what comes between two looks is not painted.

Textual paints sixty times a second and takes an app for idle after twenty milliseconds of
quiet. Where nobody watches, a look is what follows a key or a pause; by then the app is laid
out, and painted once. Quiet is seen after two times five milliseconds, if nothing waits in the
event loop by then, either.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager, contextmanager
from time import monotonic, process_time
from typing import Any
from unittest.mock import patch

from textual._compositor import Compositor, LayoutUpdate
from textual.app import App
from textual.pilot import Pilot

QUIET = 0.005
"""Seconds without work that make an app idle."""
WORK = 0.15
"""The share of them that waking up takes by itself, at most."""
PERIOD = 0.8 * QUIET
"""Seconds between two layouts: none may be due after a quiet time, as in Textual."""

_press, _pause, _render = Pilot.press, Pilot.pause, Compositor.render_update


@asynccontextmanager
async def piloted(app: App[Any], size: tuple[int, int] = (80, 24)) -> AsyncIterator[Pilot[Any]]:
    """An app under a pilot, painted after keys and pauses only, and waited for while it works."""
    with _when_looked_at():
        async with app.run_test(size=size) as pilot:
            yield pilot


@contextmanager
def _when_looked_at() -> Iterator[None]:
    with (
        patch.object(Compositor, "render_update", _render_asked_for),
        patch.object(Pilot, "press", _press_and_look),
        patch.object(Pilot, "pause", _pause_and_look),
        patch("textual.app.wait_for_idle", _idle),
        patch("textual.pilot.wait_for_idle", _idle),
        patch("textual.screen.UPDATE_PERIOD", PERIOD),
    ):
        yield


@contextmanager
def unpainted() -> Iterator[None]:
    """Lay out without painting, which takes most of the time and tells nothing of what fits."""
    with (
        patch.object(Compositor, "render_update", return_value=None),
        patch(f"{__name__}._look"),
    ):
        yield


async def at_rest(pilot: Pilot[Any], ready: Callable[[], object] = lambda: True) -> None:
    """Wait until it is ``ready`` and the picture stays as it is."""
    before: object = None
    for _ in range(600):
        await pilot.pause(0.05)
        now = _picture(pilot.app) if ready() else None
        if now is not None and now == before:
            return
        before = now
    raise AssertionError("the picture never comes to rest")


def _picture(app: App[Any]) -> object:
    """What is on the screen, in a form that is quicker made than a screenshot."""
    screens = app._background_screens
    update = _render(app.screen._compositor, full=True, screen_stack=screens)
    assert isinstance(update, LayoutUpdate)
    return [list(line) for line in update.strips]


def _render_asked_for(compositor: Compositor, full: bool = False, **more: Any) -> object:
    """What is asked for as a whole, as by a screenshot; of mere updates nothing."""
    return _render(compositor, full, **more) if full else None


async def _press_and_look(pilot: Pilot[Any], *keys: str) -> None:
    await _press(pilot, *keys)
    _look(pilot.app)


async def _pause_and_look(pilot: Pilot[Any], delay: float | None = None) -> None:
    await _pause(pilot, delay)
    _look(pilot.app)


def _look(app: App[Any]) -> None:
    """Lay out and paint what has changed since the last look."""
    if not app.is_running or not app.screen_stack:
        return
    screen = app.screen
    screen._on_timer_update()
    _render(screen._compositor, screen_stack=app._background_screens)


async def _idle(shortest: float = QUIET, longest: float = 1) -> None:
    """Wait until nothing is done and nothing is due, twice in a row: a busy machine may halt it."""
    start, quiet = monotonic(), 0
    while quiet < 2 and monotonic() - start < longest:
        before = process_time()
        await asyncio.sleep(QUIET)
        waiting = asyncio.get_running_loop()._ready  # type: ignore[attr-defined]
        working = bool(waiting) or process_time() - before > WORK * QUIET
        quiet = 0 if working or monotonic() - start < shortest else quiet + 1
