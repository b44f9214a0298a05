"""``header.json``: the header event again, for people and listings; the log is the authority."""

from __future__ import annotations

import json
from pathlib import Path

from verbteach_sessions.files import replace_file
from verbteach_sessions.lines import VERSION, Event

HEADER_NAME = "header.json"


def header_bytes(header: Event) -> bytes:
    """What the file should hold."""
    value = {"v": VERSION, **header.data}
    return json.dumps(value, indent=2, allow_nan=False).encode() + b"\n"


def write_header(folder: Path, header: Event) -> None:
    """Write the file as a whole or not at all. Raises :class:`StorageError`."""
    replace_file(folder / HEADER_NAME, header_bytes(header))


def header_fits(folder: Path, header: Event) -> bool:
    """Whether the file is there and says what the log says."""
    path = folder / HEADER_NAME
    expected = header_bytes(header)
    try:
        return path.stat().st_size == len(expected) and path.read_bytes() == expected
    except OSError:
        return False
