"""`verbteach sessions branch`: go on from any turn of a session, in a session of its own."""

from __future__ import annotations

from typing import Annotated

import typer

from verbteach_tui.commands.parameters import JsonFlag, SessionArgument, SessionsFolder
from verbteach_tui.commands.streams import counting, emit, progress, tell


def branch(
    session: SessionArgument,
    at: Annotated[
        int | None,
        typer.Option("--at", min=0, metavar="SEQ", help="The last event to share (the last one)."),
    ] = None,
    sessions: SessionsFolder = None,
    as_json: JsonFlag = False,
) -> None:
    """Make a session that begins as another did, up to an event; that one stays as it is.

    It is put beside the other unless a folder is named. To go on with it, teach
    with --resume.
    """
    from verbteach_sessions.branching import branch as make_branch
    from verbteach_sessions.eventlog import log_path
    from verbteach_tui.record import count_events

    folder = log_path(session).resolve().parent.parent if sessions is None else sessions
    with progress() as show:
        heard = counting(show, "events", count_events(session))
        made = make_branch(session, folder, at, heard=heard)
    if as_json:
        parent = {"id": made.parent.id, "seq": made.parent.seq, "hash": made.parent.hash}
        emit({
            "session": str(made.path),
            "parent": parent,
            "events": made.parent.seq + 1,
            "content_hash": made.content_hash,
        })  # fmt: skip
        return
    tell(f"{made.path}: shares {made.parent.seq + 1} events with {made.parent.id}")
    tell(f"to go on with it: verbteach teach --resume {made.path}")
