"""A scene's fingerprint: whether it is still the one in which a session was held."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

from verbteach.world.scene import Scene
from verbteach_sessions.lines import canonical, digest


def scene_digest(scene: Scene) -> str:
    """SHA-256 over all that a scene and its domain say."""
    return digest(canonical(_plain(scene)))


def _plain(value: Any) -> Any:
    if is_dataclass(value):
        return [_plain(getattr(value, field.name)) for field in fields(value)]
    if isinstance(value, Mapping):
        return [[str(key), _plain(value[key])] for key in sorted(value)]
    if isinstance(value, frozenset):
        return sorted((_plain(item) for item in value), key=canonical)
    if isinstance(value, tuple | list):
        return [_plain(item) for item in value]
    return value if value is None or isinstance(value, bool | int | float) else str(value)
