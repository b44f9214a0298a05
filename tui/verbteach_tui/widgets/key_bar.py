"""What can be said now, as keys to press or click; each names the key and what it says."""

from __future__ import annotations

from collections.abc import Sequence

from verbteach_tui.keys import Key
from verbteach_tui.messages import TargetPicked, WordSaid
from verbteach_tui.views.rows import GLUE, Row, Span, wrapped
from verbteach_tui.widgets.rows_view import RowsView


class KeyBar(RowsView, can_focus=False):
    """One or two rows of keys."""

    DEFAULT_CSS = """
    KeyBar { height: auto; max-height: 5; overflow-y: hidden; scrollbar-gutter: auto; }
    """

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._lead = ""
        self._keys: tuple[Key, ...] = ()
        self._extra: tuple[Key, ...] = ()

    def show_keys(self, lead: str, keys: Sequence[Key], extra: Sequence[Key] = ()) -> None:
        """Show what is wanted (``lead``), the keys that answer it, and as many more as fit."""
        self._lead, self._keys, self._extra = lead, tuple(keys), tuple(extra)
        self.show_once((lead, self._keys, self._extra), self._drawn)

    def _drawn(self, width: int) -> Sequence[Row]:
        rows = _rows(self._lead, self._keys, width)
        for count in range(len(self._extra), 0, -1):
            more = _rows(self._lead, (*self._keys, *self._extra[:count]), width)
            if len(more) == len(rows):
                return more
        return rows

    def redrawn(self) -> None:
        """Take as many rows as the keys need at this width."""
        self.styles.height = max(len(self.rows), 1)

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a key says its word."""
        message.stop()
        self.post_message(WordSaid(message.target, "mouse"))


def _rows(lead: str, keys: Sequence[Key], width: int) -> list[Row]:
    spans = [Span(lead, "accent")]
    for key in keys:
        label = key.label.replace(" ", GLUE)
        spans += [
            Span("  "),
            Span(f"{GLUE}{key.key}{GLUE}", "cursor", key.word),
            Span(f"{GLUE}{label}", "text", key.word),
        ]
    return wrapped(spans, width)
