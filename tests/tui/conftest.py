"""A session to look at, for the tests of commands."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.tui.scripted import SCRIPT, taught


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A session taught by a script that fits to its end. Tests leave it as it is."""
    ran = taught(SCRIPT, tmp_path_factory.mktemp("sessions"))
    assert ran.status == 0, ran
    return Path(ran.document["session"])


@pytest.fixture
def copy(kept: Path, tmp_path: Path) -> Path:
    """The same session in a folder of its own, to be spoiled."""
    return Path(shutil.copytree(kept, tmp_path / "sessions" / kept.name))
