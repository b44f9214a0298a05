"""What the robot said last, below the panels, where the dialogue itself is not in view."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from verbteach_tui.views.dialogue import SPEAKERS, DialogueLine
from verbteach_tui.views.rows import Row, Span, clipped, wrapped
from verbteach_tui.views.visible import shortened
from verbteach_tui.widgets.rows_view import RowsView


class LatestWords(RowsView, can_focus=False):
    """A row or two."""

    DEFAULT_CSS = """
    LatestWords { height: 1; overflow-y: hidden; scrollbar-gutter: auto; }
    """

    def show_lines(self, lines: Sequence[DialogueLine], most: int = 2) -> None:
        """Show what the robot said since somebody else spoke, at the end of ``lines``.

        It takes at most so many rows, and where that is one, of several things said the last;
        the dialogue has all of it.
        """
        latest = list(takewhile(lambda line: line.speaker == "robot", reversed(lines)))
        said = " ".join(line.text for line in reversed(latest[:1] if most == 1 else latest))
        self.show_once((said, most), lambda width: _rows(said, width, most))

    def redrawn(self) -> None:
        """Take as many rows as the words need at this width."""
        self.styles.height = max(len(self.rows), 1)


def _rows(said: str, width: int, most: int) -> list[Row]:
    speaker = f"{SPEAKERS['robot']}  "
    rows = wrapped([Span(shortened(said))], width, len(speaker), [Span(speaker, "robot")])
    if len(rows) <= most:
        return rows
    return [*rows[: most - 1], clipped([*rows[most - 1], Span(" …", "muted")], width)]
