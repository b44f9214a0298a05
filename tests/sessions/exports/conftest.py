"""The small corpus, made once for all tests of exports; they leave it as it is."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.corpora import small_corpus
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.reading import read_dialogue


@pytest.fixture(scope="session")
def corpus(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ...]:
    return small_corpus(tmp_path_factory)


@pytest.fixture(scope="session")
def dialogues(corpus: tuple[Path, ...]) -> tuple[Dialogue, ...]:
    return tuple(read_dialogue(path) for path in corpus)
