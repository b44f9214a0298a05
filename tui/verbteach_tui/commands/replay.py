"""`verbteach replay`: a record told again, or recomputed and compared."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Annotated

import typer

from verbteach_tui.commands.parameters import JsonFlag, ScenesFolder, SessionArgument
from verbteach_tui.commands.streams import counting, emit, note, progress, tell
from verbteach_tui.conclusion import CHECK_FAILED, WrongUseError
from verbteach_tui.terminal import has_terminal

LONGEST = 300  # characters of a differing value


def replay(
    session: SessionArgument,
    verify: Annotated[
        bool, typer.Option("--verify", help="Recompute everything and compare it with the record.")
    ] = False,
    to: Annotated[
        int | None,
        typer.Option(
            "--to",
            min=0,
            metavar="SEQ",
            help="In lines stop after this event, on the screen begin at it.",
        ),
    ] = None,
    speed: Annotated[
        float,
        typer.Option(
            min=0.0,
            metavar="X",
            help="As lines 1 is as it was, 0 at once; on the screen turns a second.",
        ),
    ] = 0.0,
    plain: Annotated[bool, typer.Option("--plain", help="As lines, also in a terminal.")] = False,
    policy: Annotated[
        str | None,
        typer.Option(
            "--policy",
            metavar="NAME",
            help="Hold it again under this question policy, the record as the teacher.",
        ),
    ] = None,
    scenes: ScenesFolder = None,
    as_json: JsonFlag = False,
) -> None:
    """Play a session back, or with --verify recompute it and compare.

    In a terminal it opens the panels it was taught in; with --plain, or without
    a terminal, it is told in lines.

    Exit status 1 where recomputing gives something else. A torn last line is a
    warning. With --policy the robot asks as another policy would; what the
    record holds no answer to is counted as unanswerable, never made up.
    """
    if policy is not None:
        if verify or to is not None:
            raise WrongUseError("--policy holds the whole session again: leave out --verify, --to")
        _hold_again(session, policy, scenes, as_json)
    elif verify or as_json:
        _verify(session, to, scenes, as_json, verify)
    elif plain or not has_terminal():
        _tell(session, to, scenes, speed)
    else:
        _show(session, to, scenes, speed)


def _show(session: Path, to: int | None, scenes: Path | None, speed: float) -> None:
    from verbteach_tui.beginning import Beginning
    from verbteach_tui.options import OpenRecord
    from verbteach_tui.room import full_screen

    folder = session.parent.parent if session.is_file() else session.parent
    raise typer.Exit(
        full_screen(Beginning(folder, "app", scenes=scenes), OpenRecord(session, to or 0, speed))
    )


def _tell(session: Path, to: int | None, scenes: Path | None, speed: float) -> None:
    from verbteach_scenarios.nlp.second_opinion import if_installed
    from verbteach_scenarios.settings import make_settings
    from verbteach_sessions.replay import replay as frames
    from verbteach_tui.playback import told

    for line in told(frames(session, make_settings(scenes, if_installed()), to), speed, time.sleep):
        tell(line)


def _verify(session: Path, to: int | None, scenes: Path | None, as_json: bool, asked: bool) -> None:
    from verbteach_scenarios.nlp.second_opinion import if_installed
    from verbteach_scenarios.settings import make_settings
    from verbteach_sessions.replay import verify
    from verbteach_tui.record import count_events

    with progress() as show:
        heard = counting(show, "events", count_events(session))
        found = verify(session, make_settings(scenes, if_installed()), to, heard)
    for warning in found.warnings:
        note(f"warning: {warning}")
    if as_json:
        emit(found.to_json())
    elif found.first_difference is None:
        tell(f"verified: {found.events} events, content hash {found.content_hash}")
    else:
        tell(f"event {found.first_difference.seq} differs: {found.first_difference.field}")
        tell(f"  recorded:   {_short(found.first_difference.recorded)}")
        tell(f"  recomputed: {_short(found.first_difference.recomputed)}")
    if asked and not found.verified:
        raise typer.Exit(CHECK_FAILED)


def _hold_again(session: Path, policy: str, scenes: Path | None, as_json: bool) -> None:
    from verbteach_scenarios.nlp.second_opinion import if_installed
    from verbteach_scenarios.settings import make_settings
    from verbteach_sessions.counterfactual import counterfactual
    from verbteach_tui.record import count_events

    with progress() as show:
        heard = counting(show, "events", count_events(session))
        found = counterfactual(session, make_settings(scenes, if_installed()), policy, heard)
    for warning in found.warnings:
        note(f"warning: {warning}")
    if as_json:
        emit(found.to_json())
        return
    tell(f"under {policy}: {found.finished} of {found.commands} commands to their end")
    tell(f"  turns {found.turns}, of which the record holds no answer to {found.unanswerable}")
    tell(f"  questions {found.questions}, recorded {found.recorded_questions}")
    tell(f"  reward {found.reward:g}, recorded {found.recorded_reward:g}")
    if found.first_difference is not None:
        tell(f"  event {found.first_difference.seq} is the first that differs")


def _short(value: object) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."
