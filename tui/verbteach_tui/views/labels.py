"""Short names for a scene's objects, no two alike: "red mug", "left drawer", "shelf 2"."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from functools import cached_property
from itertools import combinations

from verbteach.world.scene import Scene, SceneObject
from verbteach_tui.views.visible import visible

_WORDS = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+")


def from_id(object_id: str) -> str:
    """An object's id as words: ``StoveKnob_1`` becomes "stove knob 1"."""
    words = _WORDS.findall(object_id)
    return " ".join(words).lower() if words else visible(object_id)


class Labels:
    """The objects' short names, and the way back from a name to its object."""

    def __init__(self, objects: Mapping[str, SceneObject], values: Collection[str] = ()) -> None:
        self._objects = objects
        self._values = values

    @classmethod
    def of(cls, scene: Scene) -> Labels:
        """The labels of everything in ``scene``; constants such as Water keep their own names."""
        return cls(scene.objects, scene.domain.constants)

    def __getitem__(self, object_id: str) -> str:
        return self._labels.get(object_id) or from_id(object_id)

    def find(self, text: str) -> str | None:
        """The id of the object that ``text`` names exactly, by id or label; ``None`` if none."""
        wanted = " ".join(text.casefold().split())
        return self._found.get(wanted)

    @cached_property
    def _found(self) -> dict[str, str]:
        named = {label.casefold(): key for key, label in self._labels.items()}
        return named | {key.casefold(): key for key in self._objects}

    @cached_property
    def _labels(self) -> dict[str, str]:
        groups: dict[str, list[SceneObject]] = {}
        for thing in self._objects.values():
            if thing.id not in self._values:
                groups.setdefault(_name(thing), []).append(thing)
        labels: dict[str, str] = {}
        for name, things in groups.items():
            labels.update(_told_apart(name, things))
        named = {key: _name(self._objects[key]) for key in self._values if key in self._objects}
        return named | _made_unique(labels)


def _name(thing: SceneObject) -> str:
    return visible(thing.names[0]) if thing.names else from_id(thing.id)


def _told_apart(name: str, things: list[SceneObject]) -> dict[str, str]:
    """Each thing by the fewest attributes that no namesake shares, else by a number."""
    if len(things) == 1:
        return {things[0].id: name}
    labels = {}
    for number, thing in enumerate(things, 1):
        phrase = _fewest(thing, [other for other in things if other is not thing])
        labels[thing.id] = f"{phrase} {name}" if phrase else f"{name} {number}"
    return labels


def _fewest(thing: SceneObject, others: Iterable[SceneObject]) -> str:
    kinds = list(thing.attributes)
    rest = list(others)
    for size in range(1, len(kinds) + 1):
        for chosen in combinations(kinds, size):
            same = {kind: thing.attributes[kind] for kind in chosen}
            if not any(same.items() <= dict(other.attributes).items() for other in rest):
                return visible(" ".join(same.values()))
    return ""


def _made_unique(labels: dict[str, str]) -> dict[str, str]:
    counts = Counter(label.casefold() for label in labels.values())
    return {
        key: label if counts[label.casefold()] == 1 else f"{label} ({key})"
        for key, label in labels.items()
    }
