"""A scrolling panel of drawn rows, the base of every panel that shows plain values.

It knows how to show rows in the theme's colours, redraw them for its width, and
say which target was clicked. It must not know what the rows are about.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.geometry import Region, Size
from textual.scroll_view import ScrollView
from textual.strip import Strip

from verbteach_tui.messages import TargetPicked
from verbteach_tui.views.rows import Row
from verbteach_tui.widgets.palette import rows_style

Draw: TypeAlias = Callable[[int], Sequence[Row]]
"""Draws the rows for a width in cells."""

_TARGET = "target"


class RowsView(ScrollView, can_focus=True):
    """Shows what a draw function draws for its width; the ``heading`` first rows never scroll."""

    DEFAULT_CSS = """
    RowsView {
        overflow-x: hidden;
        overflow-y: auto;
        scrollbar-gutter: stable;
        scrollbar-size-vertical: 1;
        padding: 0 1;
    }
    """

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._draw: Draw = _nothing
        self._rows: Sequence[Row] = ()
        self._drawn_width = 0
        self._at_end = False
        self._variables: Mapping[str, str] = {}
        self._content: object = None
        self.heading = 0

    def show_once(self, content: object, draw: Draw) -> None:
        """Show what ``draw`` draws of ``content``, unless that is what is shown already."""
        if content != self._content:
            self._content = content
            self.show(draw)

    def show(self, draw: Draw, *, at_end: bool = False) -> None:
        """Show what ``draw`` draws; ``at_end`` keeps the last row in view."""
        self._draw, self._at_end, self._drawn_width = draw, at_end, 0
        self._redraw()

    @property
    def rows(self) -> Sequence[Row]:
        """The rows as drawn for the width it has."""
        return self._rows

    def reveal(self, first: int, last: int | None = None) -> None:
        """Scroll so that the rows from ``first`` to ``last`` are in view, below the heading."""
        top = max(first - self.heading, 0)
        height = (last if last is not None else first) - top + 1
        self.reveal_region(Region(0, top, 1, height))

    def reveal_region(self, region: Region) -> None:
        """Scroll so that ``region`` of the rows is in view, once the size is known."""
        self.call_after_refresh(self.scroll_to_region, region, animate=False)

    def _redraw(self) -> None:
        width = self.scrollable_content_region.width
        if width <= 0:
            return
        if width != self._drawn_width:
            self._rows = self._draw(width)
            self._drawn_width = width
            self.redrawn()
        self.virtual_size = Size(self.widest(width), len(self._rows))
        if self._at_end:
            # What has just come into view has no scroll range yet.
            self.call_after_refresh(self.scroll_end, animate=False, x_axis=False)
        self.refresh()

    def widest(self, width: int) -> int:
        """How wide the rows are; more than ``width`` only where a subclass scrolls sideways."""
        return width

    def redrawn(self) -> None:
        """Called after the rows were drawn, before they show; for subclasses."""

    def on_resize(self, event: events.Resize) -> None:
        """Draw anew for the new width."""
        self._redraw()

    def notify_style_update(self) -> None:
        """Another theme, perhaps: look its colours up anew."""
        super().notify_style_update()
        self._variables = {}
        self.refresh()

    def render_line(self, y: int) -> Strip:
        """The strip at row ``y`` of what is in view."""
        width, base = self.scrollable_content_region.width, self.rich_style
        self._variables = self._variables or self.app.theme_variables
        index = y if y < self.heading else self.scroll_offset.y + y
        if index >= len(self._rows):
            return Strip.blank(width, base)
        segments = [
            Segment(text, self._style_of(style, target))
            for text, style, target in self._rows[index]
        ]
        left = self.scroll_offset.x
        return Strip(segments).crop_extend(left, left + width, base).apply_style(base)

    def _style_of(self, style: str, target: str) -> Style:
        made = rows_style(style, self._variables)
        return made + Style(meta={_TARGET: target}) if target else made

    def on_click(self, event: events.Click) -> None:
        """Say what was clicked, if anything there can be picked."""
        target = self.target_at(event)
        if target:
            event.stop()
            self.post_message(TargetPicked(self, target))

    def target_at(self, event: events.MouseEvent) -> str:
        """The target under the mouse, "" where there is none."""
        return str(event.style.meta.get(_TARGET, ""))


def _nothing(width: int) -> Sequence[Row]:
    return ()
