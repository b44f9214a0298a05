"""A dialog for what went wrong: the session goes on behind it."""

from __future__ import annotations

import traceback
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.screen import ModalScreen
from textual.widgets import Button, Static

from verbteach_sessions.errors import SessionError
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.foot import Foot

KEPT = (
    "What you said last has not counted; everything before it is kept. "
    "You can go on, or undo and try something else."
)
NOT_OPENED = "No session was opened, and nothing was changed."


class FailureScreen(ModalScreen[None]):
    """Says what failed while doing what, and lets the person go on."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,enter", "dismiss", "Go on")]

    def __init__(self, doing: str, error: Exception, advice: str = KEPT) -> None:
        super().__init__()
        self._doing, self._error, self._advice = doing, error, advice

    def compose(self) -> ComposeResult:
        """One sentence, the details of what nobody foresaw, a button."""
        said = visible(str(self._error)) or type(self._error).__name__
        with Vertical(classes="dialog -bad") as dialog:
            dialog.border_title = "✗ That went wrong"
            yield Static(f"While {self._doing}: {said}", markup=False, classes="lead")
            yield Static(self._advice, markup=False)
            if not isinstance(self._error, SessionError):  # which says itself what is the matter
                with VerticalScroll(classes="details"):
                    yield Static(visible_lines(self._error), markup=False)
            yield Button("Go on", id="go-on", variant="primary", compact=True)
        yield Foot()

    def on_button_pressed(self) -> None:
        """Back to the session."""
        self.dismiss()


def visible_lines(error: Exception) -> str:
    """The traceback, safe to show."""
    lines = "".join(traceback.format_exception(error)).splitlines()
    return "\n".join(visible(line) for line in lines)
