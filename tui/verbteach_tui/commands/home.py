"""`verbteach` alone: the home screen."""

from __future__ import annotations

from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.terminal import has_terminal


def home() -> int:
    """Open the home screen; without a terminal say how to go on."""
    if not has_terminal():
        raise WrongUseError(
            "the home screen needs a terminal; "
            "'verbteach teach --plain' goes on without one, 'verbteach --help' lists the commands"
        )
    from verbteach_sessions.catalogue import default_folder
    from verbteach_tui.beginning import Beginning
    from verbteach_tui.room import full_screen

    return full_screen(Beginning(default_folder(), "app"))
