"""The TOML file beside a PDDL file: what a scene is called, and what its objects look like.

Knows nothing of domains and types; whether an object exists is the scene's business.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from verbteach_scenarios.errors import SceneFileError

_PLACE = re.compile(r"\s*\((?:at line (\d+), column \d+|at end of document)\)$")
_KEYS = frozenset({"title", "room", "objects"})


@dataclass(frozen=True)
class Look:
    """Names people use for an object, the best first, and its attributes by kind."""

    names: tuple[str, ...] = ()
    attributes: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Sidecar:
    """A scene's title, its kind of room, and its objects' looks by id; all may be missing."""

    path: Path
    title: str = ""
    room: str = ""
    looks: Mapping[str, Look] = field(default_factory=dict)
    text: str = field(default="", repr=False)

    def fail(self, object_id: str, reason: str) -> SceneFileError:
        """Return the error that names the line where ``object_id`` is described."""
        return SceneFileError(self.path, _line_of(self.text, object_id), reason)


def parse_sidecar(text: str, path: Path) -> Sidecar:
    """Read a sidecar from its text; raise ``SceneFileError`` with ``path``, line and reason."""
    data = parse_toml(text, path)
    unknown = sorted(set(data) - _KEYS)
    if unknown:
        where = _line_matching(text, rf"\s*\[?\s*{re.escape(unknown[0])}\b")
        raise SceneFileError(path, where, f"{unknown[0]} is not known; write title, room, objects")
    objects = data.get("objects", {})
    if not isinstance(objects, dict):
        raise SceneFileError(path, 0, "objects must be a table, one [objects.NAME] for each object")
    looks = {name: _look(name, table, text, path) for name, table in objects.items()}
    return Sidecar(path, _word(data, "title", path), _word(data, "room", path), looks, text)


def parse_toml(text: str, path: Path) -> dict[str, Any]:
    """Parse TOML; raise ``SceneFileError`` with the line where it stops being TOML."""
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as problem:
        reason = str(problem)
        place = _PLACE.search(reason)
        last = text.rstrip().count("\n") + 1
        line = int(place.group(1)) if place and place.group(1) else last
        raise SceneFileError(path, line, f"is not TOML: {_PLACE.sub('', reason)}") from None


def _look(name: str, table: object, text: str, path: Path) -> Look:
    if not isinstance(table, dict):
        raise SceneFileError(path, _line_of(text, name), f"{name} must be a table of words")
    words = {key: value for key, value in table.items() if key != "names"}
    names = table.get("names", [])
    listed = isinstance(names, list) and all(isinstance(one, str) and one for one in names)
    if not listed:
        reason = f"the names of {name} must be a list of words"
        raise SceneFileError(path, _line_of(text, name), reason)
    for key, value in words.items():
        if not isinstance(value, str):
            reason = f"{key} of {name} must be a word in quotes"
            raise SceneFileError(path, _line_of(text, name), reason)
    return Look(tuple(names), words)


def _word(data: Mapping[str, object], key: str, path: Path) -> str:
    value = data.get(key, "")
    if not isinstance(value, str):
        raise SceneFileError(path, 0, f"{key} must be text in quotes")
    return value


def _line_of(text: str, object_id: str) -> int:
    name = rf"[\"']?{re.escape(object_id)}[\"']?"
    return _line_matching(text, rf"\s*(\[\s*objects\s*\.\s*{name}\s*\]|{name}\s*[.=])")


def _line_matching(text: str, pattern: str) -> int:
    lines = enumerate(text.splitlines(), start=1)
    return next((number for number, line in lines if re.match(pattern, line)), 0)
