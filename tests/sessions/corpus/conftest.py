"""The small corpus: made once, and a copy for each test that changes something."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.sessions.corpora import small_corpus


@pytest.fixture(scope="session")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ...]:
    return small_corpus(tmp_path_factory)


@pytest.fixture
def mine(corpus: tuple[Path, ...], tmp_path: Path) -> tuple[Path, ...]:
    return tuple(Path(shutil.copytree(p, tmp_path / "sessions" / p.name)) for p in corpus)
