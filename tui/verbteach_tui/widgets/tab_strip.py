"""Which panel is in view where there is room for one only; each names its key."""

from __future__ import annotations

from collections.abc import Sequence

from verbteach_tui.messages import TargetPicked, WordSaid
from verbteach_tui.views.rows import Row, Span, clipped
from verbteach_tui.widgets.rows_view import RowsView


class TabStrip(RowsView, can_focus=False):
    """One row of tabs; a click says the tab's word."""

    DEFAULT_CSS = """
    TabStrip { height: 1; overflow-y: hidden; scrollbar-gutter: auto; background: $surface; }
    """

    def show_tabs(self, tabs: Sequence[tuple[str, str, str]], current: str) -> None:
        """Show ``tabs`` as (word, key, title); ``current`` is the word of the one in view."""
        self.show_once((tabs, current), lambda width: [_row(tabs, current, width)])

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a tab chooses it."""
        message.stop()
        self.post_message(WordSaid(message.target, "tab"))


def _row(tabs: Sequence[tuple[str, str, str]], current: str, width: int) -> Row:
    spans: list[Span] = []
    for word, key, title in tabs:
        mark = "▸" if word == current else " "
        style = "cursor" if word == current else "text"
        spans += [Span(f"{mark}{title} ", style, word), Span(f"{key}  ", "muted", word)]
    return clipped(spans, width)
