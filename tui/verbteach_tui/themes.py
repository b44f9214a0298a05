"""The app's colours: every text at least 4.5 to 1 against what it stands on, as a test checks."""

from __future__ import annotations

from dataclasses import replace

from textual.theme import BUILTIN_THEMES, Theme

DEFAULT = "evening"

VARIABLES = {"quiet": "#9dabbd", "rule": "#3b4657"}
"""The app's own variables: less important text, and lines that divide."""


def _variables(quiet: str, rule: str, cursor: str, on_cursor: str, key: str) -> dict[str, str]:
    return {
        "quiet": quiet,
        "rule": rule,
        "block-cursor-background": cursor,
        "block-cursor-foreground": on_cursor,
        "block-cursor-text-style": "bold",
        "footer-key-foreground": key,
        "footer-description-foreground": quiet,
        "border-blurred": rule,
    }


EVENING = Theme(
    name="evening",
    primary="#7cc4ff",
    secondary="#b9a7f5",
    accent="#ffc66d",
    foreground="#e7ebf1",
    background="#11161d",
    surface="#161c25",
    panel="#1f2733",
    success="#8fd694",
    warning="#ffb454",
    error="#ff8a80",
    variables=_variables("#9dabbd", "#3b4657", "#7cc4ff", "#0b1017", "#7cc4ff"),
)

DAYLIGHT = Theme(
    name="daylight",
    primary="#0b57a4",
    secondary="#5b3fa8",
    accent="#844600",
    foreground="#1d2330",
    background="#fcfbf8",
    surface="#f5f3ee",
    panel="#eae7df",
    success="#17652a",
    warning="#844600",
    error="#a8231b",
    dark=False,
    variables=_variables("#55606f", "#c8c2b5", "#0b57a4", "#ffffff", "#0b57a4"),
)

CLEAR = Theme(
    name="clear",
    primary="#56b4e9",
    secondary="#cc79a7",
    accent="#e69f00",
    foreground="#ffffff",
    background="#000000",
    surface="#0a0a0a",
    panel="#1a1a1a",
    success="#2ac79a",
    warning="#f0e442",
    error="#ff8a5c",
    variables=_variables("#c8c8c8", "#7a7a7a", "#f0e442", "#000000", "#f0e442"),
)
"""High contrast, in the colours that Okabe and Ito chose for colour-blind eyes."""

_ANSI = {"quiet": "ansi_default", "rule": "ansi_bright_black"}

# The terminal says what these look like. On the usual palettes blue and red are hard to read on
# black, green on white; the words and glyphs beside them say the same.
ANSI_DARK = replace(
    BUILTIN_THEMES["ansi-dark"],
    primary="ansi_bright_cyan",
    error="ansi_bright_red",
    variables={**BUILTIN_THEMES["ansi-dark"].variables, **_ANSI},
)
ANSI_LIGHT = replace(
    BUILTIN_THEMES["ansi-light"],
    success="ansi_blue",
    warning="ansi_red",
    variables={**BUILTIN_THEMES["ansi-light"].variables, **_ANSI},
)

THEMES: tuple[Theme, ...] = (
    EVENING,
    DAYLIGHT,
    CLEAR,
    ANSI_DARK,
    ANSI_LIGHT,
)
"""All that the app ships; the ansi ones take the terminal's own colours."""
