"""A session as it is named on the command line: by its folder, or as `sessions list` prints it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from verbteach_tui.conclusion import WrongUseError

_SHOWN = 50


def session_path(text: str) -> Path:
    """The path typed, or the session of that name in the person's own folder."""
    path = Path(text)
    if path.exists() or path.name != text:
        return path
    return next((one for one in _own() if one.name == text), path)


def session_named(text: str) -> Path:
    """As :func:`session_path`, for where there must be one. Raises :class:`WrongUseError`."""
    path = session_path(text)
    if not os.path.lexists(path):
        raise WrongUseError(f"{text}: no such session; 'verbteach sessions list' has yours")
    return path


def session_completions(incomplete: str) -> list[str]:
    """For the shell: the person's sessions, the newest first, and folders that begin so."""
    own = [path.name for path in reversed(_own()) if path.name.startswith(incomplete)]
    return [*own[:_SHOWN], *_folders(incomplete)]


def _own() -> tuple[Path, ...]:
    from verbteach_sessions.catalogue import default_folder, session_folders
    from verbteach_sessions.errors import NoHomeError

    try:
        return session_folders(default_folder())
    except NoHomeError:
        return ()


def _folders(incomplete: str) -> Iterator[str]:
    begun, last = os.path.split(incomplete)
    try:
        inside = sorted(Path(begun).iterdir())
    except OSError:
        return
    for path in inside:
        if path.name.startswith(last) and not path.name.startswith(".") and path.is_dir():
            yield str(path)
