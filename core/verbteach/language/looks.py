"""What can be said of an object without pointing: its names, its looks, how it is just now.

Knows a scene, a state and a lexicon; no sentence and no noun phrase. Which
words describe a state ("open") or a relation ("next to") it reads off the
lexicon's wording of the fluents, so that any domain's predicates will do.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

from verbteach.language.fallback import fluent_wording
from verbteach.language.lexicon import FluentWording, Lexicon
from verbteach.language.names import Names, complement
from verbteach.world.fluents import Fluent, State
from verbteach.world.scene import Scene, SceneObject


@dataclass(frozen=True, eq=False)
class Looks:
    """The words for the objects of ``scene`` in ``state``; equal to itself only."""

    scene: Scene
    state: State
    lexicon: Lexicon

    @staticmethod
    def at(scene: Scene, state: State, lexicon: Lexicon) -> Looks:
        """The words for a state; those of the last few states are remembered."""
        return _last(Names.of(scene, lexicon), state)

    @property
    def objects(self) -> Mapping[str, SceneObject]:
        """Every object that can be spoken of."""
        return self.scene.objects

    # --- names ----------------------------------------------------------

    @cached_property
    def names(self) -> Names:
        """What the objects are called, whatever the state."""
        return Names.of(self.scene, self.lexicon)

    def fit(self, object_id: str, noun: str) -> float:
        """How well ``noun``, which may be several words, names the object; 0 not at all."""
        return self.names.fitting(noun).get(object_id, 0.0)

    def is_thing(self, object_id: str) -> bool:
        """Whether the object is a thing in the room, not one of the domain's values."""
        return object_id not in self.scene.domain.constants

    # --- looks and states -----------------------------------------------

    def has_mark(self, object_id: str, word: str) -> bool:
        """Whether ``word`` describes the object: an attribute, part of a name, or its state."""
        meant = self.names.meant_by(word)
        return any(
            word in marks or not meant.isdisjoint(marks)
            for marks in (self.names.lasting_marks(object_id), self._passing_marks(object_id))
        )

    @cached_property
    def _passing_marks(self) -> Callable[[str], frozenset[str]]:
        return cache(lambda thing: frozenset(self._passing(thing)))

    def _passing(self, object_id: str) -> Iterator[str]:
        """What describes the object only now: "open", "clean", and what it is full of."""
        about = self._about.get(object_id, ())
        held = {f.predicate for f in about if f.args == (object_id,)}
        for predicate, said, denied in self.names.adjectives:
            word = said if predicate in held else denied
            if word:
                yield word
        for fluent in about:
            for arg in fluent.args[1:]:
                if arg in self.objects and not self.is_thing(arg):
                    yield from self.names.of_things[arg]

    def states(self, object_id: str) -> tuple[str, ...]:
        """Adjectives of the fluents that are true of the object, in the order of their names."""
        found = (
            complement(self.lexicon.fluents[fluent.predicate].is_true)
            for fluent in self._about.get(object_id, ())
            if fluent.args == (object_id,) and fluent.predicate in self.lexicon.fluents
        )
        return tuple(word for word in found if word and " " not in word)

    # --- relations --------------------------------------------------------

    def related(self, object_id: str, preposition: str, other: str) -> bool:
        """Whether a fluent puts the object in that relation to ``other`` now."""
        return any(fluent in self.state for fluent in self.relating(object_id, preposition, other))

    def relating(self, object_id: str, preposition: str, other: str) -> Iterator[Fluent]:
        """The fluents, true or not, that put the object in that relation to ``other``."""
        wanted = _SAME_PREPOSITION.get(preposition, (preposition,))
        for predicate, words, swapped in self._relations:
            if words in wanted:
                yield Fluent(predicate, (other, object_id) if swapped else (object_id, other))

    @cached_property
    def prepositions(self) -> frozenset[str]:
        """The words, one or several, that may stand for a relation: "in", "next to", "holding"."""
        return frozenset(_SAME_PREPOSITION) | {words for _, words, _ in self._relations}

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


@lru_cache(maxsize=64)
def _last(names: Names, state: State) -> Looks:
    return Looks(names.scene, state, names.lexicon)


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
