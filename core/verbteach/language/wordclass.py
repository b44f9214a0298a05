"""What kind of word a word can be: general English, the lexicon and the scene's nouns together."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import TypeAlias

from verbteach.language import household, words
from verbteach.language.inflection import base_of_gerund
from verbteach.language.lexicon import Lexicon
from verbteach.language.morphology import singular
from verbteach.language.particles import PARTICLES_OF

_CLOSED = (
    words.DETERMINERS
    | words.POSSESSIVES
    | words.PREDETERMINERS
    | words.OBJECT_PRONOUNS
    | words.SUBJECT_PRONOUNS
    | words.CONJUNCTIONS
    | words.SUBORDINATORS
    | words.RELATIVES
    | words.AUXILIARIES
    | words.PREPOSITIONS
    | words.PARTICLES
    | words.PLACE_ADVERBS
    | frozenset({",", ".", "'s", "'", "not", "n't"})
)
_VERBS_AMONG_CLOSED = frozenset({"do", "have", "like", "can"})


class WordClasses:
    """Answers what a word may be. A word may be several things, or unknown to all lists."""

    def __init__(self, lexicon: Lexicon, vocabulary: Iterable[str] = ()) -> None:
        self._taught = _taught_verbs(tuple(lexicon.verbs), tuple(lexicon.particles))
        self.verbs: frozenset[str] = _known_verbs(self._taught)
        self._scene_nouns, self._joined = _scene_words((*vocabulary, *lexicon.synonyms))
        self._adjectives = lexicon.attributes
        self._lexicon = lexicon

    def joined(self, tokens: Sequence[str]) -> list[str]:
        """The tokens with each name that holds a particle ("channel up button") as one token."""
        if not self._joined:
            return list(tokens)
        found: list[str] = []
        index = 0
        while index < len(tokens):
            names = self._joined.get(tokens[index], ())
            name = next((n for n in names if tuple(tokens[index : index + len(n)]) == n), None)
            found.append(" ".join(name) if name else tokens[index])
            index += len(name) if name else 1
        return found

    def is_open(self, word: str) -> bool:
        """Whether ``word`` is no function word: it could be a noun, a verb or an adjective."""
        return word[:1].isalpha() and word not in _CLOSED

    def is_verb(self, word: str) -> bool:
        """Whether ``word`` is a known verb in its base form."""
        return word in self.verbs

    def is_taught_verb(self, word: str) -> bool:
        """Whether the lexicon itself lists ``word`` as a verb."""
        return word in self._taught

    def is_noun(self, word: str) -> bool:
        """Whether ``word`` is a known noun, singular or plural."""
        if " " in word:
            return True
        if word in household.NOUNS or word in self._scene_nouns:
            return True
        single = singular(word)
        return single != word and (single in household.NOUNS or single in self._scene_nouns)

    def is_adjective(self, word: str) -> bool:
        """Whether ``word`` is a known adjective or an attribute of the lexicon."""
        return word in household.ADJECTIVES or word in self._adjectives or word in words.ORDINALS

    def is_adverb(self, word: str) -> bool:
        """Whether ``word`` only says how or when."""
        if word in words.ADVERBS:
            return True
        return word.endswith("ly") and len(word) > 4 and not self.is_known(word)

    def is_known(self, word: str) -> bool:
        """Whether any list has the word as a noun, a verb or an adjective."""
        return self.is_noun(word) or self.is_verb(word) or self.is_adjective(word)

    def is_number(self, word: str) -> bool:
        """Whether ``word`` counts: digits or a number word."""
        return word[:1].isdigit() or word in words.NUMBERS

    def may_be_verb(self, word: str) -> bool:
        """Whether ``word`` could be a verb at all, known or not."""
        return self.is_open(word) or word in _VERBS_AMONG_CLOSED

    def gerund_base(self, word: str) -> str | None:
        """The verb of which ``word`` is the -ing form, or None."""
        return None if word in household.NOUNS else base_of_gerund(word, self.verbs)

    def takes_particle(self, verb: str, particle: str) -> bool:
        """Whether ``verb particle`` is a known verb of its own."""
        known = PARTICLES_OF.get(verb, frozenset())
        return particle in known or particle in self._lexicon.particles.get(verb, frozenset())

    def head(self, word: str) -> str:
        """The singular under which a noun is kept; a scene's own plural name stays as it is."""
        single = singular(word)
        return word if word in self._scene_nouns and single not in self._scene_nouns else single


_Names: TypeAlias = Mapping[str, tuple[tuple[str, ...], ...]]


# A person's commands come one after the other in one scene: its words are sorted once.
@lru_cache(maxsize=16)
def _taught_verbs(verbs: tuple[str, ...], with_particles: tuple[str, ...]) -> frozenset[str]:
    return frozenset(verb.partition(" ")[0] for verb in (*verbs, *with_particles))


@lru_cache(maxsize=16)
def _known_verbs(taught: frozenset[str]) -> frozenset[str]:
    return household.VERBS | taught


@lru_cache(maxsize=16)
def _scene_words(names: tuple[str, ...]) -> tuple[frozenset[str], _Names]:
    """The single words of all names, and the names that hold a particle by their first word."""
    split = sorted({tuple(name.lower().split()) for name in names}, key=lambda n: (-len(n), n))
    telling = [
        n for n in split if n and n[0] not in _CLOSED and not words.PARTICLES.isdisjoint(n[1:-1])
    ]
    joined = {n[0]: tuple(m for m in telling if m[0] == n[0]) for n in telling}
    return frozenset(word for name in split for word in name), joined
