"""A scene: a domain, the objects in it with what they look like, and how it starts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from verbteach.world.domain import Domain
from verbteach.world.fluents import State


@dataclass(frozen=True)
class SceneObject:
    """One object.

    ``names`` are the noun phrases people use for it, the best first ("mug",
    "coffee cup"). ``attributes`` maps an attribute's kind to its value, such
    as ``{"colour": "red", "material": "ceramic", "size": "small"}``.
    """

    id: str
    type: str
    names: tuple[str, ...] = ()
    attributes: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Scene:
    """A room as the person and the robot find it. ``objects`` includes the domain's constants."""

    id: str
    room: str
    title: str
    domain: Domain
    objects: Mapping[str, SceneObject]
    initial: State

    def affordances(self, object_id: str) -> frozenset[str]:
        """The object's type and the static one-place predicates true of it."""
        static = self.domain.static
        marks = {f.predicate for f in self.initial if f.args == (object_id,)} & static
        return frozenset(marks | {self.objects[object_id].type})
