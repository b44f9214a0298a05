"""What people say to the robot, in every situation of a dialogue, comes to what they mean.

The table tells what is read, or what the robot asks back; nothing else may come of a line.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from tests.dialogue.utterances import SITUATIONS, Situated, rows
from verbteach.dialogue.moves import Phase

_ROWS = rows()


@pytest.mark.parametrize("name", SITUATIONS)
def test_a_line_comes_to_what_the_table_says(name: str, tmp_path: Path) -> None:
    situated = Situated(SITUATIONS[name], tmp_path)
    listed = [row for row in _ROWS if row.situation == name]
    assert [(row.said, situated.outcome(row.said)) for row in listed] == [
        (row.said, row.outcome) for row in listed
    ]


def test_the_table_speaks_in_every_situation_and_says_nothing_twice() -> None:
    assert {row.situation for row in _ROWS} == set(SITUATIONS)
    assert max(Counter((row.situation, row.said) for row in _ROWS).values()) == 1
    assert len(_ROWS) > 400


def test_the_situations_are_of_every_phase(tmp_path: Path) -> None:
    phases = {
        Situated(situation, tmp_path / str(number)).phase
        for number, situation in enumerate(SITUATIONS.values())
    }
    assert phases == set(Phase)
