"""The user guide names every key, word and theme that there is, and shows pictures that exist."""

from __future__ import annotations

import re
import tempfile

from docs.diagrams import ROOT
from verbteach.dialogue.moves import Phase
from verbteach_tui.keys import ANYTIME, answer_keys
from verbteach_tui.plain_words import LOCAL
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.themes import THEMES
from verbteach_tui.views.marks import SIGNS

GUIDE = (ROOT / "docs" / "user-guide.md").read_text("utf-8")
CODE = set(re.findall(r"`([^`]+)`", GUIDE))


def test_every_single_key_is_in_the_guide() -> None:
    keys = {key.key for phase in Phase for key in (*answer_keys(phase), *ANYTIME)}
    assert keys <= CODE


def test_every_function_key_is_in_the_guide() -> None:
    for binding in TeachScreen.BINDINGS:
        key = str(getattr(binding, "key", ""))
        if re.fullmatch(r"f\d+", key):
            assert re.search(rf"\b{key.upper()}\b", GUIDE), key
        elif key.startswith("ctrl+"):
            assert f"Ctrl+{key[-1].upper()}" in GUIDE, key


def test_every_word_of_the_plain_mode_is_in_the_guide() -> None:
    assert set(LOCAL) <= CODE


def test_every_theme_is_in_the_guide_and_no_other() -> None:
    section = GUIDE.split("## Colours")[1]
    assert {theme.name for theme in THEMES} <= set(re.findall(r"`([^`]+)`", section))


def test_signs_that_the_guide_explains_are_those_of_the_scene() -> None:
    shown = {f"{sign.glyph} {sign.word}" for sign in SIGNS.values()}
    shown |= {f"{sign.off_glyph} {sign.off_word}" for sign in SIGNS.values() if sign.off_word}
    explained = {text for text in CODE if re.fullmatch(r"[^\w\s`\[(+/?-] \w+", text)}
    assert explained - {"≈ water", "◂ robot"} <= shown
    assert len(explained) >= 8


def test_every_picture_is_there_and_every_picture_is_shown() -> None:
    pages = [path.read_text("utf-8") for path in sorted((ROOT / "docs").glob("*.md"))]
    linked = set(re.findall(r"\(images/([a-z0-9-]+\.svg)\)", "\n".join(pages)))
    there = {path.name for path in (ROOT / "docs" / "images").glob("*.svg")}
    assert linked == there


def test_pictures_fetch_nothing_and_tell_nothing_of_where_they_were_made() -> None:
    for path in (ROOT / "docs" / "images").glob("*.svg"):
        text = path.read_text("utf-8")
        assert "url(http" not in text
        assert "@font-face" not in text
        assert str(ROOT) not in text
        assert tempfile.gettempdir() not in text
