"""The page on exports has every format that there is, with what reads it."""

from __future__ import annotations

import re

from docs.diagrams import ROOT
from verbteach_sessions.exports.formats import FORMATS

PAGE = (ROOT / "docs" / "exports.md").read_text("utf-8")
ROWS = dict(re.findall(r"^\| `(\w+)` \| .* \| (.*) \|$", PAGE, re.MULTILINE))
SECTIONS = set(re.findall(r"^### (\w+)$", PAGE, re.MULTILINE))


def test_every_format_has_its_row() -> None:
    assert list(ROWS) == list(dict.fromkeys(ROWS))
    assert set(ROWS) == set(FORMATS)


def test_what_a_library_reads_has_a_section_that_says_how() -> None:
    assert set(SECTIONS) == {name for name, reader in ROWS.items() if f"](#{name})" in reader}
    assert {name for name, form in FORMATS.items() if form.packages} <= SECTIONS


def test_what_needs_an_extra_says_so() -> None:
    for name, form in FORMATS.items():
        assert (f"needs `verbteach[{form.extra}]`" in ROWS[name]) is bool(form.extra)
