"""Verbs at a place in a sentence: whether one stands there, its openers, its particles.

Answers questions about positions and keeps none of its own; what follows the
verb is read by ``clauses``.
"""

from __future__ import annotations

from verbteach.language import household, words
from verbteach.language.assembly import Clause
from verbteach.language.morphology import singular
from verbteach.language.openers import OPENERS, Mood
from verbteach.language.phrases import END
from verbteach.language.relatives import RelativePhrases

_OBJECT_STARTS = (
    words.DETERMINERS | words.POSSESSIVES | words.OBJECT_PRONOUNS | words.PREDETERMINERS
) - {"one", "ones"}
_EASY_PARTICLES = frozenset({"up", "off", "out", "away", "back", "down", "apart"})
_EXTENDED = {
    "ask": (("for",),),
    "attend": (("to",),),
    "care": (("for",),),
    "dispose": (("of",),),
    "get": (("rid", "of"), ("hold", "of")),
    "knock": (("on",),),
    "let": (("go", "of"),),
    "listen": (("to",),),
    "look": (("for",), ("at",), ("after",)),
    "make": (("sure",),),
    "point": (("at",),),
    "search": (("for",),),
    "take": (("care", "of"), ("hold", "of")),
    "wait": (("for",),),
    "watch": (("out", "for"),),
}
"""Verbs with words that are part of them before the object."""


