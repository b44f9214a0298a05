"""`verbteach doctor`: what this installation and this terminal can do."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import typer

from verbteach_tui.commands.parameters import JsonFlag
from verbteach_tui.commands.streams import columns, emit, tell
from verbteach_tui.conclusion import CHECK_FAILED


def doctor(as_json: JsonFlag = False) -> None:
    """Say what this installation and this terminal can do.

    Exit status 1 where something needed is missing.
    """
    report = examine()
    if as_json:
        emit(report)
    else:
        _print(report)
    if report["problems"]:
        raise typer.Exit(CHECK_FAILED)


def examine() -> dict[str, Any]:
    """Everything the command says, JSON-ready; ``problems`` keep sessions from working."""
    import platform
    import sys

    from verbteach import __version__
    from verbteach_sessions.catalogue import default_folder
    from verbteach_tui.installation import installed, is_writable, requirements
    from verbteach_tui.keymap import keys_file
    from verbteach_tui.terminal import Terminal

    needs = requirements()
    libraries = {name: installed(name) for name in needs.pop("", ())}
    extras = {extra: {name: installed(name) for name in names} for extra, names in needs.items()}
    sessions = default_folder()
    terminal = Terminal.here()
    problems = [f"{name} is not installed" for name, found in libraries.items() if not found]
    if not is_writable(sessions):
        problems.append(f"sessions cannot be written to {sessions}")
    return {
        "versions": {
            "verbteach": __version__,
            "python": platform.python_version(),
            "platform": platform.platform(),
            **libraries,
        },
        "extras": extras,
        "folders": {"sessions": str(sessions), "python": sys.prefix},
        "files": {"keys": str(keys_file())},
        "terminal": asdict(terminal),
        "notes": list(terminal.advice()),
        "problems": problems,
    }


def _print(report: dict[str, Any]) -> None:
    tell(columns([(name, found or "missing") for name, found in report["versions"].items()]))
    tell()
    tell(columns([(f"[{extra}]", _presence(found)) for extra, found in report["extras"].items()]))
    tell()
    tell(columns([(f"{name} folder", path) for name, path in report["folders"].items()]))
    tell()
    tell(columns([(f"{name} file", path) for name, path in report["files"].items()]))
    tell()
    tell(columns([(f"terminal {key}", value) for key, value in report["terminal"].items()]))
    for kind in ("notes", "problems"):
        for line in report[kind]:
            tell(f"{kind.removesuffix('s')}: {line}")


def _presence(packages: dict[str, str | None]) -> str:
    return ", ".join(f"{name} {found or '(missing)'}" for name, found in packages.items())
