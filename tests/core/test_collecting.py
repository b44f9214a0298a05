"""The search for cycles is put off for as long as asked, and no longer."""

from __future__ import annotations

import gc

import pytest

from verbteach.collecting import without_collecting


def test_it_is_on_again_afterwards_whatever_happened() -> None:
    with pytest.raises(ZeroDivisionError), without_collecting():
        assert 1 / gc.isenabled(), "it is off, which is false, which is zero"
    assert gc.isenabled()


def test_where_it_was_off_it_stays_off() -> None:
    gc.disable()
    try:
        with without_collecting():
            assert not gc.isenabled()
        assert not gc.isenabled()
    finally:
        gc.enable()
