"""`verbteach bench`: speed and memory of this installation."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated, Any

import typer

from verbteach_tui.commands.parameters import JsonFlag
from verbteach_tui.commands.streams import Progress, columns, counting, emit, progress, tell

if TYPE_CHECKING:
    from verbteach_tui.bench.questions import Question

QUESTIONS, PEERS_QUESTIONS = 200, 40
TURNS, APP_TURNS, KEY_TURNS = 300, 1000, 500


def bench(
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
    with progress() as show, TemporaryDirectory(prefix="verbteach-bench-") as folder:
        report = measure(Path(folder), data, peers, show)
    if as_json:
        emit(report)
    else:
        _print(report)


def measure(folder: Path, data: Path | None, peers: bool, show: Progress) -> dict[str, Any]:
    """Everything, JSON-ready. Sessions made on the way stay in ``folder``."""
    return {
        "startup_ms": _startup(show),
        **_planning(data, peers, show),
        **_teaching(folder, show),
        "key_to_paint_ms": _painting(folder, show),
        "rss_mb": _memory(folder, show),
    }


def _startup(show: Progress) -> dict[str, float | None]:
    from verbteach_tui.bench.startup import first_paint_ms, version_ms

    show("starting", 0, 2)
    version = version_ms()
    show("starting", 1, 2)
    painted = first_paint_ms()
    show("starting", 2, 2)
    return {"version": version, "first_paint": painted}


def _planning(data: Path | None, peers: bool, show: Progress) -> dict[str, Any]:
    from verbteach_tui.bench import planning

    questions = _questions(data)
    measured = {}
    for path in planning.paths():
        done = counting(show, f"planning, {path}", len(questions))
        measured[path] = planning.measure(questions, path, done)
    *others, best = measured.values()
    return {
        "plan_ms": {**best, "on": str(data) if data else "lessons", "other_paths": others},
        "peers": _peers(questions, show) if peers else {},
    }


def _questions(data: Path | None) -> list[Question]:
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_scenarios.settings import make_settings
    from verbteach_tui.bench.questions import of_corpus, of_lessons, spread

    if data is not None:
        return spread(list(of_corpus(data)), QUESTIONS)
    return spread(list(of_lessons(load_lessons(), make_settings())), QUESTIONS)


def _peers(questions: list[Question], show: Progress) -> dict[str, Any]:
    from verbteach_tui.bench import peers, planning
    from verbteach_tui.bench.questions import spread

    some = spread(questions, PEERS_QUESTIONS)
    own = planning.paths()[-1]
    show("the same, verbteach", 0, len(some))
    found = {"verbteach": planning.measure(some, own, lambda n: None)}
    texts = [question.pddl() for question in some]
    for name in peers.here():
        done = counting(show, f"the same, {name}", len(texts))
        found[name] = peers.measure(name, texts, done)
    return found


def _teaching(folder: Path, show: Progress) -> dict[str, Any]:
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_scenarios.settings import make_settings
    from verbteach_tui.bench import dialogue
    from verbteach_tui.bench.clock import percentiles

    lessons, settings = load_lessons(), make_settings()
    total = dialogue.WARMED + TURNS
    counted = counting(show, "teaching", total)
    turns = dialogue.long_session(folder, lessons, settings, TURNS, counted)
    show("repeating", 0, 3)
    dialogues = dialogue.dialogues_per_second(settings, lessons[0].scene)
    show("repeating", 1, 3)
    episodes = dialogue.planned_episodes_per_second(lessons, settings)
    show("repeating", 2, 3)
    replayed = dialogue.replayed_per_second(turns.path, settings)
    show("repeating", 3, 3)
    return {
        "turn_ms": percentiles(turns.plain),
        "planned_turn_ms": percentiles(turns.planned),
        "dialogues_per_s": dialogues,
        "planned_episodes_per_s": episodes,
        "replay_events_per_s": replayed,
    }


def _painting(folder: Path, show: Progress) -> dict[str, Any]:
    from verbteach_tui.bench.clock import percentiles
    from verbteach_tui.bench.painting import key_to_paint

    show("keys to the screen", 0, 1)
    found = key_to_paint(folder, KEY_TURNS)
    show("keys to the screen", 1, 1)
    return {kind: percentiles(times) for kind, times in found.items()}


def _memory(folder: Path, show: Progress) -> float | None:
    from verbteach_tui.bench.memory import app_rss_mb

    show("memory of the app", 0, 1)
    held = app_rss_mb(folder, APP_TURNS)
    show("memory of the app", 1, 1)
    return held


def _print(report: dict[str, Any]) -> None:
    rows = [(name, _figure(value)) for name, value in report.items() if name != "peers"]
    tell(columns(rows))
    for name, peer in report["peers"].items():
        tell(f"{name:12}  {_figure(peer)}")


def _figure(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {_figure(inner)}" for key, inner in value.items())
    if isinstance(value, list):
        return "; ".join(map(_figure, value)) or "none"
    return f"{value:.4g}" if isinstance(value, float) else str(value)
