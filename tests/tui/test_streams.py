"""Tables of the command line: aligned where there is room, told cell by cell where there is not."""

from __future__ import annotations

import os
import sys

import pytest

from verbteach_tui.commands.streams import columns

ROWS = [("SESSION", "SCENE", "EPISODES"), ("s1", "kitchen-1", 3), ("s2", "living-room-1", 12)]


def _on_a_terminal(patch: pytest.MonkeyPatch, width: int) -> None:
    patch.setattr(sys.stdout, "isatty", lambda: True)
    patch.setattr(
        "verbteach_tui.commands.streams.get_terminal_size",
        lambda fallback: os.terminal_size((width, 24)),
    )


def test_a_table_that_fits_is_aligned(monkeypatch: pytest.MonkeyPatch) -> None:
    _on_a_terminal(monkeypatch, 80)
    assert columns(ROWS).splitlines() == [
        "SESSION  SCENE          EPISODES",
        "s1       kitchen-1             3",
        "s2       living-room-1        12",
    ]


def test_a_table_that_does_not_fit_is_told_row_by_row(monkeypatch: pytest.MonkeyPatch) -> None:
    _on_a_terminal(monkeypatch, 30)
    assert columns(ROWS).split("\n\n") == [
        "SESSION   s1\nSCENE     kitchen-1\nEPISODES  3",
        "SESSION   s2\nSCENE     living-room-1\nEPISODES  12",
    ]


def test_what_goes_into_a_pipe_stays_a_table(monkeypatch: pytest.MonkeyPatch) -> None:
    _on_a_terminal(monkeypatch, 30)
    monkeypatch.setattr(sys.stdout, "isatty", lambda: False)
    assert len(columns(ROWS).splitlines()) == len(ROWS)
