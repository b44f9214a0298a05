"""Whoever wants to leave says how: for now, or for good."""

from __future__ import annotations

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.screen import ModalScreen
from textual.widgets import Button, Static

from verbteach_tui.study import words
from verbteach_tui.widgets.foot import Foot

PAUSE, STOP = "pause", "stop"


class LeavingScreen(ModalScreen[str]):
    """Pause, stop taking part, or stay; answers with ``PAUSE``, ``STOP`` or nothing."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("p", "answer('pause')", "Pause"),
        Binding("e", "answer('stop')", "Stop taking part"),
        Binding("escape", "answer('')", "Stay"),
        Binding("left,up", "app.focus_previous", show=False),
        Binding("right,down", "app.focus_next", show=False),
    ]

    def __init__(self, code: str) -> None:
        super().__init__()
        self._code = code

    def compose(self) -> ComposeResult:
        """What each choice means, and the code that leads back."""
        with Vertical(classes="dialog") as dialog:
            dialog.border_title = "Leave?"
            yield Static("Pause: everything is kept, and you go on where you are now.")
            yield Static(
                "Stop taking part: a few last questions, then you are done. What you did stays, "
                "unless you have it deleted."
            )
            yield Static(words.CODE.format(code=self._code), classes="quiet", markup=False)
            with Horizontal(classes="choices"):
                yield Button("[u]P[/u]ause", id=PAUSE, compact=True, variant="primary")
                yield Button("[u]E[/u]nd it", id=STOP, compact=True)
                yield Button("Stay", id="stay", compact=True)
        yield Foot()

    def on_button_pressed(self, event: Button.Pressed) -> None:
        """A button."""
        self.action_answer(event.button.id if event.button.id in (PAUSE, STOP) else "")

    def action_answer(self, word: str | None) -> None:
        """Back, with what was chosen."""
        self.dismiss(word or "")
