"""What can be said of an object without pointing: its names, its looks, how it is just now.

Knows a scene, a state and a lexicon; no sentence and no noun phrase. Which
words describe a state ("open") or a relation ("next to") it reads off the
lexicon's wording of the fluents, so that any domain's predicates will do.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property

from verbteach.language.fallback import fluent_wording
from verbteach.language.lexicon import FluentWording, Lexicon
from verbteach.language.morphology import plural
from verbteach.world.fluents import Fluent, State
from verbteach.world.scene import Scene, SceneObject

GENERIC = frozenset({"thing", "object", "item", "one", "stuff", "something", "everything"})

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

    # --- names ----------------------------------------------------------

    def fit(self, object_id: str, noun: str) -> float:
        """How well ``noun``, which may be several words, names the object; 0 not at all."""
        return self._best_fit(object_id, noun)

    @cached_property
    def _best_fit(self) -> Callable[[str, str], float]:
        return cache(lambda object_id, noun: max(self._fits(object_id, noun), default=0.0))

    def _fits(self, object_id: str, noun: str) -> Iterator[float]:
        names = self._names[object_id]
        if noun == object_id.lower() or noun in names[:1]:
            yield FIRST_NAME
        if noun in names:
            yield OTHER_NAME
        if any(name.endswith(f" {noun}") for name in names):
            yield LAST_WORD
        if not self._meant_by(noun).isdisjoint(names):
            yield SYNONYM
        if self.scene.domain.is_a(self.objects[object_id].type.lower(), noun):
            yield KIND
        if noun in GENERIC and self.is_thing(object_id):
            yield ANYTHING

    @cached_property
    def _names(self) -> Mapping[str, tuple[str, ...]]:
        return {thing.id: tuple(map(_plain, thing.names)) for thing in self.objects.values()}

    @cached_property
    def _meant_by(self) -> Callable[[str], frozenset[str]]:
        """Words that a noun may stand for; the group's plural names its kinds ("dishes")."""
        synonyms, none = self.lexicon.synonyms, frozenset[str]()
        return cache(lambda noun: synonyms.get(noun, none) | synonyms.get(plural(noun), none))

    def is_thing(self, object_id: str) -> bool:
        """Whether the object is a thing in the room, not one of the domain's values."""
        return object_id not in self.scene.domain.constants

    # --- looks and states -----------------------------------------------

    def has_mark(self, object_id: str, word: str) -> bool:
        """Whether ``word`` describes the object: an attribute, part of a name, or its state."""
        marks = self._marks[object_id]
        return word in marks or not self._meant_by(word).isdisjoint(marks)

    @cached_property
    def _marks(self) -> Mapping[str, frozenset[str]]:
        return {name: frozenset(self._all_marks(name)) for name in self.objects}

    def _all_marks(self, object_id: str) -> Iterator[str]:
        for value in self.objects[object_id].attributes.values():
            yield value.lower()
        for name in self._names[object_id]:
            yield from name.split(" ")
        yield from self._adjectives(object_id)
        for fluent in self._about.get(object_id, ()):
            for arg in fluent.args[1:]:
                if arg in self.objects and not self.is_thing(arg):
                    yield from self._names[arg]

    def _adjectives(self, object_id: str) -> Iterator[str]:
        """What the wording of the one-place fluents says of the object now: "open", "clean"."""
        held = {f.predicate for f in self._about.get(object_id, ()) if f.args == (object_id,)}
        for predicate, wording in self.lexicon.fluents.items():
            if len(self._parameters(predicate)) == 1:
                said = _complement(wording.is_true if predicate in held else wording.is_false)
                if said:
                    yield said

    def states(self, object_id: str) -> tuple[str, ...]:
        """Adjectives of the fluents that are true of the object, in the order of their names."""
        found = (
            _complement(self.lexicon.fluents[fluent.predicate].is_true)
            for fluent in self._about.get(object_id, ())
            if fluent.args == (object_id,) and fluent.predicate in self.lexicon.fluents
        )
        return tuple(word for word in found if word and " " not in word)

    # --- relations --------------------------------------------------------

    def related(self, object_id: str, preposition: str, other: str) -> bool:
        """Whether a fluent puts the object in that relation to ``other`` now."""
        wanted = _SAME_PREPOSITION.get(preposition, (preposition,))
        return any(
            Fluent(predicate, (other, object_id) if swapped else (object_id, other)) in self.state
            for predicate, words, swapped in self._relations
            if words in wanted
        )

    def place(self, object_id: str) -> tuple[str, str] | None:
        """Where the object is, as a preposition and the object it stands in relation to."""
        for predicate, words, swapped in self._relations:
            if swapped or words not in _PLACES:
                continue
            for fluent in self._about.get(object_id, ()):
                if fluent.predicate == predicate and fluent.args[0] == object_id:
                    return words, fluent.args[1]
        return None

    def holds(self, object_id: str) -> tuple[str, ...]:
        """The domain's values that the object is "with": what a cup has in it."""
        return tuple(
            other
            for other in self.objects
            if not self.is_thing(other) and self.related(object_id, "with", other)
        )

    @cached_property
    def _about(self) -> Mapping[str, tuple[Fluent, ...]]:
        found: dict[str, list[Fluent]] = {}
        for fluent in sorted(self.state):
            for arg in dict.fromkeys(fluent.args):
                found.setdefault(arg, []).append(fluent)
        return {name: tuple(fluents) for name, fluents in found.items()}

    def _parameters(self, predicate: str) -> tuple[object, ...]:
        found = self.scene.domain.predicates.get(predicate)
        return tuple(found.parameters) if found else ()

    @cached_property
    def _relations(self) -> tuple[tuple[str, str, bool], ...]:
        """Two-place predicates with the words that stand between their arguments."""
        found = []
        for predicate, declared in self.scene.domain.predicates.items():
            if len(declared.parameters) == 2:
                wording = self.lexicon.fluents.get(predicate) or fluent_wording(predicate, 2)
                words = _between(wording)
                found += [(predicate, *words)] if words else []
        return tuple(found)


