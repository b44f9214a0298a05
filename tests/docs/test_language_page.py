"""The page on language shows what the grammar does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from verbteach.language.grammar import parse
from verbteach.language.notation import write_frames

PAGE = Path(__file__).parents[2] / "docs" / "language.md"
ROWS = re.findall(r"^\| ([^|]+) \| `([a-z_]+\(.*\))` \|$", PAGE.read_text("utf-8"), re.MULTILINE)


def test_the_page_has_examples() -> None:
    assert len(ROWS) > 15


@pytest.mark.parametrize(("said", "read"), ROWS)
def test_examples_are_read_as_the_page_says(said: str, read: str) -> None:
    assert write_frames(parse(said)) == read
