"""The sessions in a folder, the latest first, read from their headers alone."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

MOST = 60
_LOG, _HEADER = "events.jsonl", "header.json"


@dataclass(frozen=True)
class SessionRow:
    """A session that can be gone on with; ``changed`` is when, in seconds of the epoch."""

    path: Path
    scene: str
    changed: float

    @property
    def name(self) -> str:
        """The session's name."""
        return self.path.name


def recent_sessions(folder: Path) -> tuple[SessionRow, ...]:
    """The latest sessions in ``folder``; whatever is no session is passed over."""
    try:
        folders = [path for path in folder.iterdir() if path.is_dir()]
    except OSError:
        return ()
    rows = [row for row in map(_row, folders) if row is not None]
    return tuple(sorted(rows, key=lambda row: (-row.changed, row.name))[:MOST])


def _row(path: Path) -> SessionRow | None:
    try:
        changed = (path / _LOG).stat().st_mtime
    except OSError:
        return None
    try:
        scene = json.loads((path / _HEADER).read_bytes())["scene"]
    except (OSError, ValueError, KeyError, TypeError):
        scene = "?"
    return SessionRow(path, str(scene), changed)


def ago(seconds: float) -> str:
    """As in: 3 h ago, for a list."""
    for size, unit in ((86400, "d"), (3600, "h"), (60, "min")):
        if seconds >= size:
            return f"{int(seconds // size)} {unit} ago"
    return "just now"
