"""Relative clauses, full and reduced: what follows a noun and says which one is meant."""

from __future__ import annotations

from dataclasses import replace

from verbteach.language import words
from verbteach.language.frames import NounPhrase
from verbteach.language.inflection import base_of_participle
from verbteach.language.phrases import FULL, HOLDING, NO_ENDS, PLACED, Ends, Phrases
from verbteach.language.wordlist import word_set

_FREE = frozenset({"whatever", "whichever", "whoever", "everything", "anything", "something"})
"""``throw away whatever is in the sink``: these need no relative pronoun."""
_HAS = frozenset({"has", "have", "had"})
_BECOME = frozenset({"been", "become", "gone", "turned", "got", "gotten", "grown"})
_FETCHED = word_set("took taken brought bought borrowed fetched got grabbed picked pulled removed")
"""``the cup you took from the shelf``: where it was taken from says which one is meant."""


class RelativePhrases(Phrases):
    """Noun phrases together with the relative clause behind their head."""

    def noun_phrase(self, index: int, ends: Ends = NO_ENDS) -> tuple[NounPhrase, int] | None:
        """The noun phrase at ``index`` with its relative clause, and the index after it."""
        base = self.base_phrase(index, ends)
        if base is None:
            return None
        phrase, after = base
        return self._postmodified(phrase, index, after)

    def _postmodified(self, phrase: NounPhrase, start: int, index: int) -> tuple[NounPhrase, int]:
        """Relative clauses, full or reduced, directly after the head."""
        while True:
            read = self._relative(phrase, index)
            if read is None:
                return phrase, index
            phrase, index = read
            phrase = replace(phrase, text=" ".join(self.tokens[start:index]).replace(" 's", "'s"))

    def _relative(self, phrase: NounPhrase, index: int) -> tuple[NounPhrase, int] | None:
        token = self.at(index)
        if token in words.RELATIVES:
            return self._relative_clause(phrase, index + 1)
        if self._begins_reduced_relative(index):
            return self._predicate(phrase, index)
        free = phrase.head in _FREE or phrase.determiner in _FREE
        if free and token in words.COPULAS:
            return self._predicate(phrase, index + 1)
        if token in words.SUBJECT_PRONOUNS and phrase.head not in words.PERSONS:
            return self._object_relative(phrase, index)
        return None

    def _relative_clause(self, phrase: NounPhrase, index: int) -> tuple[NounPhrase, int] | None:
        index = self._skip_adverbs(index)
        token = self.at(index)
        if token in words.SUBJECT_PRONOUNS:
            return self._object_relative(phrase, index)
        if token in {"do", "does", "did"} and self.at(index + 1) == "not":
            return self._related(phrase, "not with", index + 3)
        become = token in _HAS and self.at(index + 1) in _BECOME
        if become or token in words.COPULAS:
            return self._predicate(phrase, index + 1 + become)
        if token in {*_HAS, "contains", "holds"}:
            return self._related(phrase, "with", index + 1)
        if token.endswith("s") and self.preposition(index + 1) is not None:
            return self._predicate(phrase, index + 1)
        return None

    def _predicate(self, phrase: NounPhrase, index: int) -> tuple[NounPhrase, int] | None:
        """What follows ``that is``: a place, contents, a property."""
        negated = self.at(index) == "not"
        index = self._skip_adverbs(index + negated)
        token = self.at(index)
        if token in HOLDING or any(self.matches(index, full) for full in FULL):
            return self._related(phrase, "with", index + (1 if token in HOLDING else 2))
        placed = token in PLACED or (token.endswith("ing") and self.preposition(index + 1))
        place = self.preposition(index + 1 if placed else index)
        if place is not None and self.starts(place[1]):
            return self._related(phrase, f"not {place[0]}" if negated else place[0], place[1])
        return self._property(phrase, index, negated)

    def _property(
        self, phrase: NounPhrase, index: int, negated: bool
    ) -> tuple[NounPhrase, int] | None:
        token = self.at(index)
        if token in {"the", "a", "an"}:
            base = self.base_phrase(index)
            if base is None:
                return None
            said = (*base[0].modifiers, *(() if base[0].head == "one" else (base[0].head,)))
            return replace(phrase, modifiers=phrase.modifiers + said), base[1]
        if not token or not (self._open(index) or token in words.PARTICLES | words.PLACE_ADVERBS):
            return None
        word = f"not {token}" if negated else token
        phrase = replace(phrase, modifiers=(*phrase.modifiers, word))
        index += 1
        while self.at(index) == "and" and self.classes.is_adjective(self.at(index + 1)):
            if self.classes.is_verb(self.at(index + 1)):
                break
            phrase = replace(phrase, modifiers=(*phrase.modifiers, self.at(index + 1)))
            index += 2
        return phrase, index

    def _related(self, phrase: NounPhrase, name: str, index: int) -> tuple[NounPhrase, int] | None:
        base = self.base_phrase(index)
        if base is None:
            return None
        return replace(phrase, relations=(*phrase.relations, (name, base[0]))), base[1]

    def _object_relative(self, phrase: NounPhrase, index: int) -> tuple[NounPhrase, int] | None:
        """``the thing you are holding``: the subject and the verb's base become one modifier."""
        subject, index = self.at(index), index + 1
        index = self._skip_adverbs(index)
        while self.at(index) in words.AUXILIARIES:
            index = self._skip_adverbs(index + 1)
        verb = self.at(index)
        if not self.classes.is_open(verb):
            return None
        base = verb if self.classes.is_verb(verb) else self._uninflected(verb)
        said = f"{subject} {base}"
        after = index + 1 + (self.at(index + 1) in words.PERSONS)
        phrase = replace(phrase, modifiers=(*phrase.modifiers, said))
        source = self.preposition(after)
        if verb in _FETCHED and source is not None and source[0] in {"from", "out of"}:
            return self._related(phrase, *source) or (phrase, after)
        return phrase, after

    def _uninflected(self, verb: str) -> str:
        from_past = base_of_participle(verb, self.classes.verbs)
        return self.classes.gerund_base(verb) or from_past or verb

    def _skip_adverbs(self, index: int) -> int:
        while (after := self.adverb(index)) > index:
            index = after
        return index
