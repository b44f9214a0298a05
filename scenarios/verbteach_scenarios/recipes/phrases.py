"""How people name a thing: by a name, and by as many looks as it takes, more or less."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from verbteach.language.morphology import article, is_plural, plural
from verbteach.world.fluents import Fluent
from verbteach.world.scene import Scene, SceneObject

ORDER = ("position", "size", "pattern", "colour", "material")
"""The order in which English puts what a thing looks like before its name."""

_PARTICLES = frozenset({"up", "down"})

_AMBIGUOUS, _GENEROUS = 0.12, 0.2


@dataclass(frozen=True)
class Description:
    """A name with looks before it, and how many things of the scene it fits."""

    words: tuple[str, ...]
    fits: int

    @property
    def text(self) -> str:
        """The words without a determiner."""
        return " ".join(self.words)


def descriptions(scene: Scene, object_id: str, state: str = "") -> Iterator[Description]:
    """Every name of the object with up to two looks, in a fixed order."""
    thing = scene.objects[object_id]
    for name in thing.names:
        if _PARTICLES & set(name.split()) and len(thing.names) > 1:
            continue
        spare = [k for k in ORDER if _tells_more(thing, k, name)]
        for count in range(3):
            for kinds in combinations(spare, count):
                if "position" in kinds and count > 1:
                    continue
                looks = tuple(thing.attributes[kind] for kind in kinds)
                fits = sum(
                    _fits(other, name, kinds, looks) and _is(scene, other.id, state)
                    for other in scene.objects.values()
                )
                words = ((state,) if state else ()) + looks + (name,)
                yield Description(words, fits)


def definite(
    scene: Scene, object_id: str, rng: np.random.Generator, state: str = ""
) -> Description:
    """Mostly as few words as tell the thing apart; sometimes more, and sometimes too few."""
    found = list(descriptions(scene, object_id, state))
    mood = rng.random()
    if mood < _AMBIGUOUS:
        return _one([d for d in found if len(d.words) == len(found[0].words)], rng)
    least = min(d.fits for d in found)
    telling = [d for d in found if d.fits == least]
    shortest = min(len(d.words) for d in telling)
    wanted = shortest + (mood < _AMBIGUOUS + _GENEROUS)
    return _one([d for d in telling if len(d.words) == wanted] or telling[:1], rng)


def placed(scene: Scene, object_id: str, rng: np.random.Generator) -> str | None:
    """``mug on the kitchen table``: by where it is; none where it is nowhere to speak of."""
    where = sorted(
        f for f in scene.initial if f.predicate in ("on", "in") and f.args[0] == object_id
    )
    if not where or Fluent("stowed", (object_id,)) in scene.initial:
        return None
    place = definite(scene, where[0].args[1], rng)
    name = scene.objects[object_id].names[0]
    return f"{name} {where[0].predicate} the {place.text}"


def with_determiner(text: str, form: str) -> str:
    """``the mug``, ``some milk``, ``a mug`` or ``milk``, as the saying's slot wants it."""
    if form == "some":
        return f"some {text}"
    if form == "bare":
        return text
    return f"{article(text)} {text}" if form == "a" else f"the {text}"


def of_many(scene: Scene, objects: Sequence[str], rng: np.random.Generator, state: str = "") -> str:
    """The plural of a name that all the objects share."""
    bearers = {
        name: sum(name in other.names for other in scene.objects.values())
        for name in scene.objects[objects[0]].names
        if all(name in scene.objects[other].names for other in objects)
    }
    shared = [name for name in bearers if bearers[name] == min(bearers.values())]
    name = shared[int(rng.integers(len(shared)))]
    return f"the {state + ' ' if state else ''}{plural(name)}"


def _one(found: Sequence[Description], rng: np.random.Generator) -> Description:
    return found[int(rng.integers(len(found)))]


def _tells_more(thing: SceneObject, kind: str, name: str) -> bool:
    look, words = thing.attributes.get(kind), name.split()
    says_enough = "of" in words or thing.attributes.get("position") in words or is_plural(name)
    says_enough |= kind == "material" and len(words) > 1
    return look is not None and look not in words and not says_enough


def _fits(thing: SceneObject, name: str, kinds: Sequence[str], looks: Sequence[str]) -> bool:
    seen = zip(kinds, looks, strict=True)
    return name in thing.names and all(thing.attributes.get(k) == look for k, look in seen)


def _is(scene: Scene, object_id: str, state: str) -> bool:
    return not state or Fluent(state, (object_id,)) in scene.initial
