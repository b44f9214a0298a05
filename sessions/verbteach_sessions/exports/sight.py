"""A scene as an export shows it: places, what is in and on them, in words.

How a scene is depicted is the interface's business; whoever asks for an export
that shows scenes hands in a :data:`Depict`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any, TypeAlias

from verbteach.world.fluents import State
from verbteach.world.scene import Scene


@dataclass(frozen=True)
class SeenThing:
    """An object: its name, how it lies to what is around it, its conditions, what it holds."""

    label: str
    relation: str = ""
    conditions: tuple[str, ...] = ()
    contents: tuple[SeenThing, ...] = ()


@dataclass(frozen=True)
class SeenActor:
    """The robot or a person: what it is near, and what it holds."""

    label: str
    near: tuple[str, ...] = ()
    holds: tuple[SeenThing, ...] = ()


@dataclass(frozen=True)
class Sight:
    """A scene at one moment. ``others`` have nothing in or on them."""

    title: str
    actors: tuple[SeenActor, ...] = ()
    places: tuple[SeenThing, ...] = ()
    others: tuple[SeenThing, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """The fields, all the way down."""
        return asdict(self)


Depict: TypeAlias = Callable[[Scene, State], Sight]
