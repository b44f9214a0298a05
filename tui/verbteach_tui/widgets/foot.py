"""The bottom row: the keys of the moment that are no answers, each to press or to click."""

from __future__ import annotations

from typing import ClassVar

from textual.screen import Screen

from verbteach_tui.messages import TargetPicked
from verbteach_tui.views.rows import Row, Span, clipped, width_of
from verbteach_tui.widgets.rows_view import RowsView


class Foot(RowsView, can_focus=False):
    """One row made from the bindings that are shown, Help first; what does not fit is left out."""

    DEFAULT_CSS = """
    Foot {
        dock: bottom; height: 1; overflow-y: hidden; scrollbar-gutter: auto; background: $panel;
    }
    """
    FIRST: ClassVar[tuple[str, ...]] = ("f1", "ctrl+p")

    def on_mount(self) -> None:
        """Follow the bindings as the focus moves."""
        self.screen.bindings_updated_signal.subscribe(self, self._changed)
        self._changed(self.screen)

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a key presses it."""
        message.stop()
        self.app.simulate_key(message.target)

    def _changed(self, screen: Screen[object]) -> None:
        keys: dict[str, tuple[str, str]] = {}
        for active in screen.active_bindings.values():
            binding = active.binding
            if binding.show and active.enabled:
                name = self.app.get_key_display(binding)
                keys.setdefault(binding.action, (binding.key, f"{name} {binding.description}"))
        order = sorted(keys.values(), key=lambda key: _rank(key[0], self.FIRST))
        self.show_once(order, lambda width: [_row(order, width)])


def _rank(key: str, first: tuple[str, ...]) -> int:
    return first.index(key) if key in first else len(first)


def _row(keys: list[tuple[str, str]], width: int) -> Row:
    spans: list[Span] = []
    for key, text in keys:
        name, _, description = text.partition(" ")
        more = [Span(name, "robot", key), Span(f" {description}", "muted", key)]
        gap = [Span("  ")] if spans else []
        if width_of([*spans, *gap, *more]) > width:
            break
        spans += [*gap, *more]
    return clipped(spans, width)
