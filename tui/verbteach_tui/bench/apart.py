"""Measuring in a process of its own, which says how far it is and has to end in time.

The process prints one JSON value a line: numbers while it goes on (how much is
done), and at last an object, which is its answer.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from threading import Timer
from typing import Any

GRACE = 30.0
"""Seconds beyond its allowance before the process is ended: it has to load first."""


def measured_apart(
    module: str,
    words: Sequence[str],
    seconds: float,
    done: Callable[[int], None],
    without: Sequence[str] = (),
) -> dict[str, Any] | None:
    """What ``python -m module words`` answers; ``None`` where it fails or does not end.

    Packages named in ``without`` are to it as if they were not installed.
    """
    run = (
        "import runpy, sys;"
        f"sys.modules.update(dict.fromkeys({list(without)!r}));"
        f"runpy.run_module({module!r}, run_name='__main__')"
    )
    command = [sys.executable, "-c", run, *words]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as process:
        timer = Timer(seconds + GRACE, process.kill)
        timer.start()
        try:
            assert process.stdout is not None
            answer = _answer(process.stdout, done)
        finally:
            timer.cancel()
            process.kill()
    return answer


def _answer(lines: Iterable[str], done: Callable[[int], None]) -> dict[str, Any] | None:
    for line in lines:
        value = json.loads(line)
        if isinstance(value, dict):
            return value
        done(value)
    return None


def tell(value: int | dict[str, Any]) -> None:
    """Say from within the process how much is done, or the answer.

    Past whoever stands in for standard output, as an app does while it runs.
    """
    print(json.dumps(value), file=sys.__stdout__, flush=True)
