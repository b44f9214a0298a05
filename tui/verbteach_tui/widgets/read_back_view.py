"""The goal that the robot reads back: strike a part or keep it after all, by key or mouse."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.binding import Binding, BindingType

from verbteach_tui.messages import PartToggled, TargetPicked
from verbteach_tui.views.read_back import GoalPart, read_back_rows
from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.widgets.rows_view import RowsView

_INTRODUCTION = "Space strikes a part out, or keeps it after all. Then say whether it is right."


class ReadBackView(RowsView):
    """What must hold afterwards, one part to a row, each kept or struck."""

    HELP = (
        "What the robot is about to keep as the verb's meaning. Up and Down choose a part, Space "
        "or a click strikes it out (it need not hold) or keeps it after all. y keeps the goal, n "
        "says that it is wrong, t lets you show it again."
    )
    BORDER_TITLE = "What must hold afterwards"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "move(-1)", "Up", show=False),
        Binding("down", "move(1)", "Down", show=False),
        Binding("space,enter,x", "strike", "Strike or keep"),
    ]

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._parts: tuple[GoalPart, ...] = ()
        self._cursor = 0
        self._starts: list[int] = []

    def show_parts(self, parts: Sequence[GoalPart]) -> None:
        """Show the goal's parts; the cursor stays, or starts at the first that is kept."""
        if [part.literal for part in parts] != [part.literal for part in self._parts]:
            kept = (index for index, part in enumerate(parts) if part.kept)
            self._cursor = next(kept, 0)
        self._parts = tuple(parts)
        self.show(self._drawn)

    def action_move(self, by: int) -> None:
        """Another part."""
        self._cursor = min(max(self._cursor + by, 0), max(len(self._parts) - 1, 0))
        self.show(self._drawn)
        if self._starts:
            self.reveal(self._starts[self._cursor])

    def action_strike(self) -> None:
        """Strike the part under the cursor, or keep it after all."""
        if self._parts:
            part = self._parts[self._cursor]
            self.post_message(PartToggled(part.literal, keep=not part.kept))

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a part toggles it."""
        message.stop()
        self._cursor = int(message.target)
        self.action_strike()

    def _drawn(self, width: int) -> Sequence[Row]:
        rows = wrapped([Span(_INTRODUCTION, "muted")], width)
        self._starts = []
        for part in read_back_rows(self._parts, self._cursor, width):
            self._starts.append(len(rows))
            rows += part
        return rows
