"""The page on studies names everything that a study's file may say, and says what is so."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from docs.diagrams import ROOT
from tests.study.files import SCENES, SMALL
from verbteach_sessions.study.design import DESIGNS, PANELS
from verbteach_sessions.study.errors import StudyFileError
from verbteach_sessions.study.questionnaire import WHEN
from verbteach_sessions.study.study_file import parse_study

PAGE = (ROOT / "docs" / "running-a-study.md").read_text("utf-8")
NOWHERE = "nothing-is-called-so"


def known_keys() -> set[str]:
    """What each table of the file may have, as the check itself says it."""
    text = SMALL + "\n[[questionnaire.question]]\nid = 'q'\ntext = 'Why?'\n"
    for header in dict.fromkeys(re.findall(r"^\[.*\]$", text, re.M)):
        text = text.replace(f"{header}\n", f"{header}\n{NOWHERE} = 1\n")
    with pytest.raises(StudyFileError) as caught:
        parse_study(text.encode(), Path("study.toml"), SCENES)
    lists = re.findall(
        r"this table may have: (.*)", "\n".join(p.message for p in caught.value.problems)
    )
    return {name for found in lists for name in found.split(", ")}


def test_every_key_of_the_file_is_on_the_page() -> None:
    keys = known_keys()
    assert {"consent", "mastery", "panels", "nasa_tlx", "part"} <= keys
    for key in keys:
        assert re.search(rf"`{key}`|\[{key}|\.{key}\]", PAGE), key


@pytest.mark.parametrize("word", [*DESIGNS, *PANELS, *WHEN, "visit.jsonl", "questionnaire"])
def test_every_value_is_on_the_page(word: str) -> None:
    assert f"`{word}`" in PAGE


def test_every_page_it_links_to_is_there() -> None:
    for link in re.findall(r"\]\(([a-z-]+\.md)\)", PAGE):
        assert (ROOT / "docs" / link).is_file(), link
