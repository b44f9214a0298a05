"""Which sessions a command speaks of, and the small files that are kept beside them."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from verbteach_sessions.errors import LogError, NotASessionError, StorageError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.files import open_private, open_regular, write_all
from verbteach_sessions.study.progress import VISIT_NAME

MAX_LINE = 1024 * 1024


def sessions_at(paths: Iterable[Path]) -> tuple[Path, ...]:
    """The folders of the sessions at each path: a session, its log, or a folder of sessions.

    Sorted by name within a folder, each once. Raises :class:`NotASessionError`.
    """
    found: dict[Path, Path] = {}
    for path in paths:
        for one in _sessions(path):
            found.setdefault(one.resolve(), one)
    return tuple(found.values())


def corpus_of(session: Path) -> Path:
    """The folder in which things are kept beside a session: the one it is in, or its study's."""
    home = session.absolute().parent
    return home.parent if (home / VISIT_NAME).is_file() else home


def _sessions(path: Path) -> list[Path]:
    if path.is_file() and path.name == LOG_NAME:
        return [path.parent]
    if (path / LOG_NAME).is_file():
        return [path]
    if not path.is_dir():
        raise NotASessionError(f"{path}: there is no such session or folder of sessions")
    inner = sorted(_below(path))
    if not inner:
        raise NotASessionError(f"{path}: holds no session")
    return inner


def _below(folder: Path) -> Iterator[Path]:
    """Sessions in the folder and in the participants' folders of a study; links are passed over."""
    for one in folder.iterdir():
        if one.is_symlink() or not one.is_dir() or one.name.startswith("."):
            continue
        if (one / LOG_NAME).is_file():
            yield one
        else:
            yield from (two for two in one.iterdir() if (two / LOG_NAME).is_file())


def append_lines(path: Path, values: Iterable[Mapping[str, Any]]) -> None:
    """Add JSON lines to a private file beside the sessions; they are on the disk on return.

    Raises :class:`StorageError`.
    """
    block = b"".join(json.dumps(value).encode() + b"\n" for value in values)
    if not block:
        return
    fd = open_private(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    try:
        write_all(fd, block)
        os.fsync(fd)
    except OSError as error:
        raise StorageError(path, error) from error
    finally:
        os.close(fd)


def read_lines(path: Path) -> Iterator[dict[str, Any]]:
    """The objects of a file of JSON lines; none where there is no such file.

    Raises :class:`LogError` with the line that is none.
    """
    if not path.exists():
        return
    with open_regular(path) as file:
        number = 0
        while raw := file.readline(MAX_LINE):
            number += 1
            yield _object(path, number, raw)


def _object(path: Path, number: int, raw: bytes) -> dict[str, Any]:
    try:
        value = json.loads(raw)
    except (ValueError, RecursionError) as error:
        raise LogError(path, number, "is not JSON", "correct the line or remove it") from error
    if not isinstance(value, dict):
        raise LogError(path, number, "is no object", "correct the line or remove it")
    return value
