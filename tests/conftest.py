"""For all tests: property tests have no deadline, and nothing is kept in one's own folders.

Rooms are grounded once; what takes a room's grounding apart does not ask for settings.

A test that hangs fails with its stack: pyproject.toml has the limit for most, and
slow tests have one of their own unless they name another.

Numpy works on one thread, as the commands let it, and processes that tests begin
can be interrupted though the tests themselves were begun in the background.
"""

from __future__ import annotations

import signal
from collections.abc import Generator, Iterator

import pytest
from hypothesis import settings

from tests.grounded import rooms_grounded_once
from tests.hanging import tasks_of
from verbteach_sessions.places import DATA_VARIABLE
from verbteach_tui.workers import one_thread

one_thread()
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

settings.register_profile("patient", deadline=None)  # a busy machine is no failure
settings.load_profile("patient")

SLOW_LIMIT = 1800.0  # seconds; 10,000 random keys on a busy machine take half of it


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Give slow tests the longer limit."""
    for item in items:
        if item.get_closest_marker("slow") and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(SLOW_LIMIT))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Say of a test that ran out of time where it waits."""
    report = yield
    late = call.excinfo is not None and "from pytest-timeout" in str(call.excinfo.value)
    if late and (waiting := tasks_of(item)):
        report.sections.append(("Where its tasks wait", waiting))
    return report


@pytest.fixture(scope="session", autouse=True)
def _own_data_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keys and sessions that no test names go to a folder of the tests' own."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv(DATA_VARIABLE, str(tmp_path_factory.mktemp("data")))
        yield


@pytest.fixture(scope="session", autouse=True)
def _rooms_grounded_once() -> Iterator[None]:
    with rooms_grounded_once():
        yield
