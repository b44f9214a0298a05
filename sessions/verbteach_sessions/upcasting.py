"""Events of earlier versions of the format, made into those of today.

Version by version: a step knows one version and the next, and is never touched
again. A line's bytes, and so its hashes, stay those that were written.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

VERSION = 2

Step = Callable[[str, Mapping[str, Any]], Mapping[str, Any]]


def upcast(version: int, kind: str, data: Mapping[str, Any]) -> Mapping[str, Any]:
    """An event's data as the version of today has it; ``version`` is one that there was."""
    for older in range(version, VERSION):
        data = STEPS[older](kind, data)
    return data


def _to_2(kind: str, data: Mapping[str, Any]) -> Mapping[str, Any]:
    """Version 2 knows branches: the header names the session that one came from."""
    return {**data, "parent": None} if kind == "header" else data


STEPS: Mapping[int, Step] = {1: _to_2}
"""How events of each earlier version become those of the next."""
