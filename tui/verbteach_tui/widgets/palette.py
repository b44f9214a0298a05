"""The theme's colours for the styles that rows are drawn in.

Looked up here instead of by a component class for each style in each panel:
with those, every change of a class on the screen would match thousands of
rules, and that is what a person would wait for.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from rich.style import Style
from textual.color import Color

# style: (theme variable of its colour, of its background or "", attributes)
_LOOKS: Mapping[str, tuple[str, str, str]] = {
    "text": ("foreground", "", ""),
    "muted": ("quiet", "", ""),
    "strong": ("foreground", "", "bold"),
    "robot": ("text-primary", "", "bold"),
    "teacher": ("text-accent", "", "bold"),
    "note": ("quiet", "", "italic"),
    "accent": ("text-accent", "", ""),
    "good": ("text-success", "", ""),
    "bad": ("text-error", "", ""),
    "warn": ("text-warning", "", ""),
    "new": ("text-warning", "", "bold"),
    "asked": ("background", "warning", "bold"),
    "border": ("rule", "", ""),
    "bar": ("text-primary", "", ""),
    "cursor": ("background", "foreground", ""),
    "tag": ("quiet", "", ""),
}


def rows_style(style: str, variables: Mapping[str, str]) -> Style:
    """How ``style`` looks under a theme's ``variables``; without a background where it has none."""
    colour, behind, attributes = _LOOKS[style]
    return _made(variables[colour], variables[behind] if behind else "", attributes)


def pairs() -> tuple[tuple[str, str], ...]:
    """Every pair of variables that text is shown in, as (colour, background); "" is the panel's."""
    return tuple(dict.fromkeys((colour, behind) for colour, behind, _ in _LOOKS.values()))


@lru_cache(maxsize=256)
def _made(colour: str, behind: str, attributes: str) -> Style:
    style = Style.parse(attributes) if attributes else Style()
    back = Color.parse(behind).rich_color if behind else None
    front = Color.parse(colour)
    if front.ansi == -1 and back is not None:  # the terminal's own colours, the other way round
        return style + Style(reverse=True)
    return style + Style(color=front.rich_color, bgcolor=back)
