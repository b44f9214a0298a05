"""``header.json``: the header event again, for people and listings; the log is the authority."""

from __future__ import annotations

import json
from pathlib import Path

from verbteach_sessions.errors import NotASessionError
from verbteach_sessions.files import open_regular, replace_file
from verbteach_sessions.lines import MAX_LINE, Event, LineError, parse
from verbteach_sessions.upcasting import STEPS, VERSION, upcast

HEADER_NAME = "header.json"
HEADER = "header"


def header_bytes(header: Event) -> bytes:
    """What the file should hold."""
    value = {"v": VERSION, **header.data}
    return json.dumps(value, indent=2, allow_nan=False).encode() + b"\n"


def write_header(folder: Path, header: Event) -> None:
    """Write the file as a whole or not at all. Raises :class:`StorageError`."""
    replace_file(folder / HEADER_NAME, header_bytes(header))


def header_fits(folder: Path, header: Event) -> bool:
    """Whether the file is there and says what the log says, be it in an earlier version."""
    try:
        with open_regular(folder / HEADER_NAME) as file:
            value = parse(file.read(2 * MAX_LINE))
    except (NotASessionError, LineError):
        return False
    if not isinstance(value, dict):
        return False
    version = value.pop("v", None)
    known = type(version) is int and (version == VERSION or version in STEPS)
    return known and upcast(version, HEADER, value) == header.data
