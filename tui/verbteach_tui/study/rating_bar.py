"""One scale of a questionnaire: a question, and a bar of twenty-one places to mark one of."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from rich.cells import cell_len
from textual import events
from textual.binding import Binding, BindingType

from verbteach_sessions.study.questionnaire import MOST, STEP, Scale
from verbteach_tui.messages import TargetPicked
from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.widgets.rows_view import RowsView

_UNMARKED = "not answered"


class RatingBar(RowsView):
    """Left and Right mark a place, digits a tenth of it, Backspace none. ``value`` is 0 to 100."""

    HELP = (
        "A scale. Left and Right move the mark, Home and End go to its ends, a digit goes to "
        "that tenth, Backspace takes the mark away: then the question counts as not answered. "
        "A click marks a place. Tab goes on to the next question."
    )
    DEFAULT_CSS = """
    RatingBar { height: auto; overflow-y: hidden; scrollbar-gutter: auto; }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left", "move(-1)", "Less", show=False),
        Binding("right", "move(1)", "More", show=False),
        Binding("home", "mark(0)", "Lowest", show=False),
        Binding("end", f"mark({MOST})", "Highest", show=False),
        Binding("backspace,delete", "unmark", "No answer", show=False),
        Binding("down,enter", "app.focus_next", "Next question", show=False),
        Binding("up", "app.focus_previous", "Question before", show=False),
    ]

    def __init__(self, scale: Scale) -> None:
        super().__init__(id=scale.id)
        self.scale = scale
        self.value: int | None = None
        self.border_title = scale.title

    def on_mount(self) -> None:
        """Draw it."""
        self.show(self._drawn)

    def on_focus(self) -> None:
        """Say what the keys do where they are."""
        self.border_subtitle = "← → mark, Tab goes on"

    def on_blur(self) -> None:
        """The keys are elsewhere."""
        self.border_subtitle = ""

    def redrawn(self) -> None:
        """Take as many rows as the question needs at this width, and two for the frame."""
        self.styles.height = len(self.rows) + 2

    def action_move(self, steps: int) -> None:
        """Move the mark; where there is none yet, put it in the middle."""
        start = MOST // 2 - STEP * steps if self.value is None else self.value
        self.action_mark(min(max(start + STEP * steps, 0), MOST))

    def action_mark(self, value: int | None) -> None:
        """Mark a place."""
        self.value = value
        self.show(self._drawn)

    def action_unmark(self) -> None:
        """Leave the question out."""
        self.action_mark(None)

    def on_key(self, event: events.Key) -> None:
        """A digit marks that tenth."""
        if event.character is not None and event.character in "0123456789":
            event.stop()
            self.action_mark(int(event.character) * 10)

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click marks a place."""
        message.stop()
        self.focus()
        self.action_mark(int(message.target))

    def _drawn(self, width: int) -> Sequence[Row]:
        return [*wrapped([Span(self.scale.text)], width), self._bar(width)]

    def _bar(self, width: int) -> Row:
        """As in: low ──┼──┼──●──┼── high   35."""
        low, high = f"{self.scale.low} ", f" {self.scale.high} "
        said = _UNMARKED if self.value is None else str(self.value)
        room = width - cell_len(low) - cell_len(high) - len(_UNMARKED) - 1
        places = MOST // STEP
        gap = "─" * max((room - places - 1) // places, 0)
        spans = [Span(low, "muted")]
        for place in range(places + 1):
            value = place * STEP
            tick = "┼" if value % 25 == 0 else "┬" if gap else "─"
            mark = Span("●", "accent") if value == self.value else Span(tick, "border")
            spans.append(mark._replace(target=str(value)))
            if place < places:
                spans.append(Span(gap, "border", str(value)))
        style = "muted" if self.value is None else "strong"
        return (*spans, Span(high, "muted"), Span(f" {said}", style))
