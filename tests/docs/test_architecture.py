"""The architecture page shows the code's own tables as they are now."""

from __future__ import annotations

import re

import pytest

from docs import diagrams
from verbteach.dialogue.moves import TEACHER_MOVES


def test_generated_blocks_are_current() -> None:
    page = diagrams.PAGE.read_text("utf-8")
    assert page == diagrams.current(page), "run: python docs/diagrams.py"


def test_every_block_is_on_the_page() -> None:
    page = diagrams.PAGE.read_text("utf-8")
    shown = re.findall(r"<!-- generated: ([a-z ]+) -->", page)
    assert sorted(shown) == sorted(diagrams.BLOCKS)


def test_a_stale_block_is_noticed() -> None:
    page = diagrams.PAGE.read_text("utf-8")
    assert diagrams.current(page.replace("read_back", "read_aloud")) == page


def test_an_unknown_block_is_an_error() -> None:
    with pytest.raises(KeyError):
        diagrams.current("<!-- generated: weather -->\n<!-- end -->")


def test_the_phase_diagram_has_an_arrow_for_every_move() -> None:
    diagram = diagrams.phases()
    for phase, moves in TEACHER_MOVES.items():
        for act, following in moves.items():
            for after in following:
                arrow = re.search(rf"^    {phase.value} --> {after.value}: (.*)$", diagram, re.M)
                assert arrow is not None
                assert act.name in arrow.group(1).split(", ")


def test_paths_named_in_the_pages_exist() -> None:
    for name in ("docs/architecture.md", "README.md", "CONTRIBUTING.md"):
        text = (diagrams.ROOT / name).read_text("utf-8")
        paths = re.findall(r"`((?:core|scenarios|sessions|tui|tests|docs)/[\w./-]*)`", text)
        links = re.findall(r"\]\((?!https?:)([^)#]+)\)", text)
        folder = (diagrams.ROOT / name).parent
        missing = [p for p in paths if not (diagrams.ROOT / p).exists()]
        missing += [link for link in links if not (folder / link).exists()]
        assert not missing, f"{name} names {missing}"
