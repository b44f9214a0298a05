"""Taking a participant in: a place that nobody else has, and the first line of the record.

Nothing is written before the consent. The place is the first that is free, so
that one who withdraws makes room for another and the conditions stay balanced;
a lock keeps two who come at once from getting the same one.
"""

from __future__ import annotations

import fcntl
import os
import shutil
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from datetime import datetime
from pathlib import Path
from typing import Any

from verbteach_sessions.errors import SessionError
from verbteach_sessions.eventlog import Draft, EventLog
from verbteach_sessions.files import FOLDER_MODE, make_private_folder, open_private, replace_file
from verbteach_sessions.names import Random, safe_name
from verbteach_sessions.study import visit_events as kinds
from verbteach_sessions.study.counterbalance import order_of
from verbteach_sessions.study.design import Study
from verbteach_sessions.study.errors import VisitError
from verbteach_sessions.study.progress import VISIT_NAME, Progress
from verbteach_sessions.study.weights_beside import copy_of_weights

_LOCK_NAME = "enrolment.lock"


def has_enrolled(folder: Path, code: str) -> bool:
    """Whether the participant ``code`` has consented before. Raises ``UnsafeNameError``."""
    return (folder / safe_name(code, "participant code") / VISIT_NAME).is_file()


def enrol(
    folder: Path,
    study: Study,
    source: bytes,
    code: str,
    interface: str,
    now: datetime,
) -> tuple[EventLog, Progress]:
    """Write down that ``code`` has consented to ``study``; the record, open, and what it says.

    ``source`` is the study's file: a copy stays in ``folder``, and copies of the
    weights that it names, so that a later change of a file changes nothing for
    those who have begun. Raises
    ``UnsafeNameError``, ``VisitError`` and ``StorageError``.
    """
    home = folder / safe_name(code, "participant code")
    with _alone(folder), ExitStack() as undoing:
        if home.exists():
            raise VisitError(f"{home}: there is a participant of this code already")
        _keep_copy(folder, study, source)
        slot = _free_slot(folder)
        make_private_folder(home)
        undoing.callback(shutil.rmtree, home, ignore_errors=True)
        log = EventLog.create(home, VISIT_NAME)
        undoing.callback(log.close)
        data = {
            "study": study.id,
            "study_hash": study.file_hash,
            "participant": code,
            "slot": slot,
            "order": list(order_of(study, slot)),
            **_weights(study),
            "consent": {"answer": kinds.YES, "text": study.consent_hash},
            "created": now.isoformat(timespec="seconds"),
            "interface": interface,
        }
        progress = Progress()
        for event in log.append([Draft(kinds.ENROLLED, 0.0, data)]):
            progress.take(event)
        undoing.pop_all()
    return log, progress


def visits(folder: Path) -> Iterator[tuple[Path, Progress | SessionError]]:
    """The participants in a study's folder by their codes; the error where one cannot be read."""
    try:
        homes = sorted(home for home in folder.iterdir() if (home / VISIT_NAME).is_file())
    except OSError:
        return
    for home in homes:
        try:
            yield home, Progress.read(home)
        except SessionError as error:
            yield home, error


def copy_of(folder: Path, study_hash: str) -> Path:
    """Where the copy of the study's file with this hash lies."""
    return folder / f"study-{study_hash[:16]}.toml"


def new_completion_code(random: Random) -> str:
    """A code that shows that the thanks were reached, and says nothing else."""
    return "-".join(random(3).hex().upper() for _ in range(2))


def _free_slot(folder: Path) -> int:
    taken = set()
    for home, found in visits(folder):
        if isinstance(found, SessionError):
            raise VisitError(f"{home}: nobody can be taken in before this is mended: {found}")
        taken.add(found.slot)
    return next(slot for slot in range(len(taken) + 1) if slot not in taken)


def _weights(study: Study) -> dict[str, Any]:
    """The weights that conditions begin with, for the record."""
    named = [[one.id, one.weights_hash] for one in study.conditions if one.weights_hash]
    return {"weights": named} if named else {}


def _keep_copy(folder: Path, study: Study, source: bytes) -> None:
    copies = {copy_of(folder, study.file_hash): source}
    for weights_hash, raw in study.attached.items():
        copies[copy_of_weights(folder, weights_hash)] = raw
    for copy, raw in copies.items():
        if not copy.exists():
            replace_file(copy, raw)


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Wait until nobody else is being taken in, and keep others waiting meanwhile."""
    folder.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
    fd = open_private(folder / _LOCK_NAME, os.O_RDWR | os.O_CREAT)
    try:
        fcntl.flock(fd, fcntl.LOCK_EX)
        yield
    finally:
        os.close(fd)
