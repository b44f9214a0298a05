"""What is shown for the moment that a session takes to open, and what is typed in it."""

from __future__ import annotations

from textual import events
from textual.app import ComposeResult
from textual.screen import Screen
from textual.widgets import Static

from verbteach_tui.views.visible import visible


class OpeningScreen(Screen[None]):
    """One line in the middle of the screen. ``typed`` is for the line of the room to come.

    ``command`` was said before, and is the first thing that the robot is told there.
    """

    def __init__(self, what: str, command: str = "") -> None:
        super().__init__()
        self._what, self.command = what, command
        self.typed = ""

    def compose(self) -> ComposeResult:
        """The line."""
        yield Static(self._said, markup=False, id="opening")

    @property
    def _said(self) -> str:
        below = "".join(f"\n{visible(text)}" for text in (self.command, self.typed) if text)
        return f"Opening {visible(self._what)} …{below}"

    def on_key(self, event: events.Key) -> None:
        """Who types at once loses nothing by it."""
        if event.is_printable and event.character is not None:
            self.typed += event.character
        elif event.key == "backspace":
            self.typed = self.typed[:-1]
        self.query_one("#opening", Static).update(self._said)
