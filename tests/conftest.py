"""For all tests: property tests have no deadline, and nothing is kept in one's own folders.

Rooms are grounded once; what takes a room's grounding apart does not ask for settings.

Numpy works on one thread, as the commands let it, and processes that tests begin
can be interrupted though the tests themselves were begun in the background.
"""

from __future__ import annotations

import signal
from collections.abc import Iterator

import pytest
from hypothesis import settings

from tests.grounded import rooms_grounded_once
from verbteach_sessions.places import DATA_VARIABLE
from verbteach_tui.workers import one_thread

one_thread()
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

settings.register_profile("patient", deadline=None)  # a busy machine is no failure
settings.load_profile("patient")


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
