"""What words say of a thing, as the scene's fluents: "the tap is off", "it is in the sink".

Answers questions with it, and reads goals: the words for a thing, those for
what is said of it, and the fluents that this may mean. Nothing is guessed:
what fits several things stays several.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from verbteach.dialogue.draft import Draft
from verbteach.dialogue.referring import read_noun_phrase
from verbteach.language.frames import PRONOUNS
from verbteach.language.looks import Looks
from verbteach.language.refer import refer
from verbteach.language.wordlist import pairs, word_set
from verbteach.world.fluents import Fluent, Literal

Words = tuple[str, ...]

_SELF = frozenset({("you",), ("robot",), ("the", "robot"), ("your", "hand"), ("your", "hands")})
_TEACHER = frozenset({("i",), ("me",)})
_PASSING = word_set(
    "all still now also fully completely back turned switched put placed left set kept made lying "
    "standing sitting moved brought got being down up already again again too there"
)
"""Words before what is said that say no more: "put in the sink", "turned off"."""
_AFTERWARDS = word_set("again now too also please then instead afterwards already")
_SAME_STATE: Mapping[str, str] = pairs(
    "shut:closed close:closed opened:open wash:clean washed:clean cleaned:clean unwashed:dirty "
    "warm:hot warmed:hot heat:hot heated:hot boil:hot boiling:hot boiled:hot cook:hot cooked:hot "
    "cool:cold cooled:cold chill:cold chilled:cold lit:burning running:on working:on active:on "
    "activated:on started:on stopped:off inactive:off"
)
_SWITCHED = pairs("open:on closed:off opened:on shut:off")
"""A tap is open where a fridge is; what cannot be open may be on."""
_FULL = frozenset({("full", "of"), ("filled", "with"), ("containing",), ("contain",), ("with",)})
_HOLD = word_set("hold holding have grasp grasping carry carrying take")
_AWAY = frozenset({"out of", "off", "from", "outside"})
"""What is out of the fridge is not in it."""
_SEVERAL = frozenset({"all", "both", "every", "each"})
_HANDS = frozenset({"hand", "hands"})


@dataclass(frozen=True)
class Facts:
    """Reads what is said of things in one state; ``spoken`` is what a pronoun may mean, in order.

    ``looks`` is the state that the words describe things in.
    """

    draft: Draft
    looks: Looks
    spoken: tuple[str, ...] = ()

    def about(self, subject: Words, said: Words, *, positive: bool = True) -> tuple[Literal, ...]:
        """Every literal that ``said`` of ``subject`` may mean, of each thing that the words fit.

        A pronoun means the first of what was spoken of that it can be said of.
        """
        things = self.things(subject)
        if " ".join(subject) in PRONOUNS:
            each = (self._said_of_all([thing], said, positive=positive) for thing in things)
            return next(filter(None, each), ())
        found = self._said_of_all(things, said, positive=positive)
        return found or self._said_of_all(self._vessels(things), said, positive=positive)

    def _said_of_all(
        self, things: Iterable[str], said: Words, *, positive: bool
    ) -> tuple[Literal, ...]:
        found = (one for thing in things for one in self.said_of(thing, said, positive=positive))
        return tuple(dict.fromkeys(found))

    def _vessels(self, things: Sequence[str]) -> tuple[str, ...]:
        """What the substances are in: "the milk should be on the table"."""
        substances = {thing for thing in things if not self.looks.is_thing(thing)}
        holders = self.looks.objects if substances else ()
        return tuple(one for one in holders if not substances.isdisjoint(self.looks.holds(one)))

    def parted(self, words: Words, *, positive: bool = True) -> tuple[Words, tuple[Literal, ...]]:
        """As ``about``, where no verb says which words are the subject: "the tap closed"."""
        for at in range(len(words) - 1, 0, -1):
            if found := self.about(words[:at], words[at:], positive=positive):
                return words[:at], found
        return (), ()

    def things(self, words: Words) -> tuple[str, ...]:
        """What the words fit best; substances are things here."""
        if words in _SELF:
            return self._of_type("robot")
        if words in _TEACHER:
            return self._of_type("person")
        if " ".join(words) in PRONOUNS:
            return self.spoken
        told = read_noun_phrase(self.draft, " ".join(words)) if words else None
        found = refer(told, self.looks, self.spoken[:1]) if told is not None else ()
        return tuple(thing for thing, fit in found if fit == found[0][1])

    def several(self, words: Words) -> bool:
        """Whether the words speak of more than one thing: "the plates", "both mugs", "them"."""
        told = read_noun_phrase(self.draft, " ".join(words)) if words else None
        if told is None:
            return False
        return told.plural or words[0] in _SEVERAL or told.head in {"them", "these", "those"}

    def _of_type(self, kind: str) -> tuple[str, ...]:
        is_a, objects = self.looks.scene.domain.is_a, self.looks.objects
        return tuple(one for one in sorted(objects) if is_a(objects[one].type, kind))

    def said_of(self, thing: str, said: Words, *, positive: bool = True) -> Iterator[Literal]:
        """The literals of the task that the words say of one thing."""
        for fluent, holds in self._fluents(thing, _stripped(said)):
            if self._can_be(fluent):
                yield Literal(fluent, holds == positive)

    def _fluents(self, thing: str, said: Words) -> Iterator[tuple[Fluent, bool]]:
        if not said:
            return
        yield from self._state(thing, " ".join(said))
        length, preposition = self._preposition(said)
        if length and (rest := said[length:]):
            if preposition == "in" and not _HANDS.isdisjoint(rest):
                yield from self._held(thing)
            away = preposition in _AWAY
            others = self.things(rest)
            for other in (*others, *self._vessels(others)):
                for fluent, holds in self._related(thing, preposition, other):
                    yield fluent, holds != away

    def _state(self, thing: str, word: str) -> Iterator[tuple[Fluent, bool]]:
        """A state in a word or two: the first of its senses that the thing can be in."""
        for sense in (word, _SAME_STATE.get(word, word), _SWITCHED.get(word, word)):
            meant = {sense} | self.looks.names.meant_by(sense)
            found = [
                (Fluent(predicate, (thing,)), is_true in meant)
                for predicate, is_true, is_false in self.looks.names.adjectives
                if not meant.isdisjoint({is_true, is_false} - {""})
                and self._can_be(Fluent(predicate, (thing,)))
            ]
            if found:
                yield from found
                return

    def _can_be(self, fluent: Fluent) -> bool:
        """Whether anything that is done here depends on it or changes it, or it just is so."""
        task = self.draft.mind.setting.task
        return fluent in task.bit or fluent in task.static

    def _preposition(self, said: Words) -> tuple[int, str]:
        """How many of the first words name a relation, and by which word it goes."""
        for words in _FULL:
            if said[: len(words)] == words:
                return len(words), "with"
        if said[0] in _HOLD:
            return 1, "holding"
        for length in (3, 2, 1):
            named = " ".join(said[:length])
            if named in self.looks.prepositions and named != "of":
                return length, named
        return 0, ""

    def _related(self, thing: str, preposition: str, other: str) -> Iterator[tuple[Fluent, bool]]:
        if preposition in {"in", "inside"} and not self.looks.is_thing(thing):
            thing, preposition, other = other, "with", thing  # the water in the kettle
        for fluent in self.looks.relating(thing, preposition, other):
            yield fluent, True

    def _held(self, thing: str) -> Iterator[tuple[Fluent, bool]]:
        for robot in self._of_type("robot"):
            for fluent in self.looks.relating(robot, "holding", thing):
                yield fluent, True


def _stripped(said: Words) -> Words:
    if said[:1] in (("have",), ("contain",)) and said[-2:] == ("in", "it"):
        return ("with", *said[1:-2])
    while len(said) > 1 and said[0] in _PASSING:
        said = said[1:]
    while len(said) > 1 and said[-1] in _AFTERWARDS:
        said = said[:-1]
    return said


def said_of_any(literals: Iterable[Literal], things: Iterable[str]) -> tuple[Literal, ...]:
    """The literals that say something of one of the things, sorted."""
    among = {*things}
    return tuple(one for one in sorted(literals) if not among.isdisjoint(one.fluent.args[:1]))


def mentioning(literals: Iterable[Literal], things: Iterable[str]) -> tuple[Literal, ...]:
    """The literals in which one of the things comes up, sorted."""
    among = {*things}
    return tuple(one for one in sorted(literals) if not among.isdisjoint(one.fluent.args))
