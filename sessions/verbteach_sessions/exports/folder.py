"""The folder an export goes to: complete or not there at all, and never in another one's place."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from verbteach_sessions.errors import StorageError
from verbteach_sessions.exports.errors import ExportError

MANIFEST = "export.json"


class OutputExistsError(ExportError):
    """Where the export should go there is something already."""


@contextmanager
def new_folder(out: Path, *, force: bool = False) -> Iterator[Path]:
    """A folder to fill, which takes its place as ``out`` when the block ends well.

    Until then nothing stands there; if the block fails nothing is left. With
    ``force`` an earlier export is replaced, but nothing else: a folder counts
    as one by its ``export.json``. Raises :class:`OutputExistsError`, ``StorageError``.
    """
    _check(out, force)
    draft = out.absolute().parent / f".{out.name}.{os.getpid()}.new"
    try:
        draft.mkdir(parents=True)
        yield draft
        _take_place(draft, out)
    except OSError as error:
        raise StorageError(Path(error.filename or out), error) from error
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def write_manifest(folder: Path, about: Mapping[str, Any]) -> None:
    """Say what the export holds, in the file by which it is known as one."""
    write_json(folder / MANIFEST, about)


def write_json(path: Path, value: Any) -> None:
    """Write a JSON document for people to look at as well."""
    path.parent.mkdir(parents=True, exist_ok=True)
    text = json.dumps(value, ensure_ascii=False, indent=2, allow_nan=False)
    path.write_text(text + "\n", encoding="utf-8")


def write_text(path: Path, text: str) -> None:
    """Write text as UTF-8 with plain line ends."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", newline="\n")


def _check(out: Path, force: bool) -> None:
    if out.is_symlink() or (out.exists() and not out.is_dir()):
        raise OutputExistsError(f"{out}: is no folder; name one that is not there yet")
    if not out.exists() or not any(out.iterdir()):
        return
    if not force:
        raise OutputExistsError(
            f"{out}: is there already; name another folder, or --force to replace an export"
        )
    if not (out / MANIFEST).is_file():
        raise OutputExistsError(
            f"{out}: holds no {MANIFEST}, so it is no export and is not replaced;"
            " name another folder"
        )


def _take_place(draft: Path, out: Path) -> None:
    if not out.exists():
        draft.rename(out)
        return
    old = draft.with_suffix(".old")
    out.rename(old)
    try:
        draft.rename(out)
    except OSError:
        old.rename(out)
        raise
    shutil.rmtree(old)
