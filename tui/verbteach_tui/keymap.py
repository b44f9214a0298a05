"""The person's own keys: a file that says which key says what, checked before it counts.

``[keys]`` in ``keys.toml`` gives a name from :data:`SAID` or :data:`BOUND` its
key. What one key would mean twice is refused with the line that says so.
"""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from verbteach_sessions.places import at_home
from verbteach_tui.conclusion import WrongUseError
from verbteach_tui.keys import SAID
from verbteach_tui.near import known

FILE_NAME = "keys.toml"
VARIABLE = "VERBTEACH_KEYS"
"""Names another file in the environment."""

BOUND: Mapping[str, str] = {
    "help": "f1",
    "dialogue": "f2",
    "scene": "f3",
    "mind": "f4",
    "verbs": "f5",
    "scenes": "f6",
    "belief": "f7",
    "turns": "f8",
    "steps": "f9",
    "leave": "f10",
    "palette": "ctrl+p",
    "quit": "ctrl+q",
    "line-undo": "ctrl+z",
    "line-redo": "ctrl+y",
}
"""What a function key or a Ctrl combination does, with its default."""

RESERVED = frozenset("0123456789/+-=xXeli ")
"""Keys with a fixed meaning: digits pick, / types, the others steer what is watched or edited."""

_SPECIAL = re.compile(r"f([1-9]|1[012])|ctrl\+[a-z]")
_UNUSABLE = frozenset({"ctrl+c", "ctrl+h", "ctrl+i", "ctrl+j", "ctrl+m", "ctrl+s"})
"""Combinations that terminals take for other keys, or for themselves."""


class KeymapError(WrongUseError):
    """The file of keys is wrong; the message says where and why."""


@dataclass(frozen=True)
class Keymap:
    """The keys that differ from the default: of what is said, and of what is done."""

    said: Mapping[str, str] = field(default_factory=dict)
    bound: Mapping[str, str] = field(default_factory=dict)


def keys_file() -> Path:
    """Where the person's keys stand, whether or not there is such a file."""
    named = os.environ.get(VARIABLE)
    if named:
        return Path(named)
    from platformdirs import user_config_path

    with at_home():
        return user_config_path("verbteach") / FILE_NAME


def read_keymap(path: Path) -> Keymap:
    """The keys of a file; the defaults where there is none. Raises :class:`KeymapError`."""
    try:
        text = path.read_text("utf-8")
    except FileNotFoundError:
        return Keymap()
    except (OSError, UnicodeDecodeError) as error:
        raise KeymapError(f"{path}: cannot be read, {error}") from error
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise KeymapError(f"{path}: {error}") from error
    return _Reading(path, text).keymap(table)


class _Reading:
    """One file being read; errors name its line."""

    def __init__(self, path: Path, text: str) -> None:
        self._path, self._lines = path, text.splitlines()

    def keymap(self, table: Mapping[str, object]) -> Keymap:
        for name in table:
            if name != "keys":
                raise self._wrong(name, "only the table [keys] is known")
        keys = table.get("keys", {})
        if not isinstance(keys, dict):
            raise self._wrong("keys", "[keys] is a table of names and keys")
        for name, key in keys.items():
            self._check(name, key)
        self._check_conflicts(keys, SAID)
        self._check_conflicts(keys, BOUND)
        return Keymap(
            {name: key for name, key in keys.items() if name in SAID},
            {name: key for name, key in keys.items() if name in BOUND},
        )

    def _check(self, name: str, key: object) -> None:
        try:
            known(name, (*SAID, *BOUND), "key named")
        except WrongUseError as error:
            raise self._wrong(name, str(error)) from error
        if not isinstance(key, str):
            raise self._wrong(name, "a key is a text, such as 'j' or 'f4'")
        problem = _single_problem(key) if name in SAID else _special_problem(key)
        if problem:
            raise self._wrong(name, f"{key!r} cannot be the key of {name!r}: {problem}")

    def _check_conflicts(self, keys: Mapping[str, str], defaults: Mapping[str, str]) -> None:
        taken: dict[str, str] = {}
        for name in sorted(defaults, key=lambda name: name in keys):
            key = keys.get(name, defaults[name])
            if key in taken:
                raise self._wrong(name, f"{key!r} is the key of {taken[key]!r} already")
            taken[key] = name

    def _wrong(self, name: str, problem: str) -> KeymapError:
        start = re.compile(rf"\s*\[?\s*[\"']?{re.escape(name)}[\"']?\s*[=\]]")
        line = next((n for n, text in enumerate(self._lines, 1) if start.match(text)), 1)
        return KeymapError(f"{self._path}:{line}: {problem}")


def _single_problem(key: str) -> str:
    if len(key) != 1 or not key.isprintable() or key.isspace():
        return "it must be one character"
    if key in RESERVED:
        return "digits, / and the keys that steer have a meaning of their own"
    return ""


def _special_problem(key: str) -> str:
    if not _SPECIAL.fullmatch(key):
        return "it must be a function key (f1 to f12) or a plain Ctrl combination (ctrl+o)"
    if key in _UNUSABLE:
        return "terminals take that combination for another key"
    return ""
