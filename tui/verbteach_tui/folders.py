"""Where this installation keeps things: the folder of sessions."""

from __future__ import annotations

import os
from pathlib import Path

SESSIONS_VARIABLE = "VERBTEACH_SESSIONS"


def sessions_folder() -> Path:
    """The folder that new sessions go to unless the command line names another.

    ``VERBTEACH_SESSIONS`` where it is set, else the platform's place for an
    application's data. The folder need not exist yet.
    """
    named = os.environ.get(SESSIONS_VARIABLE)
    if named:
        return Path(named).expanduser()
    import platformdirs

    return platformdirs.user_data_path("verbteach", appauthor=False) / "sessions"


def is_writable(folder: Path) -> bool:
    """Whether sessions can be made in ``folder``, or in the nearest folder above that exists."""
    nearest = next((p for p in (folder, *folder.absolute().parents) if p.exists()), None)
    return nearest is not None and nearest.is_dir() and os.access(nearest, os.W_OK | os.X_OK)
