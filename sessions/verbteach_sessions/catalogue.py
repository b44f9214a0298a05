"""The sessions in a folder, in short: what the two ends of each log say, so that listing is quick.

Of the lines between it asks only whether they are those that were written.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

from verbteach_sessions import events as kinds
from verbteach_sessions.chain import hangs_together
from verbteach_sessions.errors import LogError, NotASessionError, UnsafeNameError
from verbteach_sessions.eventlog import LOG_NAME, LogReader
from verbteach_sessions.files import open_regular
from verbteach_sessions.lines import MAX_LINE, LineError, parse
from verbteach_sessions.lock import in_use
from verbteach_sessions.names import safe_name
from verbteach_sessions.places import at_home, data_folder
from verbteach_sessions.upcasting import VERSION

SESSIONS_VARIABLE = "VERBTEACH_SESSIONS"
_TAIL = 256 * 1024


@dataclass(frozen=True)
class Entry:
    """One session. ``problem`` says why it cannot be resumed, and is empty where it can.

    ``advice`` says what to do where the problem is a damaged log.
    ``created`` is ISO 8601 in UTC. What could not be read is empty or 0.
    """

    path: Path
    id: str
    created: str = ""
    scene: str = ""
    participant: str | None = None
    episodes: int = 0
    verbs_learned: tuple[str, ...] = ()
    ended: bool = False
    problem: str = ""
    advice: str = ""

    @property
    def resumable(self) -> bool:
        """Whether the session can be opened for writing, as far as a glance can tell."""
        return not self.problem

    def to_json(self) -> dict[str, Any]:
        """The fields, the path as text."""
        fields = {**vars(self), "path": str(self.path), "verbs_learned": list(self.verbs_learned)}
        return {**fields, "resumable": self.resumable}


def default_folder() -> Path:
    """Where sessions go unless another folder is named; it need not exist yet.

    ``VERBTEACH_SESSIONS`` where it is set, else in :func:`data_folder`. Raises
    ``NoHomeError``.
    """
    named = os.environ.get(SESSIONS_VARIABLE)
    if named:
        with at_home():
            return Path(named).expanduser()
    return data_folder() / "sessions"


def list_sessions(folder: Path) -> tuple[Entry, ...]:
    """The sessions in ``folder``, the newest first; none where there is no such folder."""
    entries = [entry(path) for path in session_folders(folder)]
    return tuple(sorted(entries, key=lambda one: (one.created, one.id), reverse=True))


def session_folders(folder: Path) -> tuple[Path, ...]:
    """The sessions' folders in ``folder``, and in those of a study's participants, sorted."""
    inner = [path for path in _within(folder) if path.is_dir()]
    homes = [path for path in inner if not path.is_symlink() and not _has_log(path)]
    found = (*inner, *(path for home in homes for path in _within(home)))
    return tuple(sorted(path for path in found if _has_log(path)))


def _within(folder: Path) -> tuple[Path, ...]:
    """What is in a folder; nothing of one that may not be looked into, as `lost+found`."""
    try:
        return tuple(folder.iterdir())
    except OSError:
        return ()


def _has_log(path: Path) -> bool:
    try:
        return (path / LOG_NAME).exists()
    except OSError:
        return False


def entry(path: Path) -> Entry:
    """The session in the folder ``path``; whatever is wrong with it is in ``problem``."""
    try:
        with open_regular(path / LOG_NAME) as log:
            header = _header(log)
            last = _tail(log)
            problem, advice = _damage(path, log)
    except (NotASessionError, LineError) as error:
        return Entry(path, path.name, problem=str(error))
    after, ended = _standing(last)
    totals, verbs = _object(after.get("totals")), after.get("verbs_learned")
    episodes = totals.get("episodes")
    participant = header.get("participant")
    return Entry(
        path,
        path.name,
        created=_text(header.get("created")),
        scene=_text(after.get("scene")) or _text(header.get("scene")),
        participant=participant if isinstance(participant, str) else None,
        episodes=episodes if isinstance(episodes, int) else 0,
        verbs_learned=tuple(str(v) for v in verbs) if isinstance(verbs, list) else (),
        ended=ended,
        problem="it is open in another place" if in_use(path) else problem,
        advice=advice,
    )


def _damage(path: Path, log: BinaryIO) -> tuple[str, str]:
    """What is wrong with a log that has a beginning, and what to do; nothing where it is whole."""
    log.seek(0)
    if hangs_together(log):
        return "", ""
    try:
        for _ in LogReader(path):
            pass
    except LogError as error:
        return f"line {error.line} {error.problem}", error.advice
    except NotASessionError as error:
        return str(error), ""
    return "", ""


def find_session(folder: Path, name: str) -> Path:
    """The folder of the session called ``name``. Raises ``UnsafeNameError``, ``NotASessionError``.

    A name cannot lead out of ``folder``: no separators, no dots, no links.
    """
    path = folder / safe_name(name)
    if path.is_symlink():
        raise UnsafeNameError(f"{path}: is a link, not a session's folder")
    if not (path / LOG_NAME).is_file():
        raise NotASessionError(f"{path}: holds no {LOG_NAME}")
    return path


def _header(log: BinaryIO) -> Mapping[str, Any]:
    first = log.readline(MAX_LINE)
    if not first:
        raise LineError("nothing was said in this session")
    event = _event(first)
    if event.get("type") != kinds.HEADER:
        raise LineError("its first line is no header")
    return _object(event.get("data"))


def _tail(log: BinaryIO) -> Sequence[Mapping[str, Any]]:
    """The last events, the last one first, back to one that says what held after it.

    A line that is torn or broken is passed over.
    """
    size = log.seek(0, os.SEEK_END)
    found: list[Mapping[str, Any]] = []
    for length in (_TAIL, MAX_LINE + _TAIL):
        log.seek(max(0, size - length))
        found = []
        for raw in reversed(log.read().split(b"\n")):
            found.append(_lenient(raw))
            if isinstance(_object(found[-1].get("data")).get("after"), dict):
                return found
    return found


def _standing(events: Iterable[Mapping[str, Any]]) -> tuple[Mapping[str, Any], bool]:
    """The last event's word on the state that holds, and whether the session has ended."""
    ended = False
    reopened = False
    for event in events:
        reopened = reopened or event.get("type") == kinds.RESUME
        ended = ended or (event.get("type") == kinds.END and not reopened)
        after = _object(event.get("data")).get("after")
        if isinstance(after, dict):
            return after, ended
    return {}, ended


def _event(raw: bytes) -> Mapping[str, Any]:
    event = _object(parse(raw))
    version = event.get("v")
    if isinstance(version, int) and version > VERSION:
        raise LineError(f"is of version {version}; this program reads up to {VERSION}")
    return event


def _lenient(raw: bytes) -> Mapping[str, Any]:
    try:
        return _event(raw)
    except LineError:
        return {}


def _object(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}


def _text(value: Any) -> str:
    return value if isinstance(value, str) else ""
