"""Work that is spread over processes: bundles stay together, and nothing is lost."""

from __future__ import annotations

import os

import pytest

from verbteach_tui.workers import Workers


def where(number: int) -> tuple[int, int]:
    return number, os.getpid()


BUNDLES = [[3 * n, 3 * n + 1, 3 * n + 2] for n in range(16)]


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_bundle_stays_in_one_process(jobs: int) -> None:
    found = dict(Workers(jobs).bundled(where, BUNDLES))
    assert sorted(found) == list(range(48))
    assert all(len({found[number] for number in bundle}) == 1 for bundle in BUNDLES)
    assert (os.getpid() in found.values()) == (jobs == 1)


def test_few_bundles_are_taken_apart() -> None:
    found = dict(Workers(2).bundled(where, BUNDLES[:2]))
    assert sorted(found) == list(range(6))
