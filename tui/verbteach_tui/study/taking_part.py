"""`verbteach teach --study`: taking part, on the screen or in plain lines."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from verbteach_tui.beginning import Beginning

if TYPE_CHECKING:
    from verbteach_tui.study.run import StudyRun


def ways(
    beginning: Beginning, file: Path, theme: str | None, out: TextIO
) -> Mapping[str, Callable[[], int]]:
    """How a participant can be led, by interface; each answers the exit status.

    They raise what reading the study's file and coming back raise.
    """
    return {
        "app": lambda: _on_screen(_run(beginning, file), theme, out),
        "browser": lambda: _on_screen(_run(beginning, file), theme, out),
        "plain": lambda: _plainly(_run(beginning, file), out),
    }


def _run(beginning: Beginning, file: Path) -> StudyRun:
    from verbteach_tui.study.run import StudyRun
    from verbteach_tui.web.visits import ticket_here

    run = StudyRun.open(file, replace(beginning, participant=None), beginning.participant)
    ticket = ticket_here()
    if ticket is not None:
        run.consented = ticket.write
    return run


def _on_screen(run: StudyRun, theme: str | None, out: TextIO) -> int:
    from verbteach_tui.options import OpenNew
    from verbteach_tui.plain import as_rows
    from verbteach_tui.room import app_options
    from verbteach_tui.study.app import StudyApp

    options = app_options(run.beginning, OpenNew(""), theme)
    app = StudyApp(replace(options, create=lambda scene: run.open_session()), run)
    try:
        app.run()
    finally:
        app.close_sessions()
        run.close()
    if app.failure is not None:
        raise app.failure
    if run.beginning.interface != "browser":  # there standard output belongs to the screen
        for line in app.farewell or _farewell(run):
            print(as_rows(line) if out.isatty() else line, file=out)
    return app.return_code or os.EX_OK


def _farewell(run: StudyRun) -> tuple[str, ...]:
    """What is said to one who left on the way, by whatever key."""
    from verbteach_tui.study import words

    return (words.REFUSED,) if run.visit is None else words.paused(run.code, run.way_back)


def _plainly(run: StudyRun, out: TextIO) -> int:
    from verbteach_tui.plain import lead
    from verbteach_tui.study.plain_study import StudyTalk

    talk = StudyTalk(run)
    try:
        return lead(talk, output=out, note="", patient=True)
    finally:
        talk.close()
