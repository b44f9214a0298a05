"""Where things are kept unless another place is named."""

from __future__ import annotations

import os
from pathlib import Path

DATA_VARIABLE = "VERBTEACH_DATA"


def data_folder() -> Path:
    """The folder for what is kept from day to day; it need not exist yet.

    ``VERBTEACH_DATA`` where it is set, else the platform's place for an
    application's data.
    """
    named = os.environ.get(DATA_VARIABLE)
    if named:
        return Path(named).expanduser()
    from platformdirs import user_data_path  # noqa: PLC0415 - only where no folder is named

    return user_data_path("verbteach", appauthor=False)
