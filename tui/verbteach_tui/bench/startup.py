"""How long the command takes to start: to print its version, and to paint the home screen."""

from __future__ import annotations

import fcntl
import os
import pty
import select
import signal
import struct
import subprocess
import sys
import termios
import time
from pathlib import Path
from statistics import median

COLUMNS, LINES = 120, 40
PAINTED = b"verbteach"
LONGEST = 30.0  # seconds to wait for the first paint


def command() -> list[str]:
    """The installed `verbteach`, else the module that it runs."""
    script = Path(sys.executable).with_name("verbteach")
    return [str(script)] if script.is_file() else [sys.executable, "-m", "verbteach_tui"]


def version_ms(runs: int = 5) -> float:
    """The median time of `verbteach --version`, in milliseconds, after one run not counted."""
    return median([_version_once() for _ in range(runs + 1)][1:])


def _version_once() -> float:
    start = time.perf_counter()
    subprocess.run([*command(), "--version"], check=True, stdout=subprocess.DEVNULL)
    return (time.perf_counter() - start) * 1000


def first_paint_ms(runs: int = 3) -> float | None:
    """The median time until the home screen is painted in a terminal of 120 x 40.

    ``None`` where it never is. One run is not counted.
    """
    times = [_paint_once() for _ in range(runs + 1)][1:]
    painted = [found for found in times if found is not None]
    return median(painted) if len(painted) == runs else None


def _paint_once() -> float | None:
    start = time.perf_counter()
    pid, terminal = pty.fork()
    if pid == 0:
        os.environ["TERM"] = "xterm-256color"
        os.execv(command()[0], command())
    try:
        fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", LINES, COLUMNS, 0, 0))
        return _painted(terminal, start)
    finally:
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
        os.close(terminal)


def _painted(terminal: int, start: float) -> float | None:
    """Milliseconds from ``start`` until the screen's own name stands on it."""
    seen = b""
    while time.perf_counter() - start < LONGEST:
        if not select.select([terminal], [], [], 0.1)[0]:
            continue
        try:
            seen += os.read(terminal, 65536)
        except OSError:  # it has ended
            return None
        if PAINTED in seen:
            return (time.perf_counter() - start) * 1000
    return None
