"""What the things of a scene are called, however they are just now.

Names, words for the same and what never changes about a thing. It holds for
every state of a scene, so it is worked out once for a scene and a lexicon.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

from verbteach.language.lexicon import Lexicon
from verbteach.language.morphology import plural
from verbteach.world.scene import Scene

GENERIC = frozenset({"thing", "object", "item", "one", "stuff", "something", "everything"})

# How well a noun fits a name: the name itself, one of the other names, only the
# name's last word, a word for the same, the kind of thing.
FIRST_NAME, OTHER_NAME, LAST_WORD, SYNONYM, KIND, ANYTHING = 1.0, 0.5, 0.4, 0.3, 0.25, 0.2


@dataclass(frozen=True, eq=False)
class Names:
    """The names in ``scene`` as ``lexicon`` has them."""

    scene: Scene
    lexicon: Lexicon

    @staticmethod
    def of(scene: Scene, lexicon: Lexicon) -> Names:
        """The names, the same object for the same scene and lexicon."""
        return _known(_Same(scene, lexicon))

    @cached_property
    def of_things(self) -> Mapping[str, tuple[str, ...]]:
        """Every object's names as noun phrases have them, its first name first."""
        objects = self.scene.objects.values()
        return {thing.id: tuple(map(_plain, thing.names)) for thing in objects}

    @cached_property
    def fitting(self) -> Callable[[str], Mapping[str, float]]:
        """The objects that a noun, which may be several words, names, and how well it does."""
        return cache(self._fitting)

    def _fitting(self, noun: str) -> dict[str, float]:
        meant = self.meant_by(noun)
        fits = (
            (thing, max(self._fits(thing, noun, meant), default=0.0)) for thing in self.of_things
        )
        return {thing: fit for thing, fit in fits if fit}

    def _fits(self, object_id: str, noun: str, meant: frozenset[str]) -> Iterator[float]:
        names = self.of_things[object_id]
        if noun == object_id.lower() or noun in names[:1]:
            yield FIRST_NAME
        if noun in names:
            yield OTHER_NAME
        if any(name.endswith(f" {noun}") for name in names):
            yield LAST_WORD
        if not meant.isdisjoint(names):
            yield SYNONYM
        if self.scene.domain.is_a(self.scene.objects[object_id].type.lower(), noun):
            yield KIND
        if noun in GENERIC and object_id not in self.scene.domain.constants:
            yield ANYTHING

    @cached_property
    def meant_by(self) -> Callable[[str], frozenset[str]]:
        """Words that a noun may stand for; the group's plural names its kinds ("dishes")."""
        synonyms, none = self.lexicon.synonyms, frozenset[str]()
        return cache(lambda noun: synonyms.get(noun, none) | synonyms.get(plural(noun), none))

    @cached_property
    def lasting_marks(self) -> Callable[[str], frozenset[str]]:
        """What describes an object in every state: its attributes and the words of its names."""
        return cache(lambda thing: frozenset(self._lasting(thing)))

    def _lasting(self, object_id: str) -> Iterator[str]:
        for value in self.scene.objects[object_id].attributes.values():
            yield value.lower()
        for name in self.of_things[object_id]:
            yield from name.split(" ")

    @cached_property
    def adjectives(self) -> tuple[tuple[str, str, str], ...]:
        """One-place predicates with what their wording says of a thing: is "open", is "shut"."""
        declared = self.scene.domain.predicates
        return tuple(
            (predicate, complement(wording.is_true), complement(wording.is_false))
            for predicate, wording in self.lexicon.fluents.items()
            if predicate in declared and len(declared[predicate].parameters) == 1
        )

    def matching(self, nouns: Iterable[str]) -> tuple[str, ...]:
        """The objects that at least one of the nouns names."""
        return tuple(dict.fromkeys(thing for noun in nouns for thing in self.fitting(noun)))


def complement(sentence: str) -> str:
    """What stands behind "{0} is" or "{0} has been": "open", "not hot"; else nothing."""
    for copula in ("{0} is ", "{0} has been "):
        if sentence.startswith(copula):
            return sentence.removeprefix(copula)
    return ""


class _Same:
    """A scene and a lexicon, equal only to the same two: comparing them whole would take long."""

    def __init__(self, scene: Scene, lexicon: Lexicon) -> None:
        self.scene = scene
        self.lexicon = lexicon

    def __hash__(self) -> int:
        return hash((id(self.scene), id(self.lexicon)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _Same):
            return NotImplemented
        return self.scene is other.scene and self.lexicon is other.lexicon


@lru_cache(maxsize=64)
def _known(key: _Same) -> Names:
    return Names(key.scene, key.lexicon)


def _plain(name: str) -> str:
    """A name as noun phrases have it: "child chair" for "child's chair"."""
    return name.lower().replace("'s ", " ")
