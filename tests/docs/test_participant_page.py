"""The participant's page fits on one page, and names only keys, words and pages that there are."""

from __future__ import annotations

import re

from docs.diagrams import ROOT
from verbteach.dialogue.moves import Phase
from verbteach_tui.keys import ANYTIME, answer_keys
from verbteach_tui.plain_words import LOCAL
from verbteach_tui.study import words

PAGE = (ROOT / "docs" / "participant.md").read_text("utf-8")
KEYS = {key.key for phase in Phase for key in (*answer_keys(phase), *ANYTIME)}


def test_every_single_key_it_names_answers() -> None:
    named = {code for code in re.findall(r"`([^`]+)`", PAGE) if len(code) == 1}
    assert named - {"x", "/"} <= KEYS
    assert {"y", "n", "?", "g", "b", "u", "w", "s", "d", "t"} <= named


def test_the_words_of_the_plain_mode_are_right() -> None:
    assert "`help`" in PAGE
    assert "help" in LOCAL
    assert "look" in LOCAL
    assert "type end" in words.STOP_ASKED


def test_it_is_one_page_with_two_pictures_that_are_there() -> None:
    pictures = re.findall(r"\(images/([a-z-]+\.svg)\)", PAGE)
    assert len(pictures) == 2
    assert all((ROOT / "docs" / "images" / name).is_file() for name in pictures)
    assert len(PAGE.split()) < 800


def test_it_is_linked_from_where_people_begin() -> None:
    for page, link in (
        ("README.md", "docs/participant.md"),
        ("docs/user-guide.md", "participant.md"),
        ("docs/running-a-study.md", "participant.md"),
    ):
        assert f"]({link})" in (ROOT / page).read_text("utf-8"), page
