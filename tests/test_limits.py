"""A test that hangs fails with its stack, and those after it still run."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from docs.diagrams import ROOT
from tests.conftest import SLOW_LIMIT

HANGING = """
import asyncio
import subprocess
import sys

import pytest
from textual.app import App


def test_what_all_need_is_made():
    pass


async def for_ever():
    await asyncio.Event().wait()


@pytest.mark.timeout(3)
async def test_the_screen_waits_for_ever():
    async with App().run_test():
        await for_ever()


@pytest.mark.timeout(1)
def test_a_process_never_ends():
    subprocess.run([sys.executable, "-c", "import time; time.sleep(60)"])


def test_another():
    pass
"""


def test_a_hanging_test_fails_where_it_stands_and_the_next_one_runs(tmp_path: Path) -> None:
    hanging = tmp_path / "test_hanging.py"
    hanging.write_text(HANGING)
    options = ["-c", ROOT / "pyproject.toml", "-p", "tests.conftest", "-p", "no:cacheprovider"]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *map(str, options), str(hanging)],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        cwd=ROOT,
    )
    assert "2 failed, 2 passed" in done.stdout, done.stdout + done.stderr
    assert "Timeout (>1.0s)" in done.stdout
    assert "Timeout (>3.0s)" in done.stdout
    assert "test_hanging.py:15: in for_ever" in done.stdout


def test_every_test_has_a_limit(request: pytest.FixtureRequest) -> None:
    assert 0 < float(request.config.getini("timeout")) < SLOW_LIMIT
    assert float(request.config.getini("faulthandler_timeout")) > SLOW_LIMIT


@pytest.mark.slow
def test_a_slow_test_has_the_longer_limit(request: pytest.FixtureRequest) -> None:
    marker = request.node.get_closest_marker("timeout")
    assert marker.args == (SLOW_LIMIT,)
