"""Clauses of one sentence: what follows each verb, and what conjunctions join.

The upper half of the grammar. It walks the sentence once from left to right;
every look ahead is bounded, so reading takes time in proportion to length.
"""

from __future__ import annotations

from collections.abc import Sequence

from verbteach.language import household, words
from verbteach.language.assembly import OBJECT, PLACE, Clause, Piece
from verbteach.language.coordination import (
    has_recipient,
    joined_role,
    same_kind,
    verb_level_role,
)
from verbteach.language.frames import NounPhrase
from verbteach.language.openers import Mood
from verbteach.language.phrases import END, Ends
from verbteach.language.relatives import RelativePhrases
from verbteach.language.verbal import Verbs
from verbteach.language.wordclass import WordClasses

_FAR = 4
"""How many coordinated phrases a look ahead passes before it gives up."""
_SEQUENCE = frozenset({"then", "please", "now", "first", "finally", "next", "afterwards"})


class SentenceReader:
    """Reads one sentence into clauses; use once."""

    def __init__(self, tokens: Sequence[str], classes: WordClasses) -> None:
        self._phrases = RelativePhrases(tokens, classes)
        self._verbs = Verbs(self._phrases)
        self._classes = classes
        self._at = self._phrases.at
        self._size = len(tokens)
        self._i = 0
        self._fronted: list[Piece] = []
        self._clauses: list[Clause] = []

    def read(self) -> list[Clause]:
        """The sentence's clauses in the order said; a fragment without a verb gives none."""
        expected = True
        while self._i < self._size:
            before = self._i
            expected = self._part(expected)
            self._i = max(self._i, before + 1)
        return [c for c in self._clauses if c.pieces or not c.purpose]

    # --- between clauses --------------------------------------------------

    def _part(self, expected: bool) -> bool:
        """Read one clause or pass over one fragment; whether a verb is expected next."""
        linked = self._skip_links()
        if self._i >= self._size or self._skip_subordinate() or self._front(expected):
            return True
        start, mood = self._verbs.opening(self._i)
        loose = expected or linked or start > self._i
        gerunds = mood is not Mood.PLAIN or not self._clauses
        found = self._verbs.verb(start, mood, loose=loose, gerunds=gerunds)
        if found is None:
            self._skip_fragment()
            return False
        verb, self._i = found
        clause = Clause(verb, negative=mood is Mood.NEGATIVE, trailing=self._fronted)
        self._fronted = []
        self._read_clause(clause)
        return True

    def _skip_links(self) -> bool:
        """Pass over conjunctions, commas, adverbs and calls; whether they announce a clause."""
        linked = False
        while self._i < self._size:
            token = self._at(self._i)
            after = self._phrases.adverb(self._i)
            if after > self._i:
                linked = linked or token in _SEQUENCE
                self._i = after
            elif token in words.CONJUNCTIONS:
                linked = True
                self._i += 1
            elif token in {",", "'s", "'"} or self._verbs.is_vocative(self._i):
                self._i += 1
            else:
                break
        return linked

    def _skip_subordinate(self) -> bool:
        late = self._at(self._i) in words.RELATIVES and self._at(self._i + 1) in words.AUXILIARIES
        if self._at(self._i) not in words.SUBORDINATORS and not late:
            return False
        if self._verbs.begins_clause(self._i):
            return False
        self._i = self._verbs.after_subordinate(self._i)
        return True

    def _front(self, expected: bool) -> bool:
        """Keep a phrase said before its verb: ``with the sponge, wipe the table``."""
        if self._at(self._i) == "to" and self._verbs.infinitive(self._i + 1, gerund=False):
            self._i += 1
            return True
        found = self._phrases.preposition(self._i) if expected else None
        if found is None or self._at(self._i) in {"like", "off", "out", "up", "down"}:
            return False
        phrase = self._phrases.noun_phrase(found[1])
        if phrase is None:
            return False
        self._fronted.append(Piece(found[0], phrase[0], joined=True))
        self._i = phrase[1]
        return True

    def _skip_fragment(self) -> None:
        self._fronted = []
        self._i += 1
        while self._i < self._size and self._at(self._i) != ",":
            linked = self._at(self._i - 1) in words.CONJUNCTIONS | {"then", "please"}
            if linked and self._verbs.begins_clause(self._i):
                return
            self._i += 1

    # --- one clause -------------------------------------------------------

    def _read_clause(self, clause: Clause) -> None:
        self._clauses.append(clause)
        following: Clause | None = clause
        while following is not None and self._i < self._size:
            before = self._i
            following = self._step(following)
            if following is not None:
                self._i = max(self._i, before + 1)

    def _step(self, clause: Clause) -> Clause | None:
        """Read the next piece into ``clause``; the clause open afterwards, None at its end."""
        if self._at(self._i) in words.CONJUNCTIONS | {","}:
            return self._conjunction(clause)
        if self._at(self._i) in words.SUBORDINATORS or self._trails(clause):
            return None
        for read in (
            self._subject,
            self._purpose,
            self._place_adverb,
            self._particle,
            self._outcome,
            self._prepositional,
        ):
            following = read(clause)
            if following is not None:
                return following
        if (after := self._phrases.adverb(self._i)) > self._i:
            return self._adverb(clause, after)
        complete = bool(clause.pieces or clause.particle)
        ends = complete and self._verbs.begins_command(self._i)
        return None if ends else self._piece(clause, OBJECT)

    def _subject(self, clause: Clause) -> Clause | None:
        """``make sure | the tv is off``: the last object turns out to be a subject."""
        finite = self._at(self._i) in words.COPULAS - {"'s", "be", "being"}
        if not finite or not clause.pieces or clause.pieces[-1].role != OBJECT:
            return None
        clause.pieces.pop()
        self._i = self._verbs.after_subordinate(self._i)
        return clause

    def _trails(self, clause: Clause) -> bool:
        """``remove anything from the table that holds no food``: a relative clause too late."""
        finite = self._at(self._i + 1) in words.AUXILIARIES
        return self._at(self._i) in words.RELATIVES and finite and bool(clause.pieces)

    def _adverb(self, clause: Clause, after: int) -> Clause | None:
        sequence = self._at(self._i) in _SEQUENCE
        self._i = after
        ends = sequence and self._verbs.begins_clause(after, linked=bool(clause.pieces))
        return None if ends else clause

    def _purpose(self, clause: Clause) -> Clause | None:
        """``use the sponge to wipe the table``; another purpose is a clause of its own."""
        token = self._at(self._i)
        if token != "to" and not (token == "for" and clause.verb == "use"):
            return None
        found = self._verbs.infinitive(self._i + 1, gerund=token == "for")
        if found is None:
            return None
        verb, self._i = found
        if clause.verb == "use" and not clause.particle:
            tools = [Piece("with", phrase, joined=True) for phrase in clause.objects]
            self._clauses.pop()
            following = Clause(verb, clause.negative, trailing=tools)
        else:
            following = Clause(verb, clause.negative, purpose=True)
        self._clauses.append(following)
        return following

    def _place_adverb(self, clause: Clause) -> Clause | None:
        after = self._phrases.place_adverb(self._i)
        word = self._at(after - 1)
        inside = word in {"inside", "outside"} and self._phrases.starts(after)
        if after == self._i or inside:
            return None
        clause.pieces.append(Piece(PLACE, NounPhrase(word, word)))
        self._i = after
        return clause

    def _particle(self, clause: Clause) -> Clause | None:
        token = self._at(self._i)
        if not self._verbs.is_particle(clause, self._i):
            return None
        self._i += 1
        returns = token == "back" and clause.objects and self._phrases.preposition(self._i)
        if not returns:
            clause.particle = token
        return clause

    def _outcome(self, clause: Clause) -> Clause | None:
        """``leave the door open``, ``let the water boil``."""
        token = self._at(self._i)
        if not clause.objects or clause.particle or not self._phrases.closes_clause(self._i + 1):
            return None
        if clause.verb in household.RESULTATIVES and token in household.RESULTS:
            clause.particle = token
        elif clause.verb in household.CAUSATIVES and self._classes.is_verb(token):
            clause.verb = token
        else:
            return None
        self._i += 1
        return clause

    def _prepositional(self, clause: Clause) -> Clause | None:
        found = self._phrases.preposition(self._i)
        if found is None:
            return None
        role, self._i = found
        if role in {"by", "without"} and self._verbs.gerund(self._i):
            self._i = self._verbs.after_subordinate(self._i)
            return clause
        if (after := self._phrases.place_adverb(self._i)) > self._i:
            word = self._at(after - 1)
            clause.pieces.append(Piece(role, NounPhrase(word, word)))
            self._i = after
            return clause
        return self._piece(clause, role)

    def _piece(self, clause: Clause, role: str, *, joined: bool = False) -> Clause:
        caused = clause.verb in household.CAUSATIVES
        ends = Ends(verb=caused, result=clause.verb in household.RESULTATIVES)
        found = self._phrases.noun_phrase(self._i, ends)
        if found is not None:
            phrase, self._i = found
            clause.pieces.append(Piece(role, phrase, joined))
        return clause

    # --- coordination -----------------------------------------------------

    def _conjunction(self, clause: Clause) -> Clause | None:
        """Decide what a comma or conjunction joins: phrases, gapped clauses or clauses."""
        index, announced = self._behind_links()
        if index >= self._size or self._at(index) in words.SUBORDINATORS:
            return None
        if has_recipient(clause) and not self._classes.is_verb(self._at(index)):
            return self._joined(clause, index) if self._phrases.starts(index) else None
        if self._verbs.begins_clause(index, linked=announced) or self._calls(index):
            clause.bare = not clause.pieces
            return None
        if self._closes_with_particle(index):
            return self._second_particle(clause, index)
        return self._conjoined(clause, index)

    def _conjoined(self, clause: Clause, index: int) -> Clause | None:
        """Read on behind a conjunction that joins less than a whole clause."""
        if self._verbs.gerund(index) and self._at(index + 1) in words.OBJECT_PRONOUNS:
            index = self._verbs.after_subordinate(index)
        elif self._phrases.preposition(index) is None:
            return self._joined(clause, index) if self._phrases.starts(index) else None
        self._i = index
        return clause

    def _joined(self, clause: Clause, index: int) -> Clause:
        """One more phrase, or a clause whose verb is left out."""
        gapped = self._gapped(clause, index)
        self._i = index
        if gapped is not None:
            self._clauses.append(gapped)
            return gapped
        before = len(clause.pieces)
        self._piece(clause, OBJECT, joined=True)
        if len(clause.pieces) > before:
            added = clause.pieces.pop()
            nested = self._at(self._i) == "of" or added.phrase.head in household.CONTAINERS
            role = joined_role(clause, added.phrase, nested=nested)
            clause.pieces.append(added._replace(role=role))
        return clause

    def _behind_links(self) -> tuple[int, bool]:
        """The index behind conjunctions and adverbs, and whether they announce a clause."""
        index, announced = self._i, False
        while index < self._size:
            token = self._at(index)
            after = self._phrases.adverb(index)
            if after > index:
                announced = announced or token in _SEQUENCE
                index = after
            elif token in words.CONJUNCTIONS or token == ",":
                index += 1
            else:
                break
        return index, announced

    def _calls(self, index: int) -> bool:
        """``open the fridge, jarvis``: a bare unknown word at the end, behind a comma."""
        if self._verbs.is_vocative(index):
            return True
        alone = self._at(index - 1) == "," and self._at(index + 1) == END
        return alone and not self._classes.is_known(self._at(index))

    def _closes_with_particle(self, index: int) -> bool:
        closing = self._at(index) in words.PARTICLES and self._phrases.closes_clause(index + 1)
        return closing and self._phrases.place_adverb(index) == index

    def _second_particle(self, clause: Clause, index: int) -> Clause:
        """``turn the tv on and off``."""
        self._i = index + 1
        pieces = [Piece(OBJECT, phrase, joined=True) for phrase in clause.objects]
        following = Clause(clause.verb, clause.negative, self._at(index), pieces)
        self._clauses.append(following)
        return following

    def _gapped(self, clause: Clause, index: int) -> Clause | None:
        """A clause whose verb is left out: ``put the fork in the sink and the knife on it``."""
        after = self._behind_phrases(index)
        if after is None or not clause.objects:
            return None
        following = Clause(clause.verb, clause.negative)
        if clause.particle and self._closes_with_particle(after):
            return following
        following.particle = clause.particle
        found = self._phrases.preposition(after)
        settled = verb_level_role(clause) or clause.pieces[-1].role == PLACE
        if settled and self._phrases.place_adverb(after) > after:
            return following
        placed = found is not None and same_kind(found[0], verb_level_role(clause))
        between = clause.pieces[-1].role == "between" and not clause.pieces[-1].joined
        given = has_recipient(clause) and self._phrases.starts(after)
        return following if (placed and not between) or given else None

    def _behind_phrases(self, index: int) -> int | None:
        """The index behind a short list of noun phrases at ``index``."""
        for _ in range(_FAR):
            found = self._phrases.noun_phrase(index)
            if found is None:
                return None
            index = found[1]
            if self._at(index) == "of":
                index += 1
            elif self._at(index) in {"and", ","} and not self._verbs.begins_clause(index + 1):
                index += 1 + (self._at(index + 1) == "and")
            else:
                return index
        return None
