"""The features, policies and learners on the page are those of the code."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from docs import learners
from verbteach.dialogue import execution_inquiry, learning_inquiry
from verbteach.experiments.interactive_training import LEARNERS
from verbteach_tui.plots.curves import COLOURS, MARKERS

PAGE = (Path(__file__).parents[2] / "docs" / "learning.md").read_text(encoding="utf-8")


def table(heading: str) -> dict[str, str]:
    section = PAGE.split(heading, 1)[1].split("\n#", 1)[0]
    return dict(re.findall(r"^\| `([^`]+)` \| (.+) \|$", section, re.MULTILINE))


@pytest.mark.parametrize(
    ("heading", "features"),
    [
        ("### Features of the execution phase", execution_inquiry.FEATURES),
        ("### Features of the learning phase", learning_inquiry.FEATURES),
    ],
)
def test_every_feature_is_on_the_page_as_the_code_describes_it(
    heading: str, features: dict[str, str]
) -> None:
    assert table(heading) == features


def test_every_learner_is_on_the_page() -> None:
    assert set(table("## Learners")) == {*LEARNERS, "lspi"}


def test_every_learner_is_compared_and_has_a_colour_and_a_mark_of_its_own() -> None:
    assert set(learners.LEARNERS) == {*LEARNERS, "lspi"}
    for signs in (COLOURS, MARKERS):
        assert len({signs[name] for name in learners.LEARNERS}) == len(learners.LEARNERS)
