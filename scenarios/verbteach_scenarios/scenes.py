"""Scenes by name: the bundled rooms and the user's own, ready to be taught in.

The bundled ones open from their compiled form; anything else is parsed.
Parsed files are kept by their text, so that an edited file is read anew.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from verbteach.dialogue.setting import UnknownSceneError
from verbteach.world.domain import Domain
from verbteach.world.scene import Scene, SceneObject
from verbteach_scenarios.compiled import (
    digest,
    domain_from_json,
    problem_from_json,
    read_compiled,
)
from verbteach_scenarios.errors import DomainFileError, SceneFileError, WorldFileError
from verbteach_scenarios.folders import DOMAIN, WorldFolder, world_folder
from verbteach_scenarios.pddl import Problem, parse_domain, parse_problem
from verbteach_scenarios.pddl.grammar import read_text
from verbteach_scenarios.reachability import check_goal
from verbteach_scenarios.sidecar import Look, Sidecar, parse_sidecar


@dataclass(frozen=True)
class SceneRow:
    """One scene in a list; ``objects`` counts what is in the room, the domain's constants not."""

    id: str
    room: str
    title: str
    objects: int


@dataclass(frozen=True)
class SceneProblem:
    """What is wrong with a file; ``line`` is 0 where the file as a whole is meant."""

    path: Path
    line: int
    reason: str


@dataclass(frozen=True)
class SceneReport:
    """The scenes that can be used, and what is wrong with the others."""

    scenes: tuple[SceneRow, ...]
    problems: tuple[SceneProblem, ...]


def scene_ids(folder: Path | None = None) -> tuple[str, ...]:
    """Names of the scenes in ``folder``, or of the bundled ones; opens none of them."""
    return world_folder(folder).scene_ids


def load_domain(folder: Path | None = None) -> Domain:
    """The domain of the scenes in ``folder``; raise ``DomainFileError`` if it does not fit."""
    return _domain(world_folder(folder))


def load_scene(scene_id: str, folder: Path | None = None) -> Scene:
    """Open a scene.

    Raises ``UnknownSceneError``, or a ``WorldFileError`` with path, line and
    reason where one of its files does not fit or its goal cannot be reached.
    """
    home = world_folder(folder)
    if scene_id not in home.scene_ids:
        known = ", ".join(home.scene_ids) or "none"
        raise UnknownSceneError(f"there is no scene {scene_id!r}; there are: {known}")
    return _scene(home, scene_id)


def scene_row(scene: Scene) -> SceneRow:
    """What a list says of a scene."""
    own = sum(name not in scene.domain.constants for name in scene.objects)
    return SceneRow(scene.id, scene.room, scene.title, own)


def check_scenes(folder: Path | None = None) -> SceneReport:
    """Open every scene; what is wrong becomes data, one entry for each file that does not fit."""
    home = world_folder(folder)
    rows: list[SceneRow] = []
    problems: list[SceneProblem] = []
    for scene_id in home.scene_ids:
        try:
            rows.append(scene_row(_scene(home, scene_id)))
        except WorldFileError as error:
            found = SceneProblem(error.path, error.line, error.reason)
            problems += [found] if found not in problems else []
    if not home.scene_ids:
        problems.append(SceneProblem(home.path, 0, "holds no scene: no .pddl file with a problem"))
    return SceneReport(tuple(rows), tuple(problems))


def _scene(home: WorldFolder, scene_id: str) -> Scene:
    text = read_text(home.problem(scene_id), SceneFileError)
    domain = _domain(home)
    problem = _problem(home, scene_id, text, domain)
    looks = {**_constant_looks(home, domain), **_looks(home, scene_id, problem)}
    sidecar = _sidecar(home.sidecar(scene_id))
    objects = {
        name: SceneObject(name, type_name, *_look(looks.get(name), name))
        for name, type_name in problem.objects.items()
    }
    room = sidecar.room or _spoken(re.sub(r"[-_ ]*\d+$", "", scene_id))
    title = sidecar.title or _spoken(scene_id)
    scene = Scene(scene_id, room, title, domain, objects, problem.initial)
    check_goal(scene, problem.goal, home.problem(scene_id), text)
    return scene


def _domain(home: WorldFolder) -> Domain:
    path = home.domain_home / f"{DOMAIN}.pddl"
    text = read_text(path, DomainFileError)
    return _parsed_domain(text, path, WorldFolder(home.domain_home).compiled(DOMAIN))


@lru_cache(maxsize=8)
def _parsed_domain(text: str, path: Path, compiled: Path) -> Domain:
    ready = read_compiled(compiled, digest(text))
    return domain_from_json(ready) if ready else parse_domain(text, path)


def _problem(home: WorldFolder, scene_id: str, text: str, domain: Domain) -> Problem:
    domain_text = read_text(home.domain_home / f"{DOMAIN}.pddl", DomainFileError)
    ready = read_compiled(home.compiled(scene_id), digest(domain_text, text))
    return (
        problem_from_json(ready) if ready else parse_problem(text, domain, home.problem(scene_id))
    )


def _sidecar(path: Path) -> Sidecar:
    if not path.is_file():
        return Sidecar(path)
    return parse_sidecar(read_text(path, SceneFileError), path)


def _looks(home: WorldFolder, scene_id: str, problem: Problem) -> Mapping[str, Look]:
    sidecar = _sidecar(home.sidecar(scene_id))
    for name in sidecar.looks:
        if name not in problem.objects:
            raise sidecar.fail(name, f"the scene {scene_id} has no object {name}")
    return sidecar.looks


def _constant_looks(home: WorldFolder, domain: Domain) -> Mapping[str, Look]:
    sidecar = _sidecar(home.domain_home / f"{DOMAIN}.toml")
    for name in sidecar.looks:
        if name not in domain.constants:
            raise sidecar.fail(name, f"the domain {domain.name} has no constant {name}")
    return sidecar.looks


def _look(look: Look | None, name: str) -> tuple[tuple[str, ...], Mapping[str, str]]:
    if look is None:
        return (_spoken(name),), {}
    return look.names or (_spoken(name),), look.attributes


def _spoken(name: str) -> str:
    """``CoffeeTable_1`` as people say it: "coffee table"."""
    plain = re.sub(r"_\d+$", "", name)
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|[-_]+", " ", plain)
    return words.strip().lower()
