"""What the robot can say is written down once, to be read; the code must still say it."""

from __future__ import annotations

from tests.language import golden


def test_the_written_wording_is_what_the_robot_says() -> None:
    written = golden.FILE.read_text(encoding="utf-8")
    assert golden.text() == written, "say `python -m tests.language.golden`, then read the change"


def test_every_sentence_is_filled_in_and_starts_small() -> None:
    for line in golden.FILE.read_text(encoding="utf-8").splitlines():
        assert "{" not in line
        assert "  " not in line.strip()
        assert "the the " not in line
