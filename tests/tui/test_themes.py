"""Colours: enough contrast in every theme, and none needed to understand what is shown."""

from __future__ import annotations

import pytest
from textual.color import Color
from textual.theme import Theme

from verbteach_tui.themes import THEMES, VARIABLES
from verbteach_tui.views.rows import STYLES
from verbteach_tui.widgets.palette import pairs, rows_style

OWN = [theme for theme in THEMES if not theme.ansi]
PANELS = ("background", "surface", "panel")
ENOUGH = 4.5  # WCAG 2.1, success criterion 1.4.3
LINES = {"rule"}  # lines and empty parts of bars say nothing by themselves


def variables(theme: Theme) -> dict[str, str]:
    return {**VARIABLES, **theme.to_color_system().generate(), **theme.variables}


def luminance(color: Color) -> float:
    parts = [channel / 255 for channel in (color.r, color.g, color.b)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    a, b = sorted((luminance(Color.parse(one)), luminance(Color.parse(other))), reverse=True)
    return (a + 0.05) / (b + 0.05)


def test_contrast_is_measured_as_the_standard_does() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)


@pytest.mark.parametrize("theme", OWN, ids=lambda theme: theme.name)
def test_all_text_stands_out_from_what_is_behind_it(theme: Theme) -> None:
    has = variables(theme)
    for colour, behind in pairs():
        for panel in [behind] if behind else PANELS:
            if colour not in LINES:
                assert contrast(has[colour], has[panel]) >= ENOUGH, (colour, panel)


@pytest.mark.parametrize("theme", OWN, ids=lambda theme: theme.name)
def test_cursors_and_keys_stand_out(theme: Theme) -> None:
    has = variables(theme)
    on_cursor = contrast(has["block-cursor-foreground"], has["block-cursor-background"])
    assert on_cursor >= ENOUGH
    assert contrast(has["primary"], has["background"]) >= 3, "WCAG 1.4.11: focus is seen"


@pytest.mark.parametrize("theme", THEMES, ids=lambda theme: theme.name)
def test_every_style_has_a_look_in_every_theme(theme: Theme) -> None:
    has = variables(theme)
    for style in STYLES:
        assert rows_style(style, has).color is not None or rows_style(style, has).reverse


def test_terminal_themes_keep_to_the_terminals_own_colours() -> None:
    for theme in THEMES:
        if theme.ansi:
            colours = [rows_style(style, variables(theme)).color for style in STYLES]
            assert all(c is None or c.is_system_defined or c.is_default for c in colours)
