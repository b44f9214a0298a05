"""Frames written on a line read back as they were; other lines are refused with a reason."""

from __future__ import annotations

import pytest
from hypothesis import given

from tests.language.strategies import WORD_SALADS
from verbteach.language.grammar import parse
from verbteach.language.notation import NotationError, read_frames, write_frames


@given(WORD_SALADS)
def test_what_the_grammar_reads_is_written_and_read_back(text: str) -> None:
    line = write_frames(parse(text))
    assert write_frames(read_frames(line)) == line


@pytest.mark.parametrize("line", ["", "check()", "put(obj=plant[red,in:room[living]]; loc=there)"])
def test_lines_round_trip(line: str) -> None:
    assert write_frames(read_frames(line)) == line


@pytest.mark.parametrize(
    "line", ["put", "put(obj)", "(obj=a)", "put(obj=a[b)", "put(=a)", "put(obj=)"]
)
def test_other_lines_are_refused(line: str) -> None:
    with pytest.raises(NotationError, match="write"):
        read_frames(line)
