"""A person's withdrawal: their records are deleted, and the exports they were in are listed."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from verbteach_sessions.catalogue import entry
from verbteach_sessions.corpus.folder import append_lines, read_lines
from verbteach_sessions.corpus.redactions import REDACTIONS_NAME
from verbteach_sessions.corpus.register import Entry, exports_of
from verbteach_sessions.errors import NotASessionError, SessionInUseError, StorageError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.files import open_regular, replace_file
from verbteach_sessions.header_file import HEADER_NAME
from verbteach_sessions.lines import MAX_LINE
from verbteach_sessions.lock import in_use
from verbteach_sessions.names import Now, safe_name, utc_now

WITHDRAWN_NAME = "withdrawn.jsonl"


@dataclass(frozen=True)
class Withdrawal:
    """What there is of a person in a folder.

    ``home`` is their own folder in a study. ``others`` began with what this
    person had taught and hold it still.
    """

    participant: str
    folder: Path
    sessions: tuple[Path, ...]
    home: Path | None
    exports: tuple[Entry, ...]
    others: tuple[Path, ...]

    def to_json(self) -> dict[str, Any]:
        """What ``sessions withdraw --json`` prints, apart from whether it was done."""
        return {
            "participant": self.participant,
            "sessions": [str(path) for path in self.sessions],
            "exports": [asdict(one) for one in self.exports],
            "others": [str(path) for path in self.others],
        }


def find(folder: Path, code: str) -> Withdrawal:
    """What there is of the person ``code`` in ``folder``; nothing is changed.

    Raises ``UnsafeNameError``, :class:`NotASessionError` where nothing is there,
    and ``LogError`` on a register that cannot be read.
    """
    safe_name(code, "participant code")
    if not folder.is_dir():
        raise NotASessionError(f"{folder}: there is no such folder")
    every = list(_kept(folder))
    own = tuple(path for path in every if _participant(path) == code)
    home = folder / code
    home_there = home.is_dir() and not home.is_symlink() and not (home / LOG_NAME).exists()
    exports = exports_of(folder, code)
    if not own and not exports and not home_there:
        raise NotASessionError(f"{folder}: holds nothing of a participant {code}")
    names = {path.name for path in own}
    others = tuple(path for path in every if path not in own and names & _kin(path))
    return Withdrawal(code, folder, own, home if home_there else None, exports, others)


def carry_out(withdrawal: Withdrawal, now: Now = utc_now) -> None:
    """Delete the person's records, and what the redaction log holds of them.

    What was interrupted can be done again. Raises ``SessionInUseError`` before
    anything is deleted, and ``StorageError``.
    """
    for path in withdrawal.sessions:
        if in_use(path):
            raise SessionInUseError(f"{path}: the session is open in another place; close it there")
    folder, code = withdrawal.folder, withdrawal.participant
    at = now().isoformat(timespec="seconds")
    append_lines(folder / WITHDRAWN_NAME, [{"participant": code, "at": at}])
    _forget(folder, {path.name for path in withdrawal.sessions})
    for path in withdrawal.sessions:
        _delete(path)
    if withdrawal.home is not None:
        _remove(withdrawal.home)


def withdrawn(folder: Path) -> frozenset[str]:
    """The codes of those who withdrew from ``folder``. Raises ``LogError``."""
    lines = read_lines(folder / WITHDRAWN_NAME)
    return frozenset(str(line.get("participant")) for line in lines)


def _kept(folder: Path) -> Iterator[Path]:
    """Folders of sessions, and what an interrupted deletion left of one; no links."""
    for one in sorted(folder.iterdir()):
        if one.is_symlink() or not one.is_dir():
            continue
        if _is_session(one):
            yield one
        else:
            inner = sorted(one.iterdir())
            yield from (two for two in inner if not two.is_symlink() and _is_session(two))


def _is_session(path: Path) -> bool:
    return (path / LOG_NAME).is_file() or (path / HEADER_NAME).is_file()


def _participant(path: Path) -> str | None:
    """The code in the record, else in the header beside it."""
    known = entry(path).participant
    return known if known is not None else _header(path).get("participant")


def _kin(path: Path) -> set[str]:
    """The sessions that this one goes on from or branched from."""
    header = _header(path)
    found = (header.get(name) for name in ("source", "parent"))
    return {str(one.get("id")) for one in found if isinstance(one, dict)}


def _header(path: Path) -> dict[str, Any]:
    try:
        with open_regular(path / HEADER_NAME) as file:
            value = json.loads(file.read(MAX_LINE))
    except (NotASessionError, ValueError, RecursionError):
        return {}
    return value if isinstance(value, dict) else {}


def _forget(folder: Path, sessions: set[str]) -> None:
    """Drop decisions about these sessions: the log quotes what the person wrote."""
    path = folder / REDACTIONS_NAME
    lines = list(read_lines(path))
    left = [line for line in lines if line.get("session") not in sessions]
    if len(left) < len(lines):
        replace_file(path, b"".join(json.dumps(line).encode() + b"\n" for line in left))


def _delete(path: Path) -> None:
    """The record goes first, the header, by which a rest is known, last."""
    try:
        (path / LOG_NAME).unlink(missing_ok=True)
        for inner in sorted(path.iterdir()):
            if inner.name != HEADER_NAME:
                _remove(inner)
    except OSError as error:
        raise StorageError(path, error) from error
    _remove(path)


def _remove(path: Path) -> None:
    try:
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
            path.unlink()
    except OSError as error:
        raise StorageError(path, error) from error