class Verbs:
    """Where verbs stand in one sentence."""

    def __init__(self, phrases: RelativePhrases) -> None:
        self._phrases = phrases
        self._classes = phrases.classes
        self._at = phrases.at

    # --- openers ----------------------------------------------------------

    def opening(self, index: int) -> tuple[int, Mood]:
        """The index of the verb behind the openers at ``index``, and the mood they set."""
        mood = Mood.PLAIN
        while True:
            index = self._past_adverbs(index)
            found = self._opener(index)
            if found is None:
                return index, mood
            index, opened = found
            mood = opened if mood is Mood.PLAIN else mood

    def _opener(self, index: int) -> tuple[int, Mood] | None:
        for phrase, mood in OPENERS.get(self._at(index), ()):
            after = index + len(phrase)
            if self._phrases.matches(index, phrase) and self._continues(after, mood):
                return after, mood
        return None

    def _continues(self, index: int, mood: Mood) -> bool:
        index = self._past_adverbs(index)
        if mood is Mood.GERUND:
            return self.gerund(index) is not None
        if self._at(index - 1) in {"you", "we"} and not self._classes.is_verb(self._at(index)):
            return False
        opened = any(self._phrases.matches(index, p) for p, _ in OPENERS.get(self._at(index), ()))
        return opened or self.stands(index, loose=True)

    def _past_adverbs(self, index: int) -> int:
        while (after := self._phrases.adverb(index)) > index:
            index = after
        return index

    def gerund(self, index: int) -> str | None:
        """The verb whose -ing form stands at ``index``, or None."""
        following = (self._at(index), self._at(index + 1))
        if following in household.COMPOUNDS:
            return None
        return self._classes.gerund_base(following[0])

    # --- the verb -----------------------------------------------------------

    def verb(self, index: int, mood: Mood, *, loose: bool, gerunds: bool) -> tuple[str, int] | None:
        """The verb at ``index`` with the words that are part of it, and the index after it."""
        token = self._at(index)
        base = self.gerund(index) if token not in self._classes.verbs else None
        if base is not None and gerunds and loose:
            return self._extended(base, index + 1)
        if mood is Mood.GERUND or not self.stands(index, loose=loose):
            return None
        return self._extended(token, index + 1)

    def _extended(self, verb: str, index: int) -> tuple[str, int]:
        if verb == "stop" and self.gerund(index):
            return f"{verb} {self._at(index)}", index + 1
        for phrase in _EXTENDED.get(verb, ()):
            if self._phrases.matches(index, phrase) and not self._lasts(verb, index + 1):
                return " ".join((verb, *phrase)), index + len(phrase)
        return verb, index

    def _lasts(self, verb: str, index: int) -> bool:
        """``wait for two minutes`` is no waiting for minutes."""
        near = {singular(self._at(index + k)) for k in range(3)}
        return verb == "wait" and bool(near & words.TIME_NOUNS)

    def stands(self, index: int, *, loose: bool) -> bool:
        """Whether a verb stands at ``index``; ``loose`` where one is expected there."""
        token, following = self._at(index), self._at(index + 1)
        if not self._classes.may_be_verb(token) or following in _FINITE:
            return False
        governs = self._governs(index)
        if not self._classes.is_open(token):
            return governs
        if not self._classes.is_verb(token):
            return self._new_verb(index, governs, loose)
        noun = self._classes.is_noun(token)
        if governs or not (noun or self._classes.is_adjective(token)):
            return True
        return self._noun_as_verb(index, loose) if noun else self._adjective_as_verb(index, loose)

    def _adjective_as_verb(self, index: int, loose: bool) -> bool:
        """``empty``, ``clean``: a verb behind a comma or before nothing it could describe."""
        described = not self._phrases.closes_clause(index + 1)
        listed = self._at(index - 1) == "," and index - 1 == self._phrases.last_comma
        return (
            loose
            or not described
            or listed
            or self._at(index) in {"empty", "open", "clear", "shut"}
        )

    def _governs(self, index: int) -> bool:
        """Whether what follows ``index`` looks like an object, perhaps behind a particle."""
        token, following = self._at(index), self._at(index + 1)
        if self._classes.takes_particle(token, following):
            after = self._at(index + 2)
            ends = after in {END, ",", "and", "then"}
            return following in _EASY_PARTICLES or after in _OBJECT_STARTS or ends
        if following in _EASY_PARTICLES and not self._classes.is_known(token):
            return True
        counted = self._classes.is_noun(self._at(index + 2)) or not self._classes.is_noun(token)
        return following in _OBJECT_STARTS or (self._classes.is_number(following) and counted)

    def _new_verb(self, index: int, governs: bool, loose: bool) -> bool:
        """A word no list has as a verb: a verb only where it must be one."""
        if self.gerund(index) is not None:
            return False
        if self._classes.is_noun(self._at(index)) or self._classes.is_adjective(self._at(index)):
            return governs and loose
        return governs or loose

    def _noun_as_verb(self, index: int, loose: bool) -> bool:
        token, following = self._at(index), self._at(index + 1)
        place = self._phrases.preposition(index + 1) is not None
        if token in household.MOSTLY_VERBS and (place or loose):
            return True
        if token in {"place", "set", "drop", "scoop"} and self._phrases.starts(index + 1):
            return True
        if not loose:
            return False
        return not place or following in {"for", "with", "until"}

    # --- where clauses begin and end ------------------------------------------

    def begins_clause(self, index: int, *, linked: bool = False) -> bool:
        """Whether a new command begins at ``index``, after a conjunction."""
        opener = self._opener(self._past_adverbs(index))
        return opener is not None or self.stands(self._past_adverbs(index), loose=linked)

    def begins_command(self, index: int) -> bool:
        """Whether a new command begins at ``index`` without any conjunction."""
        if self._opener(index) is not None and self._at(index) not in {"go", "come", "help"}:
            return True
        return self._phrases.begins_command(index)

    def infinitive(self, index: int, *, gerund: bool) -> tuple[str, int] | None:
        """The verb behind ``to`` or ``for``, if a purpose begins there."""
        index = self._past_adverbs(index)
        if gerund:
            base = self.gerund(index)
            return None if base is None else self._extended(base, index + 1)
        token = self._at(index)
        if not self._classes.is_verb(token) or not self.stands(index, loose=False):
            return None
        return self._extended(token, index + 1)

    def after_subordinate(self, index: int) -> int:
        """The index behind a subordinate clause ("when you are done")."""
        index += 1
        start = index
        while self._at(index) not in {END, ",", "then"}:
            if index > start + 1 and self._leaves_subordinate(index):
                return index
            index += 1
        return index

    def _leaves_subordinate(self, index: int) -> bool:
        """Whether a command begins here; behind "and" only where no comma will say so."""
        if not (self.stands(index, loose=False) and self._governs(index)):
            return False
        if self._at(index - 1) == "and":
            return index > self._phrases.last_comma
        return self._at(index - 1) not in _UNFINISHED

    def is_vocative(self, index: int) -> bool:
        """Whether the word at ``index`` calls the robot ("hey robot,")."""
        token, following = self._at(index), self._at(index + 1)
        if token in words.VOCATIVES and token != "robot":
            return True
        if token == "robot":
            return following in {END, ","} or self.begins_clause(index + 1, linked=True)
        first = self._at(index - 1) in {END, ","} and following == ","
        named = first and self._classes.is_open(token) and not self._classes.is_known(token)
        return named and self.begins_clause(index + 2, linked=True)

    # --- particles ------------------------------------------------------------

    def is_particle(self, clause: Clause, index: int) -> bool:
        """Whether the word at ``index`` belongs to the clause's verb ("turn the tv on")."""
        token = self._at(index)
        if clause.particle or not self._is_particle_word(clause.verb, token):
            return False
        moves = clause.verb in household.INTRANSITIVE
        if clause.objects and token in {"down", "up"} and self._at(index + 1) == "from":
            return self._classes.takes_particle(clause.verb, token)
        if self._at(index + 1) == "of" or self._phrases.is_compound(index):
            return token != "out" and self._compound_is_particle(clause, token, moves)
        object_follows = self._phrases.starts(index + 1) and not self.is_vocative(index + 1)
        if not object_follows:
            return True
        if clause.objects or moves:
            handed = [o.head for o in clause.objects] in _ONE_PERSON
            taken = handed and self._classes.takes_particle(clause.verb, token)
            return taken or token in words.BARE_PARTICLES or self._fills_up(clause, index)
        return token in _EASY_PARTICLES or self._classes.takes_particle(clause.verb, token)

    def _fills_up(self, clause: Clause, index: int) -> bool:
        """``fill it up three quarters``: no path that one could go up or down."""
        token = self._at(index)
        near = {singular(self._at(index + k)) for k in range(1, 4)}
        path = near & {"stair", "stairs", "step", "ladder", "hall", "drain", "sink", "toilet"}
        taken = self._classes.takes_particle(clause.verb, token)
        return token in {"up", "down"} and taken and bool(clause.objects) and not path

    def _is_particle_word(self, verb: str, token: str) -> bool:
        opens = token in {"open", "shut"} and verb in household.RESULTATIVES
        return token in words.PARTICLES or opens

    def _compound_is_particle(self, clause: Clause, token: str, moves: bool) -> bool:
        if moves:
            return token == "back"
        return not clause.objects and self._classes.takes_particle(clause.verb, token)


_ONE_PERSON = [[person] for person in sorted(words.PERSONS)]
_FINITE = words.AUXILIARIES - {"have", "do", "has", "'s", "can"}
_UNFINISHED = (
    words.AUXILIARIES | words.SUBJECT_PRONOUNS | frozenset({"to", "not", "and", "or", "the"})
)