_SAME_PREPOSITION = {
    "inside": ("in",),
    "within": ("in",),
    "into": ("in",),
    "onto": ("on",),
    "on top of": ("on",),
    "on": ("on", "standing on"),
    "beside": ("next to", "near"),
    "by": ("next to", "near"),
    "at": ("next to", "near", "on"),
    "near": ("near", "next to"),
    "close to": ("near", "next to"),
    "closest to": ("near", "next to"),
    "nearest to": ("near", "next to"),
    "next to": ("next to", "near"),
    "alongside": ("next to", "near"),
    "of": ("with",),
    "from": ("on", "in"),
    "off": ("on",),
    "out of": ("in",),
}
"""For a preposition, the words of the fluents that it may stand for."""
_PLACES = ("on", "in", "next to")
_NOT_ADJECTIVES = frozenset({"not", "no"})


def _plain(name: str) -> str:
    """A name as noun phrases have it: "child chair" for "child's chair"."""
    return name.lower().replace("'s ", " ")


def _complement(sentence: str) -> str:
    """What stands behind "{0} is" or "{0} has been": "open", "not hot"; else nothing."""
    for copula in ("{0} is ", "{0} has been "):
        if sentence.startswith(copula):
            return sentence.removeprefix(copula)
    return ""


def _between(wording: FluentWording) -> tuple[str, bool] | None:
    """The words between the arguments of "{0} is on {1}"; swapped in "{1} is in {0}".

    A substance is *in* its vessel, and the vessel is *with* the substance.
    """
    sentence = wording.is_true
    if sentence in {"{1} is in {0}", "{0} contains {1}", "{0} has {1}", "{0} holds {1}"}:
        return "with", False
    if re.fullmatch(r"the \w+ of \{0\} is \{1\}", sentence):
        return "with", False
    if sentence.startswith("{0} is ") and sentence.endswith(" {1}"):
        return sentence.removeprefix("{0} is ").removesuffix(" {1}"), False
    return None
