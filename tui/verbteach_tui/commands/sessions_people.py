"""`verbteach sessions scan|withdraw`: what sessions say about the people who taught in them."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from verbteach_tui.commands.parameters import JsonFlag, SessionsFolder
from verbteach_tui.commands.sessions_corpus import NamesFile, SomePaths, found_at, names_in
from verbteach_tui.commands.streams import columns, emit, note, progress, tell
from verbteach_tui.conclusion import CHECK_FAILED, DONE, WrongUseError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from verbteach_sessions.corpus.findings import Finding
    from verbteach_sessions.corpus.redactions import Choice, Redactions
    from verbteach_sessions.corpus.withdrawal import Withdrawal


def scan(
    paths: SomePaths = None,
    names: NamesFile = None,
    redact: Annotated[
        bool, typer.Option("--redact", help="Have exports leave out all that is not decided.")
    ] = False,
    keep: Annotated[
        list[str] | None,
        typer.Option("--keep", metavar="TEXT", help="Let this text go out; may be repeated."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Look for personal data in sessions; status 1 while something found is not decided.

    Decisions are kept beside the sessions, in redactions.jsonl. Records do not change.
    """
    found = _findings(found_at(paths), names)
    kept = {text.casefold() for text in keep or ()}
    unknown = kept - {finding.text.casefold() for _, finding in found}
    if unknown:
        raise WrongUseError(f"nothing found reads {sorted(unknown)[0]!r}, so it cannot be kept")
    rows = [_decided(log, finding, kept, redact) for log, finding in found]
    still_open = sum(finding.choice is None for finding in rows)
    if as_json:
        listed = [finding.to_json() for finding in rows]
        emit({"sessions": len(found_at(paths)), "findings": listed, "undecided": still_open})
    elif rows:
        head = ("SESSION", "EVENT", "KIND", "DECISION", "TEXT")
        tell(columns([head, *map(_row, rows)]))
    else:
        note("nothing found")
    raise typer.Exit(CHECK_FAILED if still_open else DONE)


def _findings(paths: Sequence[Path], names: Path | None) -> list[tuple[Redactions, Finding]]:
    from verbteach_sessions.corpus.findings import scan as look
    from verbteach_sessions.corpus.folder import corpus_of
    from verbteach_sessions.corpus.personal import Scanner
    from verbteach_sessions.corpus.redactions import Redactions

    scanner, logs = Scanner(names_in(names)), dict[Path, Redactions]()
    found: list[tuple[Redactions, Finding]] = []
    with progress() as show:
        for done, path in enumerate(paths, start=1):
            folder = corpus_of(path)
            if folder not in logs:
                logs[folder] = Redactions.of(folder)
            found += ((logs[folder], finding) for finding in look(path, scanner, logs[folder]))
            show("sessions", done, len(paths))
    return found


def _decided(log: Redactions, finding: Finding, kept: set[str], redact: bool) -> Finding:
    """The finding with what is decided now; a decision that stands is not changed by --redact."""
    from dataclasses import replace

    choice: Choice | None = finding.choice
    if finding.text.casefold() in kept:
        choice = "keep"
    elif redact and choice is None:
        choice = "redact"
    if choice is not None and choice != finding.choice:
        log.decide([finding.decision(choice)])
    return replace(finding, choice=choice)


def _row(finding: Finding) -> tuple[object, ...]:
    event = "-" if finding.seq is None else finding.seq
    return finding.session, event, finding.kind, finding.choice or "OPEN", finding.text


def withdraw(
    code: Annotated[str, typer.Argument(metavar="CODE", help="The participant's code.")],
    sessions: SessionsFolder = None,
    yes: Annotated[bool, typer.Option("--yes", help="Delete without asking.")] = False,
    as_json: JsonFlag = False,
) -> None:
    """Delete a person's records, and list the exports that they were in."""
    from verbteach_sessions.catalogue import default_folder
    from verbteach_sessions.corpus.withdrawal import carry_out, find

    found = find(sessions or default_folder(), code)
    if not as_json:
        _print(found)
    done = bool(found.sessions or found.home) and _confirmed(found, yes)
    if done:
        carry_out(found)
    if as_json:
        emit({**found.to_json(), "deleted": done})
    else:
        tell(f"deleted: {len(found.sessions)} sessions" if done else "nothing was deleted")


def _confirmed(found: Withdrawal, yes: bool) -> bool:
    """Whether the person at the keyboard types the code once more."""
    if yes:
        return True
    if not _at_terminal():
        raise WrongUseError("deleting needs a terminal to confirm on, or --yes")
    print(f"Type the code to delete {len(found.sessions)} sessions: ", end="", file=sys.stderr)
    sys.stderr.flush()
    return sys.stdin.readline().strip() == found.participant


def _at_terminal() -> bool:
    return sys.stdin.isatty()


def _print(found: Withdrawal) -> None:
    for path in found.sessions:
        tell(f"session: {path}")
    if found.home is not None:
        tell(f"folder: {found.home}")
    for one in found.exports:
        tell(f"was exported: {one.at} as {one.format} to {one.out}")
    for path in found.others:
        tell(f"began with what was taught there, and holds it still: {path}")
