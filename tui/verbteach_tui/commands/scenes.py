"""`verbteach scenes`: the bundled worlds and the user's own."""

from __future__ import annotations

from collections.abc import Sized
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any

import typer

from verbteach_tui.commands.parameters import JsonFlag, ScenesFolder, scene_names
from verbteach_tui.commands.streams import columns, emit, note, tell
from verbteach_tui.conclusion import CHECK_FAILED
from verbteach_tui.near import known

if TYPE_CHECKING:
    from verbteach.world.scene import Scene
    from verbteach_scenarios.scenes import SceneReport

SceneArgument = Annotated[
    str,
    typer.Argument(
        metavar="ID", help="The scene, as in verbteach scenes list.", autocompletion=scene_names
    ),
]


def list_scenes(scenes: ScenesFolder = None, as_json: JsonFlag = False) -> None:
    """List the scenes that can be taught in."""
    from verbteach_scenarios.scenes import check_scenes

    report = check_scenes(scenes)
    for problem in report.problems:
        note(f"left out: {_place(problem)}: {problem.reason}")
    if as_json:
        emit({"scenes": [asdict(row) for row in report.scenes]})
    else:
        tell(_table(report))


def show_scene(
    scene: SceneArgument, scenes: ScenesFolder = None, as_json: JsonFlag = False
) -> None:
    """Show a scene: its objects, what they look like, and how they are found."""
    from verbteach_scenarios.scenes import load_scene, scene_ids

    found = load_scene(known(scene, scene_ids(scenes), "scene"), scenes)
    if as_json:
        emit(_document(found))
    else:
        _print(found)


def check(scenes: ScenesFolder = None, as_json: JsonFlag = False) -> None:
    """Read every scene with its domain and say what does not fit, by file and line.

    Exit status 1 where something does not.
    """
    from verbteach_scenarios.scenes import check_scenes

    report = check_scenes(scenes)
    problems = [{"path": str(p.path), "line": p.line, "reason": p.reason} for p in report.problems]
    if as_json:
        emit({"scenes": [asdict(row) for row in report.scenes], "problems": problems})
    else:
        for problem in report.problems:
            tell(f"{_place(problem)}: {problem.reason}")
        tell(f"{_count(report.scenes, 'scene')} can be used, {_count(problems, 'problem')}")
    if problems:
        raise typer.Exit(CHECK_FAILED)


def _count(things: Sized, name: str) -> str:
    return f"{len(things)} {name}" if len(things) == 1 else f"{len(things)} {name}s"


def _place(problem: Any) -> str:
    return f"{problem.path}:{problem.line}" if problem.line else str(problem.path)


def _table(report: SceneReport) -> str:
    rows = [(row.id, row.room, row.objects, row.title) for row in report.scenes]
    return columns([("ID", "ROOM", "OBJECTS", "TITLE"), *rows])


def _own(scene: Scene) -> list[str]:
    return [name for name in scene.objects if name not in scene.domain.constants]


def _document(scene: Scene) -> dict[str, Any]:
    from verbteach_scenarios.scenes import scene_row

    things = [asdict(scene.objects[name]) for name in _own(scene)]
    return {
        "scenes": [asdict(scene_row(scene))],
        "domain": scene.domain.name,
        "things": things,
        "initial": [str(fluent) for fluent in sorted(scene.initial)],
        "actions": {
            name: [parameter.type for parameter in schema.parameters]
            for name, schema in scene.domain.actions.items()
        },
    }


def _print(scene: Scene) -> None:
    head = ("OBJECT", "TYPE", "NAMES", "LOOKS", "FOUND")
    tell(f"{scene.id}: {scene.title} ({scene.room}, domain {scene.domain.name})")
    tell()
    tell(columns([head, *(_row(scene, name) for name in _own(scene))]))


def _row(scene: Scene, name: str) -> tuple[str, ...]:
    """An object: what people call it, what it looks like, and what holds of it at first."""
    thing = scene.objects[name]
    facts = (f for f in sorted(scene.initial) if f.args[:1] == (name,))
    told = (" ".join((f.predicate, *f.args[1:])) for f in facts)
    looks = " ".join(thing.attributes.values())
    return name, thing.type, ", ".join(thing.names), looks, "; ".join(told)
