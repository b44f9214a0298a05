"""What can be said of an object without pointing: its names, its looks, how it is just now.

Knows a scene, a state and a lexicon; no sentence and no noun phrase.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from verbteach.language.lexicon import FluentWording, Lexicon
from verbteach.world.fluents import Fluent, State
from verbteach.world.scene import Scene, SceneObject

GENERIC = frozenset({"thing", "object", "item", "one", "stuff", "something"})

# How well a noun fits a name: the name itself, one of the other names, only the
# name's last word, a word for the same, the kind of thing.
FIRST_NAME, OTHER_NAME, LAST_WORD, SYNONYM, KIND, ANYTHING = 1.0, 0.5, 0.4, 0.3, 0.25, 0.2


@dataclass(frozen=True)
class Looks:
    """The words for the objects of ``scene`` in ``state``."""

    scene: Scene
    state: State
    lexicon: Lexicon

    @property
    def objects(self) -> Mapping[str, SceneObject]:
        """Every object that can be spoken of."""
        return self.scene.objects

    def fit(self, object_id: str, noun: str) -> float:
        """How well ``noun``, which may be several words, names the object; 0 not at all."""
        return max(self._fits(self.objects[object_id], noun), default=0.0)

    def _fits(self, thing: SceneObject, noun: str) -> Iterator[float]:
        names = [_plain(name) for name in thing.names]
        if noun in {thing.id.lower(), *names[:1]}:
            yield FIRST_NAME
        if noun in names:
            yield OTHER_NAME
        if any(name.endswith(f" {noun}") for name in names):
            yield LAST_WORD
        if self.lexicon.synonyms.get(noun, frozenset()).intersection(names):
            yield SYNONYM
        if noun == thing.type.lower():
            yield KIND
        if noun in GENERIC and self.is_thing(thing.id):
            yield ANYTHING

    def is_thing(self, object_id: str) -> bool:
        """Whether the object is a thing in the room, not one of the domain's values."""
        return object_id not in self.scene.domain.constants

    def has_mark(self, object_id: str, word: str) -> bool:
        """Whether ``word`` describes the object: an attribute, part of a name, or its state."""
        thing = self.objects[object_id]
        word = _SAME_MARK.get(word, word)
        if word in {value.lower() for value in thing.attributes.values()}:
            return True
        if any(word in _plain(name).split() for name in thing.names):
            return True
        return word in self._now.get(object_id, ()) or self._holds_substance(object_id, word)

    def related(self, object_id: str, preposition: str, other: str) -> bool:
        """Whether a fluent puts the object in that relation to ``other`` now."""
        wanted = _SAME_PREPOSITION.get(preposition, preposition)
        return any(
            Fluent(predicate, pair) in self.state
            for predicate, words, swapped in self._relations
            if words == wanted
            for pair in (((other, object_id) if swapped else (object_id, other)),)
        )

    def place(self, object_id: str) -> tuple[str, str] | None:
        """Where the object is, as a preposition and the object it stands in relation to."""
        for predicate, words, swapped in self._relations:
            if swapped or words not in _PLACES:
                continue
            for fluent in sorted(self._about.get(object_id, ())):
                if fluent.predicate == predicate and fluent.args[0] == object_id:
                    return words, fluent.args[1]
        return None

    def _holds_substance(self, object_id: str, word: str) -> bool:
        return any(
            word in self.objects[arg].names
            for fluent in self._about.get(object_id, ())
            for arg in fluent.args
            if arg in self.objects and not self.is_thing(arg)
        )

    @cached_property
    def _about(self) -> Mapping[str, tuple[Fluent, ...]]:
        found: dict[str, list[Fluent]] = {}
        for fluent in sorted(self.state):
            for arg in fluent.args:
                found.setdefault(arg, []).append(fluent)
        return {name: tuple(fluents) for name, fluents in found.items()}

    @cached_property
    def _now(self) -> Mapping[str, frozenset[str]]:
        """For each object the adjectives that its one-place fluents say of it now."""
        return {name: frozenset(self._adjectives(name)) for name in self.objects}

    def _adjectives(self, object_id: str) -> Iterator[str]:
        held = {f.predicate for f in self._about.get(object_id, ()) if f.args == (object_id,)}
        for predicate, wording in self.lexicon.fluents.items():
            if len(self._parameters(predicate)) == 1:
                yield _complement(wording.is_true if predicate in held else wording.is_false)

    def _parameters(self, predicate: str) -> tuple[object, ...]:
        found = self.scene.domain.predicates.get(predicate)
        return tuple(found.parameters) if found else ()

    @cached_property
    def _relations(self) -> tuple[tuple[str, str, bool], ...]:
        """Two-place predicates with the words that stand between their arguments."""
        found = []
        for predicate, wording in self.lexicon.fluents.items():
            words = _between(wording)
            if words and len(self._parameters(predicate)) == 2:
                found.append((predicate, *words))
        return tuple(found)


_SAME_PREPOSITION = {
    "inside": "in", "within": "in", "into": "in", "onto": "on", "upon": "on", "on top of": "on",
    "beside": "next to", "by": "next to", "at": "next to", "near": "next to", "of": "with",
    "containing": "with", "full of": "with",
}  # fmt: skip
_SAME_MARK = {
    "big": "large", "huge": "large", "tall": "large", "little": "small", "tiny": "small",
    "gray": "grey", "golden": "gold", "wood": "wooden", "metallic": "metal", "dark": "black",
    "right-hand": "right", "left-hand": "left", "upper": "top", "lower": "bottom", "shut": "closed",
}  # fmt: skip
_PLACES = ("on", "in", "next to")


def _plain(name: str) -> str:
    """A name as noun phrases have it: "child chair" for "child's chair"."""
    return name.lower().replace("'s ", " ")


def _complement(sentence: str) -> str:
    """What stands behind "{0} is": "open"."""
    return sentence.removeprefix("{0} is ").removeprefix("{0} has been ")


def _between(wording: FluentWording) -> tuple[str, bool] | None:
    """The words between the arguments of "{0} is on {1}"; swapped in "{1} is in {0}".

    A substance is *in* its vessel, and the vessel is *with* the substance.
    """
    sentence = wording.is_true
    if sentence.startswith("{0} is ") and sentence.endswith(" {1}"):
        return sentence.removeprefix("{0} is ").removesuffix(" {1}"), False
    if sentence == "{1} is in {0}":
        return "with", False
    return None
