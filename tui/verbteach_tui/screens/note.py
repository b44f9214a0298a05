"""Writing a note beside the robot's turn."""

from __future__ import annotations

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen
from textual.widgets import Input, Static

from verbteach_tui.widgets.foot import Foot


class NoteScreen(ModalScreen[str | None]):
    """One line of text, kept in the record; the robot does not hear it."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "dismiss", "No note")]

    def compose(self) -> ComposeResult:
        """A line and what happens to it."""
        with Vertical(classes="dialog") as dialog:
            dialog.border_title = "Note"
            yield Static("Kept in the record beside this turn. The robot does not hear it.")
            yield Input(placeholder="What you noticed", compact=True)
            yield Static("Enter keeps it, Escape does not.", classes="quiet")
        yield Foot()

    def on_input_submitted(self, message: Input.Submitted) -> None:
        """Keep it."""
        message.stop()
        self.dismiss(message.value)
