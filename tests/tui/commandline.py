"""Running the command line in tests: in this process, or in one of its own."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

from verbteach_tui.cli import main

LONGEST = 120  # seconds that any command in these tests may take


@dataclass(frozen=True)
class Ran:
    """What a command left behind."""

    status: int
    out: str
    err: str

    @property
    def document(self) -> Any:
        """Standard output as exactly one JSON document."""
        return json.loads(self.out)


def here(*words: object, typed: str = "", sessions: Path | None = None) -> Ran:
    """Run the command in this process, without a terminal; ``typed`` is its standard input."""
    out, err = io.StringIO(), io.StringIO()
    folder = {"VERBTEACH_SESSIONS": str(sessions)} if sessions else {}
    with (
        patch.dict(os.environ, folder),
        patch.object(sys, "stdin", io.StringIO(typed)),
        redirect_stdout(out),
        redirect_stderr(err),
    ):
        status = main([str(word) for word in words])
    return Ran(status, out.getvalue(), err.getvalue())


def process(*words: object, typed: str = "", sessions: Path | None = None) -> Ran:
    """Run the command in a process of its own, as a shell would."""
    folder = {"VERBTEACH_SESSIONS": str(sessions)} if sessions else {}
    done = subprocess.run(
        [sys.executable, "-m", "verbteach_tui", *map(str, words)],
        input=typed,
        capture_output=True,
        text=True,
        timeout=LONGEST,
        check=False,
        env={**os.environ, **folder},
    )
    return Ran(done.returncode, done.stdout, done.stderr)


def assert_refused(ran: Ran, *words: str) -> None:
    """The command was used wrongly: status 2, nothing out, one line that says each of ``words``."""
    assert ran.status == 2, ran
    assert ran.out == ""
    assert ran.err.count("\n") == 1, ran.err
    assert "Traceback" not in ran.err
    for word in words:
        assert word in ran.err, ran.err
