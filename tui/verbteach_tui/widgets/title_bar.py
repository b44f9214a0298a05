"""The top row: where the person is, and what the session has come to."""

from __future__ import annotations

from collections.abc import Sequence

from verbteach_tui.views.rows import Row, Span, clipped, width_of
from verbteach_tui.widgets.rows_view import RowsView


class TitleBar(RowsView, can_focus=False):
    """One row: a title at the left, figures at the right, the less important given up first."""

    DEFAULT_CSS = """
    TitleBar {
        dock: top; height: 1; overflow-y: hidden; scrollbar-gutter: auto; background: $panel;
    }
    """

    def show_title(self, title: str, figures: Sequence[str] = ()) -> None:
        """Show ``title``, and as many of ``figures`` as there is room for."""
        self.show_once((title, tuple(figures)), lambda width: [_row(title, figures, width)])


def _row(title: str, figures: Sequence[str], width: int) -> Row:
    left = [Span("verbteach", "robot"), Span(f"  {title}")]
    kept = list(figures)
    while kept and width_of(left) + len("  ·  ".join(kept)) + 2 > width:
        kept.pop()
    right = Span("  ·  ".join(kept), "muted")
    room = width - width_of(left) - width_of([right])
    return clipped([*left, Span(" " * max(room, 0)), right], width)
