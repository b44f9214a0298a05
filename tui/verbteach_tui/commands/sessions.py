"""`verbteach sessions`: the records there are, one of them in short, and whether they are sound."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from verbteach_tui.commands.parameters import (
    JsonFlag,
    ScenesFolder,
    SessionArgument,
    SessionsFolder,
)
from verbteach_tui.commands.session_names import session_completions, session_path
from verbteach_tui.commands.streams import columns, counting, emit, note, progress, tell
from verbteach_tui.conclusion import CHECK_FAILED, WrongUseError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from verbteach_sessions.catalogue import Entry
    from verbteach_sessions.validate import Finding, Validation


def list_sessions(sessions: SessionsFolder = None, as_json: JsonFlag = False) -> None:
    """List the sessions in a folder, the newest first.

    Each log is checked for lines that were changed or lost; what to do stands below the list.
    """
    from verbteach_sessions import catalogue

    folder = sessions or catalogue.default_folder()
    if sessions is not None and not folder.is_dir():
        raise WrongUseError(f"{folder}: there is no such folder")
    entries = catalogue.list_sessions(folder)
    if as_json:
        emit({"folder": str(folder), "sessions": [entry.to_json() for entry in entries]})
    elif entries:
        tell(columns([("SESSION", "SCENE", "EPISODES", "VERBS", "STATE"), *map(_row, entries)]))
        _tell_problems([entry for entry in entries if entry.problem])
    else:
        note(f"no session in {folder}")


def _row(entry: Entry) -> tuple[object, ...]:
    return entry.id, entry.scene, entry.episodes, _few(entry.verbs_learned), _state(entry)


def _state(entry: Entry) -> str:
    if entry.problem:
        return "DAMAGED" if entry.advice else "not usable now"
    return "left" if entry.ended else "open"


def _tell_problems(entries: Sequence[Entry]) -> None:
    """Below the list, so that what is wrong and what to do can be read whole."""
    for entry in entries:
        tell()
        tell(f"{entry.id}: {entry.problem}" + (f"; {entry.advice}" if entry.advice else ""))


def _few(verbs: Sequence[str], most: int = 5) -> str:
    """The verbs, as many as there is room for in a line."""
    more = len(verbs) - most
    return ", ".join(verbs[:most]) + (f" and {more} more" if more > 0 else "")


def show_session(session: SessionArgument, as_json: JsonFlag = False) -> None:
    """Show a session: what it began with, what was said and still holds, what came of it."""
    from verbteach_tui.record import read_record

    record = read_record(session)
    for warning in record.warnings:
        note(f"warning: {warning}")
    if as_json:
        emit(record.to_json())
        return
    tell(columns([(name, _shown(value)) for name, value in record.facts.items()]))
    tell()
    for line in record.lines:
        tell(f"{line.seq:5}  {line.speaker.capitalize()}: {line.text}")


def _shown(value: object) -> object:
    if isinstance(value, list):
        return ", ".join(map(str, value))
    return "" if value is None else value


def validate(
    path: Annotated[
        Path,
        typer.Argument(
            metavar="SESSION|FOLDER",
            parser=session_path,
            autocompletion=session_completions,
            help="A session, or a folder of them.",
        ),
    ],
    scenes: ScenesFolder = None,
    as_json: JsonFlag = False,
) -> None:
    """Hold sessions against every rule; nothing is written.

    A torn last line is a warning; anything else that is wrong gives status 1.
    """
    from verbteach_scenarios.nlp.second_opinion import if_installed
    from verbteach_scenarios.settings import make_settings
    from verbteach_sessions.validate import validate as examine
    from verbteach_tui.record import count_events

    paths, settings = _records(path), make_settings(scenes, if_installed())
    found: list[tuple[Path, Validation]] = []
    with progress() as show:
        for done, one in enumerate(paths, start=1):
            heard = counting(show, "events", count_events(one))
            found.append((one, examine(one, settings, heard)))
            show("sessions", done, len(paths))
    if as_json:
        emit(_document(path, found))
    else:
        _print(found)
    if any(not validation.valid for _, validation in found):
        raise typer.Exit(CHECK_FAILED)


def _records(path: Path) -> Sequence[Path]:
    """The session at ``path``, or those in the folder ``path``, sorted by name."""
    from verbteach_sessions.catalogue import session_folders
    from verbteach_sessions.eventlog import LOG_NAME

    if not path.exists():
        raise WrongUseError(f"{path}: there is no such session or folder")
    if path.is_file() or (path / LOG_NAME).exists():
        return (path,)
    found = session_folders(path)
    if not found:
        raise WrongUseError(f"{path}: holds no session")
    return found


def _document(path: Path, found: Sequence[tuple[Path, Validation]]) -> dict[str, Any]:
    """One session's findings, or a folder's with the session each belongs to."""
    if len(found) == 1 and found[0][0] == path:
        return found[0][1].to_json()
    each = [{"session": str(one), **validation.to_json()} for one, validation in found]
    return {
        "valid": all(one["valid"] for one in each),
        "problems": _gathered(each, "problems"),
        "warnings": _gathered(each, "warnings"),
        "sessions": each,
    }


def _gathered(each: Sequence[dict[str, Any]], kind: str) -> list[dict[str, Any]]:
    return [{"session": one["session"], **finding} for one in each for finding in one[kind]]


def _print(found: Sequence[tuple[Path, Validation]]) -> None:
    for path, validation in found:
        tell(f"{path}: {'valid' if validation.valid else 'NOT VALID'}")
        for finding in validation.problems:
            tell(f"  problem: {_said(finding)}")
        for finding in validation.warnings:
            tell(f"  warning: {_said(finding)}")


def _said(finding: Finding) -> str:
    place = "" if finding.seq is None else f" (event {finding.seq})"
    return f"{finding.rule}{place}: {finding.message}"
