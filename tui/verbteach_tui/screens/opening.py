"""What is shown for the moment that a session takes to open."""

from __future__ import annotations

from textual.app import ComposeResult
from textual.screen import Screen
from textual.widgets import Static

from verbteach_tui.views.visible import visible


class OpeningScreen(Screen[None]):
    """One line in the middle of the screen."""

    def __init__(self, what: str) -> None:
        super().__init__()
        self._what = what

    def compose(self) -> ComposeResult:
        """The line."""
        yield Static(f"Opening {visible(self._what)} …", markup=False, id="opening")
