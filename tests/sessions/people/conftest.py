"""A small part of the example corpus, made once for all tests that read it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.people.corpus import SMALL, read_all
from verbteach_sessions.example import make_example
from verbteach_sessions.people.recorded import Recorded


@pytest.fixture(scope="session")
def example(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ...]:
    """The folders of the small corpus's sessions."""
    return make_example(tmp_path_factory.mktemp("example"), SMALL)


@pytest.fixture(scope="session")
def records(example: tuple[Path, ...]) -> tuple[Recorded, ...]:
    """The small corpus, read."""
    return read_all(example)
