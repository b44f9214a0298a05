"""Noun phrases and prepositions at a place in a sentence: the lower half of the grammar.

Reads from a position and answers with what it read and where it ended; keeps
no position of its own and decides nothing about verbs or attachment.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from verbteach.language import household, words
from verbteach.language.frames import NounPhrase
from verbteach.language.morphology import is_plural, singular
from verbteach.language.wordclass import WordClasses
from verbteach.language.wordlist import word_set

END = ""
"""What stands after the last token."""

_HEADINGS = frozenset({"left", "right", "forward", "forwards", "backward", "backwards"})
_INTENSIFIERS = word_set("very really quite most more so too just only fully almost")
_MODIFYING_ADVERBS = word_set("next first last quick fast still even right same only safe")
_NOUNS_AMONG_CLOSED = frozenset({"home", "inside", "outside", "past", "back", "like"})
PLACED = word_set(
    "lying sitting standing hanging placed located stored kept resting left found put stuck "
    "leaning situated mounted stacked"
)
HOLDING = frozenset({"containing", "holding"})
FULL = (("full", "of"), ("filled", "with"), ("covered", "with"), ("covered", "in"))


class Ends(NamedTuple):
    """Where a noun phrase must stop although the next word could belong to it.

    ``verb``: before a verb that ends the clause ("let the water | boil").
    ``result``: before a state that ends the clause ("leave the door | open").
    """

    verb: bool = False
    result: bool = False


NO_ENDS = Ends()


class Phrases:
    """The phrases of one sentence."""

    def __init__(self, tokens: Sequence[str], classes: WordClasses) -> None:
        self.tokens = tokens
        self.classes = classes
        commas = [index for index, token in enumerate(tokens) if token == ","]
        self.last_comma = commas[-1] if commas else -1

    def at(self, index: int) -> str:
        """The token at ``index``, or the empty string past the end."""
        return self.tokens[index] if 0 <= index < len(self.tokens) else END

    def matches(self, index: int, phrase: Sequence[str]) -> bool:
        """Whether ``phrase`` stands at ``index``."""
        return list(self.tokens[index : index + len(phrase)]) == list(phrase)

    # --- function words -------------------------------------------------

    def adverb(self, index: int) -> int:
        """The index after an adverb or adverb phrase at ``index``; ``index`` if none is there."""
        token = self.at(index)
        for phrase in words.ADVERB_PHRASES.get(token, ()):
            if self.matches(index, phrase) and self.at(index + len(phrase)) != "of":
                return index + len(phrase)
        if not token or not self.classes.is_adverb(token):
            return index
        return index if self.is_compound(index) else index + 1

    def preposition(self, index: int) -> tuple[str, int] | None:
        """The role named by the preposition at ``index`` and the index after it."""
        token = self.at(index)
        for phrase in words.COMPOUND_PREPOSITIONS.get(token, ()):
            if self.matches(index, phrase):
                name = " ".join(phrase)
                return words.PREPOSITION_ROLES.get(name, name), index + len(phrase)
        if token in words.PREPOSITIONS:
            return words.PREPOSITION_ROLES.get(token, token), index + 1
        return None

    def is_compound(self, index: int) -> bool:
        """Whether a preposition of several words begins at ``index`` ("next to")."""
        found = self.preposition(index)
        return found is not None and found[1] > index + 1

    def place_adverb(self, index: int) -> int:
        """The index after "there", "over here"; ``index`` if no adverb of place is there."""
        after = index + 1
        if self.at(index) in _HEADINGS and self.closes_clause(after):
            return after
        leads = ("over", "in", "right", "up", "down", "out", "back", "on", "near", "straight")
        if self.at(index) in leads and self.at(after) in {"here", "there"}:
            return after + 1
        return after if self.at(index) in words.PLACE_ADVERBS else index

    # --- noun phrases ---------------------------------------------------

    def starts(self, index: int) -> bool:
        """Whether a noun phrase could begin at ``index``."""
        token = self.at(index)
        if token in words.PREDETERMINERS or token in words.DETERMINERS | words.POSSESSIVES:
            return self.adverb(index) == index
        if token in words.OBJECT_PRONOUNS or self.classes.is_number(token):
            return True
        behind = self.at(index - 1) in words.PREPOSITIONS or self.classes.is_verb(
            self.at(index - 1)
        )
        tin = token == "can" and behind and self.closes_clause(index + 1)
        return self._open(index) or self._is_rear(index) or tin

    def _open(self, index: int) -> bool:
        if not self.classes.is_open(self.at(index)) or self.is_compound(index):
            return False
        return self.adverb(index) == index

    def _is_rear(self, index: int) -> bool:
        """``the back burner``: "back" as an adjective."""
        following = self.at(index + 1)
        near = self.classes.is_noun(following) or self.classes.is_adjective(following)
        return self.at(index) == "back" and near and not self.classes.is_verb(following)

    def base_phrase(self, index: int, ends: Ends = NO_ENDS) -> tuple[NounPhrase, int] | None:
        """The noun phrase at ``index`` up to its head, and the index after it."""
        if not self.starts(index):
            return None
        determiner, after = self._determiner(index)
        pronoun = self._pronoun(index, determiner, after)
        if pronoun is not None:
            return pronoun
        inside, end = self._words(after, ends, bool(determiner))
        if not inside:
            return self._elliptic(index, determiner, after)
        return self._headed(index, end, determiner, inside), end

    def _determiner(self, index: int) -> tuple[str, int]:
        """Determiners, measures ("a couple of") and partitives ("one of the") together."""
        start = index
        for measure in words.MEASURES.get(self.at(index), ()):
            if self.matches(index, measure):
                index = max(index, start + len(measure))
        if self._is_partitive(index):
            index += 2
        while self._is_determiner(index):
            index += 1
        return " ".join(self.tokens[start:index]), index

    def _is_partitive(self, index: int) -> bool:
        after = self.at(index + 2)
        definite = after in {"the", *words.DEMONSTRATIVES, *words.POSSESSIVES, "them", "us", "you"}
        return self.at(index) in words.PARTITIVES and self.at(index + 1) == "of" and definite

    def _is_determiner(self, index: int) -> bool:
        token = self.at(index)
        if token in words.ARTICLES:
            return True
        following = index + 1
        if token in {"whichever", "whatever"}:
            return self._begins_nominal(following)
        if token in words.PREDETERMINERS:
            return token != "half" and self._begins_nominal(following)
        return token in words.DEMONSTRATIVES and self._begins_nominal(following)

    def _begins_nominal(self, index: int) -> bool:
        token = self.at(index)
        if token in words.DETERMINERS | words.POSSESSIVES or token in {"one", "ones", "them"}:
            return True
        if self.classes.is_number(token) or token in words.ORDINALS:
            return True
        return self._open(index) and not self.begins_command(index)

    def _pronoun(self, start: int, determiner: str, index: int) -> tuple[NounPhrase, int] | None:
        token = self.at(index)
        if token not in words.OBJECT_PRONOUNS or token in {"one", "ones"}:
            return None
        if (
            token in words.POSSESSIVES
            and self._open(index + 1)
            and not self.begins_command(index + 1)
        ):
            return None
        after = index + 1 + (self.at(index + 1) in {"both", "all", "else"})
        text = " ".join(self.tokens[start:after])
        many = token in {"them", "these", "those", "us", "themselves"}
        return NounPhrase(text, token, (), determiner, many), after

    def _words(self, index: int, ends: Ends, determined: bool) -> tuple[list[str], int]:
        """The modifiers and the head from ``index`` on, and the index after them."""
        inside: list[str] = []
        while index < len(self.tokens):
            step = self._step(index, inside, ends, determined)
            if step is None:
                break
            word, index = step
            if word:
                inside.append(word)
        return " ".join(inside).split(), index

    def _step(
        self, index: int, inside: list[str], ends: Ends, determined: bool
    ) -> tuple[str, int] | None:
        """The next word of a phrase ("" for one that is skipped) and the index after it."""
        token = self.at(index)
        if token in words.POSSESSIVES and not inside:
            return token, index + 1
        if self._is_passed_over(index, inside, determined):
            both = token == "," and self.at(index + 1) == "and"
            return "", index + 1 + both
        stops = self._stops(index, inside, ends)
        belongs = not stops and self._belongs(index, inside, determined)
        return (token, index + 1) if belongs else None

    def _is_passed_over(self, index: int, inside: list[str], determined: bool) -> bool:
        """Whether the token stands inside the phrase without being one of its words."""
        token = self.at(index)
        if inside and (token == "'" or (token == "'s" and self._open(index + 1))):
            return True
        if token in _INTENSIFIERS and self.classes.is_adjective(self.at(index + 1)):
            return True
        described = determined and not inside and self._describes(index)
        return described or self._joins_adjectives(index, inside)

    def _describes(self, index: int) -> bool:
        """``the already lit burner``: an adverb before what it describes."""
        described = self._open(index + 1) and self._open(index + 2)
        return self.adverb(index) == index + 1 and described

    def _belongs(self, index: int, inside: list[str], determined: bool) -> bool:
        token = self.at(index)
        if token in {"one", "ones"} or self.classes.is_number(token):
            return self.adverb(index) == index
        if token == "am" and inside and self.classes.is_number(inside[-1]):
            return True
        if self._is_rear(index) or (token == "can" and self._is_tin(index)):
            return True
        if token in {"right", "next", "last"} and self.classes.is_noun(self.at(index + 1)):
            return True
        if determined and not inside and token in _MODIFYING_ADVERBS | _NOUNS_AMONG_CLOSED:
            return True
        return self._open(index) or (token in words.ORDINALS and bool(determined))

    def _is_tin(self, index: int) -> bool:
        """``the coke can``: not the auxiliary."""
        ends = self.closes_clause(index + 1) or self.classes.is_noun(self.at(index + 1))
        return ends or self.begins_command(index + 1)

    def _joins_adjectives(self, index: int, inside: list[str]) -> bool:
        if self.at(index) not in {",", "and"} or not inside:
            return False
        following = index + 1 + (self.at(index) == "," and self.at(index + 1) == "and")
        both = self.classes.is_adjective(inside[-1]) and self.classes.is_adjective(
            self.at(following)
        )
        return (
            both
            and self._open(following + 1)
            and not self.classes.is_noun(inside[-1])
            and not self.begins_command(following)
        )

    def _stops(self, index: int, inside: list[str], ends: Ends) -> bool:
        if not inside:
            return False
        token = self.at(index)
        if self._begins_reduced_relative(index) or self.begins_command(index):
            return True
        if self.classes.is_number(token) and singular(self.at(index + 1)) in words.UNITS:
            return self.classes.is_noun(inside[-1])
        closes = self.closes_clause(index + 1)
        if ends.result and token in household.RESULTS and closes:
            return True
        return ends.verb and self.classes.is_verb(token) and closes

    def closes_clause(self, index: int) -> bool:
        """Whether the clause's bare words end at ``index``."""
        token = self.at(index)
        if token in {END, ","} or token in words.CONJUNCTIONS | words.SUBORDINATORS:
            return True
        return self.adverb(index) > index or self.preposition(index) is not None

    def begins_command(self, index: int) -> bool:
        """Whether a verb with its object begins here, without any conjunction before it."""
        token = self.at(index)
        if not self.classes.is_verb(token):
            return False
        if self.classes.is_noun(token) and not self._follows_noun(index):
            return False
        following = self.at(index + 1)
        if self.classes.takes_particle(token, following):
            following = self.at(index + 2)
        objects = words.DETERMINERS | words.POSSESSIVES | {"it", "them", "me", "us"}
        if following in objects:
            return True
        only_verb = not (self.classes.is_noun(token) or self.classes.is_adjective(token))
        return only_verb and self._follows_noun(index) and self._goes_on(index + 1)

    def _goes_on(self, index: int) -> bool:
        """``the cd | put in the xbox``, ``a spoon | add two cups``."""
        counted = self.classes.is_number(self.at(index))
        return counted or self.preposition(index) is not None

    def _follows_noun(self, index: int) -> bool:
        """``take the spoon | scoop the ice cream``."""
        before = self.at(index - 1)
        return self.classes.is_noun(before) and not self.classes.is_verb(before)

    def _begins_reduced_relative(self, index: int) -> bool:
        token, following = self.at(index), self.at(index + 1)
        if token in HOLDING:
            return self.starts(index + 1)
        if any(self.matches(index, phrase) for phrase in FULL):
            return True
        return token in PLACED and following in words.PREPOSITIONS | {"next", "close"}

    def _headed(self, start: int, end: int, determiner: str, inside: list[str]) -> NounPhrase:
        text = " ".join(self.tokens[start:end]).replace(" 's", "'s").replace(" '", "'")
        *before, last = self._with_numbers_in_front(inside)
        if determiner and self._lacks_noun(last):
            return NounPhrase(text, "one", (*before, last), determiner)
        many = is_plural(last) or determiner in {"these", "those"}
        head = "one" if last == "ones" else self.classes.head(last)
        return NounPhrase(text, head, tuple(before), determiner, many or last == "ones")

    def _with_numbers_in_front(self, inside: list[str]) -> list[str]:
        """``channel 5`` and ``channel number 5`` have the head "channel"."""
        end = len(inside)
        while end and self.classes.is_number(inside[end - 1]) and inside[end - 1] != "one":
            end -= 1
        if 1 < end < len(inside) and inside[end - 1] == "number":
            inside = [*inside[: end - 1], *inside[end:]]
            end -= 1
        if end in {0, len(inside)}:
            return inside
        return [*inside[: end - 1], *inside[end:], inside[end - 1]]

    def _lacks_noun(self, word: str) -> bool:
        if word in {"other", "same"} or word in words.ORDINALS:
            return True
        return self.classes.is_adjective(word) and not (
            self.classes.is_noun(word) or self.classes.is_verb(word)
        )

    def _elliptic(self, start: int, determiner: str, after: int) -> tuple[NounPhrase, int] | None:
        """A determiner alone: ``another``, ``both``; an article alone is no phrase."""
        token = self.tokens[after - 1] if after > start else END
        if token in {"another", "each", "some", "any", "neither", "either"}:
            return NounPhrase(determiner, "one", (), determiner), after
        if self.at(start) in {"all", "both", "half"} and after == start:
            head = "half" if self.at(start) == "half" else "them"
            return NounPhrase(self.at(start), head, (), "", head == "them"), start + 1
        return None
