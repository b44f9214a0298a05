"""The bottom row: the keys of the moment that are no answers, each to press or to click."""

from __future__ import annotations

from typing import ClassVar

from textual.screen import Screen

from verbteach_tui.messages import TargetPicked
from verbteach_tui.views.rows import Row, Span, clipped, width_of
from verbteach_tui.widgets.rows_view import RowsView


class Foot(RowsView, can_focus=False):
    """One row made from the bindings that are shown, Help first; what does not fit is left out.

    A screen may name in ``idle_actions`` what would do nothing at the moment.
    """

    DEFAULT_CSS = """
    Foot {
        dock: bottom; height: 1; overflow-y: hidden; scrollbar-gutter: auto; background: $panel;
    }
    """
    FIRST: ClassVar[tuple[str, ...]] = ("help", "command_palette")
    WAYS_OUT: ClassVar[frozenset[str]] = frozenset(
        {"leave", "dismiss", "stay", "cancel", "app.quit"}
    )

    ROOMS: ClassVar[frozenset[str]] = frozenset({"scenes"})

    def on_mount(self) -> None:
        """Follow the bindings as the focus moves."""
        self.screen.bindings_updated_signal.subscribe(self, self._changed)
        self._changed(self.screen)

    async def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a key does at once what the key does."""
        message.stop()
        active = self.screen.active_bindings.get(message.target)
        if active is not None and active.enabled:
            await self.app.run_action(active.binding.action, active.node)

    def _changed(self, screen: Screen[object]) -> None:
        keys: dict[str, tuple[str, str]] = {}
        idle: frozenset[str] = getattr(screen, "idle_actions", frozenset())
        for active in screen.active_bindings.values():
            binding = active.binding
            if binding.show and active.enabled and binding.action not in idle:
                name = self.app.get_key_display(binding)
                keys.setdefault(binding.action, (binding.key, f"{name} {binding.description}"))
        order = [keys[action] for action in sorted(keys, key=self._rank)]
        self.show_once(order, lambda width: [_row(order, width)])

    def _rank(self, action: str) -> int:
        """Help and the palette first, the way out, other rooms; the others follow as declared."""
        if action in self.FIRST:
            return self.FIRST.index(action)
        name = action.partition("(")[0]
        after = 0 if name in self.WAYS_OUT else 1 if name in self.ROOMS else 2
        return len(self.FIRST) + after


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
