"""The dialogue: grows at its end, and only new lines are drawn when it does."""

from __future__ import annotations

from collections.abc import Sequence

from verbteach_tui.views.dialogue import DialogueLine, common, line_rows
from verbteach_tui.views.rows import Row
from verbteach_tui.widgets.rows_view import RowsView


class DialogueView(RowsView):
    """Who said what, the newest line in view."""

    HELP = (
        "The dialogue. What you said and what the robot said, with the kind of question and its "
        "price at the right. Scroll with the arrow keys, Page Up, Page Down or the wheel."
    )
    BORDER_TITLE = "Dialogue"

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._lines: tuple[DialogueLine, ...] = ()
        self._cache: list[Row] = []
        self._ends: list[int] = []
        self._width = 0

    @property
    def lines(self) -> tuple[DialogueLine, ...]:
        """What is shown."""
        return self._lines

    def show_lines(self, lines: Sequence[DialogueLine]) -> None:
        """Show ``lines``; those at the beginning that were shown before are not drawn again."""
        self._keep(common(self._lines, lines))
        self._lines = tuple(lines)
        self.show(self._drawn, at_end=True)

    def _keep(self, count: int) -> None:
        """Forget the rows of all but the first ``count`` lines."""
        del self._ends[count:]
        del self._cache[self._ends[-1] if self._ends else 0 :]

    def _drawn(self, width: int) -> Sequence[Row]:
        if width != self._width:
            self._keep(0)
            self._width = width
        for index in range(len(self._ends), len(self._lines)):
            before = self._lines[index - 1].speaker if index else ""
            self._cache += line_rows(self._lines[index], before, width)
            self._ends.append(len(self._cache))
        return self._cache
