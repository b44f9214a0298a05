"""What F1 says: about the widget that has the focus, and every key that works on the screen."""

from __future__ import annotations

from textual.dom import DOMNode
from textual.screen import Screen

from verbteach_tui.screens.room import RoomScreen

_UNSAID = frozenset(
    {
        *("switch", "type", "scroll_left", "scroll_right"),
        *("app.focus_next", "app.focus_previous", "screen.copy_text"),
    }
)
"""Bindings that the rows above them say better, or that say nothing to a teacher."""

_PLAIN_HELP = "The arrow keys choose, Enter takes, Tab goes on to the next panel."


def help_about(node: DOMNode) -> str:
    """The help of ``node`` or of the nearest thing around it that has some."""
    for around in node.ancestors_with_self:
        if isinstance(around, RoomScreen):
            return around.about
        text = getattr(around, "HELP", None)
        if isinstance(text, str) and text:
            return text
    return _PLAIN_HELP


def keys_of(screen: Screen[object]) -> list[tuple[str, str]]:
    """The keys that work on ``screen``, with what they do."""
    rows: list[tuple[str, str]] = []
    if isinstance(screen, RoomScreen):
        rows += screen.single_keys()
        rows.append(("Tab or /", "type instead; Tab or Escape leaves the line"))
    for active in screen.active_bindings.values():
        binding = active.binding
        if binding.description and not binding.system and binding.action not in _UNSAID:
            rows.append((screen.app.get_key_display(binding), binding.description))
    return list(dict.fromkeys(rows))
