"""What the terminal in front of the person can show, read from its environment."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Mapping
from dataclasses import dataclass

SMALLEST = (60, 20)  # columns and lines of the smallest layout


def has_terminal() -> bool:
    """Whether a full screen can be shown and keys can be read; not where TERM names no kind."""
    told = os.environ.get("TERM", "") not in {"", "dumb"}
    return told and sys.stdin.isatty() and sys.stdout.isatty()


def in_browser() -> bool:
    """Whether the screen is a page in somebody's browser, as ``verbteach serve`` makes it."""
    return os.environ.get("TEXTUAL_DRIVER", "").endswith(":WebDriver")


def size_in_browser() -> tuple[int, int] | None:
    """The columns and rows that the page began with; ``None`` where there is no page."""
    columns, rows = os.environ.get("COLUMNS", ""), os.environ.get("ROWS", "")
    if not (in_browser() and columns.isdigit() and rows.isdigit()):
        return None
    return int(columns), int(rows)


@dataclass(frozen=True)
class Terminal:
    """What is known of the terminal; ``columns`` and ``lines`` are 0 where there is none."""

    interactive: bool
    kind: str
    columns: int
    lines: int
    colours: str
    encoding: str
    multiplexer: str
    remote: bool

    @classmethod
    def here(cls) -> Terminal:
        """The terminal of this process."""
        interactive = has_terminal()
        size = shutil.get_terminal_size((0, 0)) if interactive else os.terminal_size((0, 0))
        return cls(
            interactive=interactive,
            kind=os.environ.get("TERM", ""),
            columns=size.columns,
            lines=size.lines,
            colours=colours(os.environ),
            encoding=sys.stdout.encoding or "",
            multiplexer=multiplexer(os.environ),
            remote="SSH_CONNECTION" in os.environ,
        )

    def advice(self) -> tuple[str, ...]:
        """What a person should know before starting here, one sentence each."""
        notes = []
        if not self.interactive:
            notes.append("no terminal here: teach in plain mode ('verbteach teach --plain')")
        elif self.columns < SMALLEST[0] or self.lines < SMALLEST[1]:
            smallest = f"{SMALLEST[0]}x{SMALLEST[1]}"
            notes.append(f"the window is small: {self.columns}x{self.lines}, needs {smallest}")
        if self.encoding.lower().replace("-", "") != "utf8":
            notes.append(f"the encoding is {self.encoding or 'unknown'}: set a UTF-8 locale")
        if self.multiplexer:
            notes.append(f"inside {self.multiplexer}: letters, digits and F-keys all arrive")
        return tuple(notes)


def colours(environment: Mapping[str, str]) -> str:
    """How many colours to expect: ``none``, ``16``, ``256`` or ``truecolor``."""
    if environment.get("NO_COLOR") or environment.get("TERM", "dumb") == "dumb":
        return "none"
    if environment.get("COLORTERM", "").lower() in ("truecolor", "24bit"):
        return "truecolor"
    return "256" if "256" in environment["TERM"] else "16"


def multiplexer(environment: Mapping[str, str]) -> str:
    """The terminal multiplexer around this process, or nothing."""
    if environment.get("TMUX"):
        return "tmux"
    return "screen" if environment.get("STY") else ""
