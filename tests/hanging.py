"""Where the tasks of a hanging test wait. The stack of the loop that waits for them never says."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from types import FrameType
from typing import Any

import pytest

from docs.diagrams import ROOT


def tasks_of(item: pytest.Item) -> str:
    """The tasks of an asynchronous test that are in code of the project; empty for other tests."""
    if item.get_closest_marker("asyncio") is None:
        return ""
    loop = asyncio.get_event_loop_policy().get_event_loop()
    tasks = sorted(asyncio.all_tasks(loop), key=lambda task: task.get_name())
    stacks = [list(_frames(task.get_coro())) for task in tasks]
    ours = (str(ROOT), str(item.path.parent))
    told = [
        "\n".join(f"{f.f_code.co_filename}:{f.f_lineno}: in {f.f_code.co_qualname}" for f in frames)
        for frames in stacks
        if any(frame.f_code.co_filename.startswith(ours) for frame in frames)
    ]
    return "\n\n".join(told)


def _frames(waiting: Any) -> Iterator[FrameType]:
    """The frames from a coroutine to the innermost one that it waits for."""
    while waiting is not None:
        frame = getattr(waiting, "cr_frame", None) or getattr(waiting, "gi_frame", None)
        if frame is not None:
            yield frame
        waiting = getattr(waiting, "cr_await", None) or getattr(waiting, "gi_yieldfrom", None)
