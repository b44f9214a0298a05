"""Which program figures come from: a short hash of all sources that can have a part in them."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from hashlib import sha256
from pathlib import Path

import verbteach
import verbteach_scenarios

WORDS = ("data/household/lexicon.toml", "tell_me_dave/domain.pddl")
"""Files beside the sources that a learner on the corpus hangs on."""
_HOMES: Mapping[str, Path] = {
    package.__name__: Path(str(package.__file__)).parent
    for package in (verbteach, verbteach_scenarios)
}


def program(*roots: str) -> str:
    """A short hash of the modules, of all that they import of this project, and of ``WORDS``.

    What is imported within a function counts too; nothing is imported to find out.
    """
    found = reached(*roots)
    home = _HOMES["verbteach_scenarios"]
    files = {**found, **{name: home / name for name in WORDS}}
    made = sha256()
    for name in sorted(files):
        made.update(name.encode() + b"\0" + files[name].read_bytes() + b"\0")
    return made.hexdigest()[:16]


def reached(*roots: str) -> dict[str, Path]:
    """The sources of the modules and of those that they import, by name."""
    found: dict[str, Path] = {}
    waiting = list(roots)
    while waiting:
        name = waiting.pop()
        source = None if name in found else _source(name)
        if source is not None:
            found[name] = source
            waiting += _imported(source)
    return found


def _source(name: str) -> Path | None:
    """Where a module of this project is; none where the name is another's, or no module's."""
    package, *rest = name.split(".")
    if package not in _HOMES:
        return None
    place = _HOMES[package].joinpath(*rest)
    choices = (place.with_suffix(".py"), place / "__init__.py")
    return next((path for path in choices if path.is_file()), None)


def _imported(source: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(source.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
