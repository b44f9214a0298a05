"""Help about the widget that has the focus, and the keys that work there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen

from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.rows_view import RowsView


class HelpScreen(ModalScreen[None]):
    """What this is, and what can be done here."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,f1,enter", "dismiss", "Back")]

    def __init__(self, about: str, keys: Sequence[tuple[str, str]]) -> None:
        super().__init__()
        self._about, self._keys = about, keys

    def compose(self) -> ComposeResult:
        """A paragraph and a table of keys."""
        with Vertical(classes="dialog -large") as dialog:
            dialog.border_title = "Help"
            yield RowsView(id="help")
        yield Foot()

    def on_mount(self) -> None:
        """Show it."""
        view = self.query_one("#help", RowsView)
        view.show(self._drawn)
        view.focus()

    def _drawn(self, width: int) -> list[Row]:
        rows = wrapped([Span(self._about)], width)
        rows.append(())
        room = max([len(key) for key, _ in self._keys], default=0) + 2
        for key, description in self._keys:
            lead = [Span(key.ljust(room), "accent")]
            rows += wrapped([Span(description)], width, room, lead)
        return rows
