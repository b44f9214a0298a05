"""`verbteach sessions export`: sessions in the formats of other people's tools."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from verbteach_tui.commands.parameters import JsonFlag, ScenesFolder
from verbteach_tui.commands.session_names import session_completions, session_path
from verbteach_tui.commands.streams import columns, counting, emit, note, progress, tell

if TYPE_CHECKING:
    from collections.abc import Mapping

    from verbteach.dialogue.setting import Settings
    from verbteach_sessions.exports.exporting import Exported, Request
    from verbteach_sessions.exports.sight import Depict

FormatName = Literal[
    "jsonl",
    "convokit",
    "convlab",
    "parlai",
    "minari",
    "parquet",
    "csv",
    "html",
    "markdown",
    "asciicast",
    "svg",
]
Paths = Annotated[
    list[Path],
    typer.Argument(
        metavar="PATH",
        parser=session_path,
        autocompletion=session_completions,
        help="Sessions, or folders of sessions.",
    ),
]


def export(
    paths: Paths,
    to: Annotated[FormatName, typer.Option("--to", help="The format.")],
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="A new folder for it.")],
    force: Annotated[
        bool, typer.Option("--force", help="Replace an export that is there already.")
    ] = False,
    splits: Annotated[
        Path | None,
        typer.Option("--splits", metavar="FILE", help="Parts made by 'sessions split'."),
    ] = None,
    skip_damaged: Annotated[
        bool,
        typer.Option("--skip-damaged", help="Leave out sessions that cannot be read, and say so."),
    ] = False,
    scenes: ScenesFolder = None,
    as_json: JsonFlag = False,
) -> None:
    """Export sessions, in relative times only and with what was redacted left out."""
    from verbteach_sessions.corpus.folder import sessions_at
    from verbteach_sessions.exports.exporting import Request
    from verbteach_sessions.exports.exporting import export as make

    found = sessions_at(paths)
    settings, depict = _sights(to, scenes)
    request = Request(found, to, out, force, _parts(splits), settings, depict, skip_damaged)
    with progress() as show:
        exported = make(request, counting(show, "sessions", len(found)))
    for warning in exported.warnings:
        note(f"warning: {warning}")
    for one in exported.left_out:
        note(f"left out: {one.session}: {one.reason}")
    if as_json:
        emit(exported.to_json())
    else:
        _print(exported, request)


def _parts(path: Path | None) -> Mapping[str, str]:
    if path is None:
        return {}
    from verbteach_sessions.corpus.splits import read_splits

    return read_splits(path)


def _sights(to: str, scenes: Path | None) -> tuple[Settings | None, Depict | None]:
    """What pages need to show scenes; nothing is loaded for the other formats."""
    if to != "html":
        return None, None
    from verbteach_scenarios.settings import make_settings
    from verbteach_tui.views.sight import make_depict

    return make_settings(scenes), make_depict()


def _print(exported: Exported, request: Request) -> None:
    rows: list[tuple[str, object]] = [
        ("sessions", exported.sessions),
        ("left out", len(exported.left_out)),
        ("turns", exported.turns),
        ("people", len(exported.participants)),
        ("redacted", exported.redacted),
        ("files", len(exported.files)),
        ("in", request.out),
    ]
    tell(columns(rows))
