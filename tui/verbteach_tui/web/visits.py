"""What a visitor gets: a process of their own, in a folder of their own."""

from __future__ import annotations

import os
import shlex
import sys
from dataclasses import dataclass
from pathlib import Path

from verbteach_sessions.catalogue import list_sessions
from verbteach_sessions.files import FOLDER_MODE
from verbteach_tui.web.tokens import Ticket, Visitor

TICKET_VARIABLE = "VERBTEACH_TICKET"


@dataclass(frozen=True)
class Visits:
    """How visitors' processes are started. ``study`` leads them through a study.

    In a study nothing of a visitor is on the disk before they consent; without
    one they get their folder at once.
    """

    folder: Path
    study: Path | None = None
    scenes: Path | None = None
    theme: str | None = None

    def command(self, visitor: Visitor) -> str:
        """The shell's command for a visitor who comes, or comes back."""
        words = [sys.executable, "-m", "verbteach_tui", "teach", *self._where(visitor)]
        if self.scenes is not None:
            words += ["--scenes", str(self.scenes)]
        if self.theme is not None:
            words += ["--theme", self.theme]
        ticket = f"{visitor.ticket.token}:{visitor.ticket.browser}"
        return f"{TICKET_VARIABLE}={shlex.quote(ticket)} exec {shlex.join(words)}"

    def _where(self, visitor: Visitor) -> list[str]:
        if self.study is not None:
            folder = ["--sessions", str(self.folder)]
            return ["--study", str(self.study), "--participant", visitor.code, *folder]
        home = self._home(visitor)
        words = ["--sessions", str(home)]
        left = self._left(home)
        return [*words, "--resume", str(left)] if left else [*words, "--participant", visitor.code]

    def _home(self, visitor: Visitor) -> Path:
        home = self.folder / visitor.code
        if not home.is_dir():
            home.mkdir(mode=FOLDER_MODE, parents=True)
            visitor.ticket.write(home)
        return home

    def _left(self, home: Path) -> Path | None:
        """The session that the connection was lost in, if it was in one."""
        newest = next(iter(list_sessions(home)), None)
        if newest is None or newest.ended or not newest.resumable:
            return None
        return newest.path


def ticket_here() -> Ticket | None:
    """The ticket that the server gave this process, if one did."""
    token, _, browser = os.environ.get(TICKET_VARIABLE, "").partition(":")
    return Ticket(token, browser) if browser else None
