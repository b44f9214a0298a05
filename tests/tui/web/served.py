"""A server in a process of its own, as a person starts it."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def served(records: Path, *words: object, killed: bool = False) -> Iterator[str]:
    """The address it serves on. In the end it is asked to stop, or ``killed``."""
    command = [sys.executable, "-m", "verbteach_tui", "serve", "--port", "0"]
    command += ["--sessions", str(records), *map(str, words)]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        first = process.stderr.readline()
        found = re.search(r"http://[^/]+/", first)
        assert found, first
        process.stderr.readline()
        try:
            yield found[0]
        finally:
            process.kill() if killed else process.terminate()
            process.wait(30)
