"""Nothing heavy runs on the event loop: a handler that holds it up is found out."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from tests.tui.room import OPEN_THE_FRIDGE, room
from verbteach_tui.screens.teach import TeachScreen

ALLOWED = 0.1
"""Seconds of processor time that one callback may take."""


@asynccontextmanager
async def watched(allowed: float = ALLOWED) -> AsyncIterator[list[tuple[float, str]]]:
    """The callbacks of the event loop that took longer than ``allowed``, as they come.

    It is this thread's processor time that counts, so that a busy machine and
    the workers' own threads make no difference.
    """
    held: list[tuple[float, str]] = []
    run = asyncio.Handle._run

    def timed(handle: Any) -> None:
        start = time.thread_time()
        run(handle)
        taken = time.thread_time() - start
        if taken > allowed:
            task = getattr(handle._callback, "__self__", None)
            name = task.get_name() if isinstance(task, asyncio.Task) else repr(handle)
            held.append((taken, name))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(asyncio.Handle, "_run", timed)
        yield held


def handlers(held: list[tuple[float, str]]) -> list[tuple[float, str]]:
    """Those that are message handlers: not the painting, and not the test's own waiting."""
    return [one for one in held if one[1].startswith("message pump")]


async def test_a_lesson_holds_the_event_loop_up_nowhere(tmp_path: Path) -> None:
    async with room(tmp_path) as here:
        runs = []
        for _ in range(3):  # what is imported and cached at first use is no handler's doing
            async with watched() as held:
                await here.lines("open the fridge", *OPEN_THE_FRIDGE)
                await here.key("f9", "f7", "f7")
                await here.lines("done", "yes")
                await here.key("f5", "escape", "f8", "escape")
                await here.line("undo: 4")
                await here.key("s")
            runs.append(handlers(held))
            if not runs[-1]:
                break
        assert not runs[-1], runs


async def test_a_handler_that_holds_it_up_is_found_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def slow(self: TeachScreen) -> None:
        end = time.thread_time() + 2 * ALLOWED
        while time.thread_time() < end:
            pass

    async with room(tmp_path) as here:
        monkeypatch.setattr(TeachScreen, "waiting", slow)
        here.teach.call_later(here.teach.waiting)
        async with watched() as held:
            await here.settle()
        assert handlers(held)
