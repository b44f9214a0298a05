"""What F1 says: about the widget that has the focus, and every key that works on the screen."""

from __future__ import annotations

import re

from textual.binding import Binding
from textual.dom import DOMNode
from textual.screen import Screen
from textual.widgets import Input, TextArea

from verbteach_tui.screens.room import RoomScreen

_UNSAID = frozenset({"switch", "type", "select", "app.focus_next", "app.focus_previous"})
"""Bindings that the rows above them say better."""

_GENERAL = re.compile(r"(screen\.)?(scroll|page|cursor|copy|delete|first|last|home|end|select)")
"""How the toolkit names moving about, which every list and text has and nobody looks up."""

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
    """The keys that work on ``screen``, with what they do; those that do the same share a row."""
    rows: list[tuple[str, str]] = []
    if isinstance(screen, RoomScreen):
        rows += screen.single_keys()
    if screen.query("#line"):
        rows.append(("Tab or /", "type instead; Tab leaves the line"))
    named: dict[str, list[str]] = {}
    for active in screen.active_bindings.values():
        binding = active.binding
        if active.enabled and _is_worth_saying(binding, screen.focused):
            keys = named.setdefault(binding.description, [])
            keys.append(screen.app.get_key_display(binding))
    rows += [(", ".join(dict.fromkeys(keys)), told) for told, keys in named.items()]
    return list(dict.fromkeys(rows))


def _is_worth_saying(binding: Binding, focused: DOMNode | None) -> bool:
    if not binding.description or binding.system or binding.action in _UNSAID:
        return False
    if isinstance(focused, Input | TextArea) and binding.action in _of_toolkit(focused):
        return False
    return _GENERAL.match(binding.action) is None


def _of_toolkit(focused: Input | TextArea) -> frozenset[str]:
    """The actions that every text to type in has."""
    kind = Input if isinstance(focused, Input) else TextArea
    return frozenset(made.action for one in kind.BINDINGS for made in Binding.make_bindings([one]))
