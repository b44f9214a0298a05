"""Whether a screen fits: nothing over an edge, no text cut off, no panel empty, the focus seen."""

from __future__ import annotations

from collections.abc import Iterator

from textual.app import App
from textual.containers import ScrollableContainer
from textual.geometry import Region
from textual.pilot import Pilot
from textual.widget import Widget
from textual.widgets import Button, OptionList, Static

from tests.tui.frames import unpainted
from verbteach_tui.views.rows import plain, width_of
from verbteach_tui.widgets.hypothesis_view import HypothesisView
from verbteach_tui.widgets.rows_view import RowsView

SIZES = ((60, 20), (80, 24), (120, 40), (200, 50))
"""The sizes that the app is laid out for."""


def misfits(app: App[None]) -> list[str]:
    """What is wrong with the screen in front, a line each; nothing where all is well."""
    widgets = [w for w in app.screen.walk_children(Widget) if _is_shown(w)]
    found = [f"{problem}: {widget!r}" for widget in widgets for problem in _problems(widget, app)]
    panels = [w for w in app.screen.query("#panels > *") if _is_shown(w)]
    for index, one in enumerate(panels):
        over = [other for other in panels[index + 1 :] if one.region.overlaps(other.region)]
        found += [f"lies over {other!r}: {one!r}" for other in over]
    focused = app.focused
    if focused is not None and not app.screen.find_widget(focused).visible_region.area:
        found.append(f"has the keys out of sight: {focused!r}")
    return found


def check_fits(app: App[None]) -> None:
    """Fail with all that does not fit."""
    assert not misfits(app), "\n".join([str(app.size), *misfits(app)])


async def check_fits_everywhere(pilot: Pilot[None]) -> None:
    """The same at each of ``SIZES``; at the end the size is what it was, and painted."""
    before = pilot.app.size
    with unpainted():
        for size in sorted(SIZES, key=lambda size: size == before):
            await pilot.resize_terminal(*size)
            await _laid_out(pilot)
            check_fits(pilot.app)
    if pilot.app.size != before:
        await pilot.resize_terminal(*before)
    pilot.app.screen.refresh()
    await pilot.pause()


async def _laid_out(pilot: Pilot[None]) -> None:
    """Wait until a resized screen fits, for as long as a busy machine may take to lay it out."""
    for _ in range(40):
        await pilot.pause()
        if not misfits(pilot.app):
            return
        await pilot.pause(0.05)


def _is_shown(widget: Widget) -> bool:
    return bool(widget.display and widget.region.area and widget.is_on_screen)


def _problems(widget: Widget, app: App[None]) -> Iterator[str]:
    whole = Region(0, 0, *app.size)
    if not _is_scrolled(widget) and not whole.contains_region(widget.region):
        yield f"runs over the edge with {widget.region}"
    if isinstance(widget, RowsView):
        yield from _misdrawn(widget)
    elif isinstance(widget, Button):
        if len(str(widget.label)) > widget.content_region.width:
            yield "has a label that is cut off"
    elif isinstance(widget, OptionList):
        if not widget.option_count:
            yield "offers nothing"
    elif isinstance(widget, Static) and not _is_scrolled(widget):
        region = widget.content_region
        if widget.get_content_height(app.size, app.size, region.width) > region.height:
            yield "has text that is cut off"


def _misdrawn(view: RowsView) -> Iterator[str]:
    room = view.scrollable_content_region
    if not any(plain(row).strip() for row in view.rows):
        yield "is empty"
    if not isinstance(view, HypothesisView) and any(width_of(r) > room.width for r in view.rows):
        yield "has rows that are too wide"
    if view.styles.overflow_y == "hidden" and len(view.rows) > room.height:
        yield "has rows that are cut off"


def _is_scrolled(widget: Widget) -> bool:
    return any(isinstance(around, ScrollableContainer) for around in widget.ancestors)
