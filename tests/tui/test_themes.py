"""Colours: enough contrast in every theme, and none needed to understand what is shown."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from textual.color import Color
from textual.theme import Theme

from verbteach_tui.themes import THEMES, VARIABLES
from verbteach_tui.views.cards import Emphasis, picture_rows
from verbteach_tui.views.execution import Playback, playback_rows
from verbteach_tui.views.mind import ActValue, Mind, mind_rows
from verbteach_tui.views.picture import Actor, Picture, Thing
from verbteach_tui.views.rows import STYLES, plain
from verbteach_tui.widgets.palette import pairs, rows_style

OWN = [theme for theme in THEMES if not theme.ansi]
PANELS = ("background", "surface", "panel")
ENOUGH = 4.5  # WCAG 2.1, success criterion 1.4.3
LINES = {"rule"}  # lines and empty parts of bars say nothing by themselves


XTERM = (
    "#000000", "#cd0000", "#00cd00", "#cdcd00", "#0000ee", "#cd00cd", "#00cdcd", "#e5e5e5",
    "#7f7f7f", "#ff0000", "#00ff00", "#ffff00", "#5c5cff", "#ff00ff", "#00ffff", "#ffffff",
)  # fmt: skip
"""The sixteen colours as xterm has them, by their numbers; other terminals have others."""


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


def cards(thing: Thing, **emphasis: Any) -> list[str]:
    """A scene with one thing in it, without its colours."""
    picture = Picture("", others=(thing,))
    return [plain(row) for row in picture_rows(picture, 40, emphasis=Emphasis(**emphasis))]


def test_what_colours_say_is_said_by_words_or_glyphs_as_well() -> None:
    steps = ("one", "two", "three")
    at = [plain(row) for row in playback_rows(Playback(steps, at=2), 40)[1:]]
    assert len({row[4] for row in at}) == 3, "done, being shown and still to come"
    cup = Thing("Cup_1", "cup")
    here = Actor("Robot", "robot", near=("Cup_1",))
    shown = (
        cards(cup),
        cards(cup, asked={"Cup_1"}),
        cards(cup, digits={"Cup_1": "1"}),
        cards(replace(cup, moved=True)),
        cards(replace(cup, sure=0.5)),
        [plain(row) for row in picture_rows(Picture("", (here,), others=(cup,)), 40)[1:]],
    )
    assert len({"".join(rows) for rows in shown}) == len(shown)
    chosen, passed = (mind_rows(Mind(acts=(ActValue("ask", 1.0, c),)), 40) for c in (True, False))
    assert [plain(row) for row in chosen] != [plain(row) for row in passed]


@pytest.mark.parametrize("theme", THEMES, ids=lambda theme: theme.name)
def test_every_style_has_a_look_in_every_theme(theme: Theme) -> None:
    has = variables(theme)
    for style in STYLES:
        assert rows_style(style, has).color is not None or rows_style(style, has).reverse


def on_xterm(name: str, fallback: str) -> str:
    """The colour that xterm makes of an ansi one; ``fallback`` for the terminal's own."""
    number = Color.parse(name).ansi
    assert number is not None, f"{name} is no colour of the terminal's"
    return fallback if number < 0 else XTERM[number]


@pytest.mark.parametrize("theme", [t for t in THEMES if t.ansi], ids=lambda theme: theme.name)
def test_terminal_themes_can_be_read_on_the_usual_palette(theme: Theme) -> None:
    has = variables(theme)
    paper = XTERM[0] if theme.dark else XTERM[15]
    ink = XTERM[7] if theme.dark else XTERM[0]
    for style in STYLES:
        made = rows_style(style, has)
        if made.reverse:
            assert made.color is None, "the terminal's own two colours, the other way round"
    for colour, behind in pairs():
        if colour not in LINES and not behind:
            assert contrast(on_xterm(has[colour], ink), paper) >= ENOUGH, colour
    cursor = [on_xterm(has[f"block-cursor-{part}"], ink) for part in ("foreground", "background")]
    assert contrast(*cursor) >= ENOUGH
    assert contrast(on_xterm(has["primary"], ink), paper) >= 3, "WCAG 1.4.11: focus is seen"


def test_terminal_themes_keep_to_the_terminals_own_colours() -> None:
    for theme in THEMES:
        if theme.ansi:
            colours = [rows_style(style, variables(theme)).color for style in STYLES]
            assert all(c is None or c.is_system_defined or c.is_default for c in colours)
