"""The plain mode: the same session as append-only lines, for screen readers, pipes and scripts."""

from __future__ import annotations

from typing import TYPE_CHECKING, TextIO

if TYPE_CHECKING:
    from verbteach_sessions.session import Session


def run_plain(session: Session, input: TextIO | None = None, output: TextIO | None = None) -> int:
    """Lead ``session`` through lines read from ``input`` until it ends or they do.

    Without ``input`` it reads the keyboard through prompt-toolkit where standard
    input is a terminal, and standard input line by line where it is not. Lines
    go to ``output`` (standard output). Answers 0, or 2 where a line from a file
    or pipe did not fit; at the keyboard such a line is explained and read again.
    The session is left open: the caller closes it and prints its summary.
    """
    raise NotImplementedError
