"""From sessions to a fitted user, and the file that keeps it."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from verbteach.dialogue.setting import Settings
from verbteach_sessions.corpus.register import Contribution, register
from verbteach_sessions.files import open_regular, replace_file
from verbteach_sessions.lines import LineError, parse
from verbteach_sessions.people.fitted_user import FORMAT, FittedUser, FittedUserError
from verbteach_sessions.people.golds import LessonBook
from verbteach_sessions.people.observations import Observed, observe
from verbteach_sessions.people.recorded import Recorded, read_recorded

MAX_FILE = 64 * 1024 * 1024
"""Bytes: thousands of people fit in it."""


@dataclass(frozen=True)
class Material:
    """Sessions that were read, where they are, and every answer in them."""

    paths: tuple[Path, ...]
    records: tuple[Recorded, ...]
    observed: tuple[Observed, ...]

    def user(self) -> FittedUser:
        """The user fitted to all of it. Raises :class:`FittedUserError` where there is nothing."""
        sessions = ((one.header.id, one.content_hash) for one in self.records)
        return FittedUser.of(self.observed, sessions)

    def note(self, kind: str, out: Path) -> None:
        """Enter what is made of it in the register of exports, so that a withdrawal lists it.

        Raises ``StorageError``.
        """
        headers = (record.header for record in self.records)
        register(
            kind,
            out,
            (
                Contribution(path, header.participant, header.teacher)
                for path, header in zip(self.paths, headers, strict=True)
            ),
        )


def gather(
    paths: Sequence[Path],
    book: LessonBook,
    settings: Settings,
    heard: Callable[[int, int], None] | None = None,
) -> Material:
    """Read sessions. ``heard`` is told how many are read, and of how many.

    Raises the errors of reading a log, and ``UnknownSceneError``.
    """
    records: list[Recorded] = []
    observed: list[Observed] = []
    for done, path in enumerate(paths, start=1):
        record = read_recorded(path, settings)
        records.append(record)
        observed += observe(record, book, settings)
        if heard is not None:
            heard(done, len(paths))
    return Material(tuple(paths), tuple(records), tuple(observed))


def save_user(path: Path, user: FittedUser) -> None:
    """Write the file, whole or not at all. Raises ``StorageError``."""
    replace_file(path, json.dumps(user.to_json(), indent=1, allow_nan=False).encode() + b"\n")


def load_user(path: Path) -> FittedUser:
    """Read what :func:`save_user` wrote. Raises ``FittedUserError``, ``NotASessionError``."""
    with open_regular(path) as file:
        raw = file.read(MAX_FILE + 1)
    if len(raw) > MAX_FILE:
        raise FittedUserError(f"{path}: is larger than {MAX_FILE} bytes, too large a fitted user")
    try:
        return FittedUser.from_json(parse(raw))
    except LineError as error:
        raise FittedUserError(f"{path}: {error}") from error
    except FittedUserError as error:
        raise FittedUserError(f"{path}: {error}") from error


def is_user(path: Path) -> bool:
    """Whether a file says that it is a fitted user; its beginning tells."""
    if not path.is_file():
        return False
    with open_regular(path) as file:
        head = file.read(200)
    return head.lstrip().startswith(b"{") and FORMAT.encode() in head
