"""Where things are kept unless another place is named."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from verbteach_sessions.errors import NoHomeError

DATA_VARIABLE = "VERBTEACH_DATA"


@contextmanager
def at_home() -> Iterator[None]:
    """Say in a typed error that there is no home directory, where a place in it is looked for."""
    try:
        yield
    except RuntimeError as error:
        reason = "no home directory is known here: set HOME, or name a folder"
        raise NoHomeError(f"{reason} (--sessions, or {DATA_VARIABLE})") from error


def data_folder() -> Path:
    """The folder for what is kept from day to day; it need not exist yet.

    ``VERBTEACH_DATA`` where it is set, else the platform's place for an
    application's data. Raises :class:`NoHomeError`.
    """
    named = os.environ.get(DATA_VARIABLE)
    with at_home():
        if named:
            return Path(named).expanduser()
        from platformdirs import user_data_path  # noqa: PLC0415 - only where no folder is named

        return user_data_path("verbteach", appauthor=False)
