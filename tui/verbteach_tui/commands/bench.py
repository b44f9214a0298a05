"""`verbteach bench`: speed and memory of this installation."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated, Any

import typer

from verbteach_tui.commands.parameters import JsonFlag
from verbteach_tui.commands.streams import columns, emit, note, progress, tell
from verbteach_tui.conclusion import WrongUseError

if TYPE_CHECKING:
    from verbteach_tui.bench.workbench import Workbench

NAMES = ("startup", "plans", "turns", "keys", "rates", "replay", "memory", "peers")
PEERS = "peers"
SECONDS = 60.0


def bench(
    part: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME",
            help=f"Only this part, and others named (all but peers): {', '.join(NAMES)}.",
        ),
    ] = None,
    seconds: Annotated[
        float,
        typer.Option(
            min=1, metavar="S", help="The most that a part may take; it reports what it has."
        ),
    ] = SECONDS,
    plain: Annotated[
        bool, typer.Option("--plain", help="As without the extra fast: nothing is compiled.")
    ] = False,
    peers: Annotated[
        bool, typer.Option("--peers", help="Ask the other planners that are installed, too.")
    ] = False,
    data: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Plan on a Tell Me Dave folder, not on the lessons."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Measure speed and memory of this installation, which takes a few minutes."""
    chosen = _chosen(part or [], peers)
    from verbteach_tui.bench.workbench import Workbench

    with progress() as show, TemporaryDirectory(prefix="verbteach-bench-") as folder:
        bench = Workbench(Path(folder), show, seconds, data, "plain" if plain else "auto")
        report = measure(bench, chosen)
    if as_json:
        emit(report)
    else:
        _print(report)


def _chosen(parts: Sequence[str], peers: bool) -> list[str]:
    """The parts in their order: those named, else all but the other planners."""
    unknown = [name for name in parts if name not in NAMES]
    if unknown:
        raise WrongUseError(f"--part: there is no {unknown[0]!r}; there are: {', '.join(NAMES)}")
    wanted = set(parts) or set(NAMES) - {PEERS}
    return [name for name in NAMES if name in wanted or (peers and name == PEERS)]


def measure(bench: Workbench, chosen: Sequence[str]) -> dict[str, Any]:
    """What the chosen parts found, JSON-ready, with how long each took and what else ran."""
    from verbteach_tui.bench.parts import PARTS

    report: dict[str, Any] = {}
    spent: dict[str, float] = {}
    load = [_load()]
    for name in chosen:
        start = time.perf_counter()
        report |= PARTS[name](bench)
        spent[name] = round(time.perf_counter() - start, 1)
    load.append(_load())
    return {**report, "peers": report.get("peers", {}), "seconds": spent, "load": load}


def _load() -> float | None:
    """How many processes want to run, over the last minute; ``None`` where that is not told."""
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else None


def _print(report: dict[str, Any]) -> None:
    apart = ("peers", "load")
    tell(columns([(name, _figure(value)) for name, value in report.items() if name not in apart]))
    for name, peer in report["peers"].items():
        tell(f"{name:12}  {_figure(peer)}")
    busy = report["load"][0]
    if busy is not None and busy > (os.cpu_count() or 1) / 2:
        note(f"Other programs kept this machine busy (load {busy:.1f}): it can do better.")


def _figure(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {_figure(inner)}" for key, inner in value.items())
    if isinstance(value, list):
        return "; ".join(map(_figure, value)) or "none"
    return f"{value:.4g}" if isinstance(value, float) else str(value)
