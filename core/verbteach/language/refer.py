"""Referring expressions: which objects a noun phrase means.

Words are matched against ids, names, attributes, states, contents and
relations. Nothing is guessed: a phrase may fit no object or several, and then
the robot asks. The way back, from an object to words, is in ``distinguish``.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from typing import TypeAlias

from verbteach.language.frames import NounPhrase
from verbteach.language.looks import Looks
from verbteach.language.morphology import plural
from verbteach.language.names import FIRST_NAME
from verbteach.language.words import NUMBERS, ORDINALS, POSSESSIVES

Candidates: TypeAlias = tuple[tuple[str, float], ...]
"""Object ids with how well the phrase fits them, the best first, then by id."""


class Verdict(Enum):
    """What a phrase's candidates amount to."""

    NONE = "none"
    ONE = "one"
    SEVERAL = "several"
    UNCLEAR = "unclear"


POSITIONS = frozenset({"left", "right", "top", "bottom", "front", "back", "middle"})
_POINTERS = frozenset({"it", "this", "that"})
_PLURAL_POINTERS = frozenset({"them", "these", "those"})
_OTHER = frozenset({"other", "another"})
_ALL = frozenset({"all", "both", "every", "each"})
_NEAR_BEST = 0.3
_SECOND_SENSE = 0.25
_MASS_SENSE = 0.5
_MASS = frozenset({"some", "more", "any", "bit"})
_ABOUT_CONTENTS = frozenset({"with", "of"})
_SIZES = {"tiny": 0, "small": 1, "medium": 2, "large": 3, "big": 3, "huge": 4}
_SUPERLATIVES = {
    "biggest": 1, "largest": 1, "tallest": 1, "smallest": -1, "littlest": -1, "shortest": -1,
    "bigger": 1, "larger": 1, "smaller": -1,
}  # fmt: skip
_SPEAKERS = {"you": "robot", "i": "person"}
_DIGITS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
_HOLDING = frozenset({"hold", "carry", "grasp", "have"})


@dataclass(frozen=True)
class _Said:
    """A noun phrase sorted into what each of its words is good for."""

    heads: tuple[str, ...]
    marks: tuple[str, ...]
    number: str = ""
    other: bool = False
    ordinal: int | None = None
    size: int = 0
    holder: str = ""
    relations: tuple[tuple[str, NounPhrase], ...] = ()

    @classmethod
    def of(cls, phrase: NounPhrase) -> _Said:
        words = phrase.modifiers
        placed = [inner.head for _, inner in phrase.relations if inner.head in POSITIONS]
        digits = [*(w for w in words if w.isdecimal()), *_counted(phrase)]
        return cls(
            heads=_heads(phrase),
            marks=(*(w for w in words if _is_mark(w)), *placed),
            number=digits[-1] if digits else "",
            other=not _OTHER.isdisjoint({*words, *phrase.determiner.split()}),
            ordinal=next((ORDINALS[w] for w in words if w in ORDINALS), None),
            size=next((_SUPERLATIVES[w] for w in words if w in _SUPERLATIVES), 0),
            holder=next(filter(None, map(_holder, words)), ""),
            relations=tuple(r for r in phrase.relations if r[1].head not in POSITIONS),
        )

    @property
    def points_back(self) -> bool:
        """Whether it says nothing but that something was spoken of: "the other one"."""
        described = self.marks or self.relations or self.number or self.size or self.holder
        return self.heads[0] == "one" and not described and self.ordinal is None


def _counted(phrase: NounPhrase) -> list[str]:
    """The number of "mug two", in digits; "two mugs" has none, and "one" is no number here."""
    last = phrase.text.split(" ")[-1].lower()
    return [str(_DIGITS.index(last))] if last in _DIGITS[2:] and not phrase.plural else []


def _heads(phrase: NounPhrase) -> tuple[str, ...]:
    """The noun as names may have it: some name one thing in the plural, as "the keys" do."""
    return (phrase.head, plural(phrase.head)) if phrase.plural else (phrase.head,)


def _is_mark(word: str) -> bool:
    skipped = _OTHER | NUMBERS | POSSESSIVES | {*ORDINALS, *_SUPERLATIVES}
    return word not in skipped and not word.isdecimal() and not _holder(word)


def _holder(modifier: str) -> str:
    """Who holds the thing, in "the thing you are holding"."""
    subject, _, verb = modifier.partition(" ")
    return _SPEAKERS.get(subject, "") if verb in _HOLDING else ""


def refer(
    phrase: NounPhrase,
    looks: Looks,
    spoken: Sequence[str] = (),
    role: str = "",
    listed: Sequence[str] = (),
) -> Candidates:
    """The objects that ``phrase`` may mean; empty where none fits.

    ``spoken`` are the objects spoken of before, the latest last, for "it" and
    "the other one"; ``listed`` those offered in order, for "the second one".
    ``role`` tells "throw the beer" from "fill it with beer": one word for a
    thing and for what is in it means the thing unless the role asks for contents;
    with "some" before it the other sense stays in play.
    """
    return _referred(phrase, looks, tuple(spoken), role, tuple(listed))


@lru_cache(maxsize=128)
def _referred(
    phrase: NounPhrase, looks: Looks, spoken: tuple[str, ...], role: str, listed: tuple[str, ...]
) -> Candidates:
    """See ``refer``: in one turn the same phrase is looked up several times."""
    if phrase.head in _POINTERS | _PLURAL_POINTERS and not phrase.modifiers:
        latest = spoken if phrase.head in _PLURAL_POINTERS else spoken[-1:]
        return tuple(
            (thing, FIRST_NAME) for thing in dict.fromkeys(latest) if thing in looks.objects
        )
    said = _Said.of(phrase)
    if said.points_back and not spoken and not listed:
        return ()
    weights = _weights(said, looks, spoken)
    if not any(weights.values()) and spoken and not said.other:
        weights = _weights(said, looks, ())
    second = _MASS_SENSE if _is_mass(phrase) else _SECOND_SENSE
    return _picked(_best(_sorted_out(weights, looks, role, second)), said, looks, listed)


def verdict(phrase: NounPhrase, candidates: Candidates) -> Verdict:
    """Whether the candidates settle what ``phrase`` means, or the robot has to ask."""
    if not candidates:
        return Verdict.NONE
    if len(candidates) == 1 or candidates[0][1] > candidates[1][1]:
        return Verdict.ONE
    many = phrase.plural or not _ALL.isdisjoint(phrase.determiner.split())
    return Verdict.SEVERAL if many else Verdict.UNCLEAR


def _is_mass(phrase: NounPhrase) -> bool:
    """Whether it is an amount that is spoken of: "some beer", but not "some beers"."""
    return not phrase.plural and not _MASS.isdisjoint(phrase.determiner.split())


def _sorted_out(
    weights: dict[str, float], looks: Looks, role: str, second: float
) -> dict[str, float]:
    """Things before contents of the same name; contents before things after "with" and "of"."""
    things = max((w for o, w in weights.items() if looks.is_thing(o)), default=0.0)
    contents = max((w for o, w in weights.items() if not looks.is_thing(o)), default=0.0)
    if not things or not contents:
        return weights
    behind = role in _ABOUT_CONTENTS
    if not behind and things < contents:
        return weights
    return {o: w * second if looks.is_thing(o) == behind else w for o, w in weights.items()}


def _best(weights: dict[str, float]) -> Candidates:
    """Fits far behind the best one are chance: "pot" for a kettle where there is a pot."""
    top = max(weights.values(), default=0.0)
    near = [(thing, w) for thing, w in weights.items() if w > 0 and w >= _NEAR_BEST * top]
    return tuple(sorted(near, key=lambda row: (-row[1], row[0])))


def _picked(found: Candidates, said: _Said, looks: Looks, listed: Sequence[str]) -> Candidates:
    """Those that a number, an ordinal or a superlative picks: "mug 2", "the biggest mug"."""
    numbered = tuple(row for row in found if row[0].rpartition("_")[2] == said.number)
    if numbered:
        return numbered
    if said.ordinal is not None and listed:
        offered = [row for thing in listed for row in found if row[0] == thing]
        if -1 <= said.ordinal < len(offered):
            return (offered[said.ordinal],)
        return ()
    if said.size and found:
        sizes = {thing: said.size * _size(thing, looks) for thing, _ in found}
        return tuple(row for row in found if sizes[row[0]] == max(sizes.values()))
    return found


def _weights(said: _Said, looks: Looks, spoken: Sequence[str]) -> dict[str, float]:
    """How well it fits each of the things that the noun may name at all."""
    if said.heads[0] == "one" and spoken:
        things: Collection[str] = looks.objects
    else:
        things = looks.names.matching(_nouns(said))
    return {thing: _fit(thing, said, looks, spoken) for thing in things}


def _nouns(said: _Said) -> Iterator[str]:
    """Everything that the noun may be, with fewer or more of the words before it."""
    heads = [*said.heads, *(_longer(said, *said.relations[0]) if said.relations else ())]
    for head in heads:
        for start in range(len(said.marks) + 1):
            yield " ".join([*said.marks[start:], head])


def _longer(said: _Said, name: str, inner: NounPhrase) -> list[str]:
    """The heads with the relation as a part of the name: "a bag of chips"."""
    return [f"{head} {name} {inner.text}" for head in said.heads]


def _size(thing: str, looks: Looks) -> int:
    return _SIZES.get(looks.objects[thing].attributes.get("size", "medium").lower(), 2)


def _fit(thing: str, said: _Said, looks: Looks, spoken: Sequence[str]) -> float:
    if said.other and thing in spoken:
        return 0.0
    if said.holder and not _held(thing, said.holder, looks):
        return 0.0
    fit, relations = _named(thing, said, looks, spoken)
    if not fit or not all(_stands(thing, name, inner, looks, spoken) for name, inner in relations):
        return 0.0
    return fit


def _named(
    thing: str, said: _Said, looks: Looks, spoken: Sequence[str]
) -> tuple[float, Sequence[tuple[str, NounPhrase]]]:
    """How well the noun fits, and the relations that are not part of the name itself."""
    if said.heads[0] == "one" and spoken:
        return _like_the_last(thing, said.marks, looks, spoken), said.relations
    for name, inner in said.relations[:1]:
        fit = _best_noun_fit(thing, _longer(said, name, inner), said.marks, looks)
        if fit:
            return fit, said.relations[1:]
    return _best_noun_fit(thing, said.heads, said.marks, looks), said.relations


def _best_noun_fit(thing: str, heads: Sequence[str], marks: Sequence[str], looks: Looks) -> float:
    return max(_noun_fit(thing, head, marks, looks) for head in heads)


def _noun_fit(thing: str, head: str, marks: Sequence[str], looks: Looks) -> float:
    """The best split of modifiers and head into marks and a name: red | coffee mug."""
    for start in range(len(marks) + 1):
        fit = looks.fit(thing, " ".join([*marks[start:], head]))
        if fit and all(looks.has_mark(thing, mark) for mark in marks[:start]):
            return fit
    return 0.0


def _like_the_last(thing: str, marks: Sequence[str], looks: Looks, spoken: Sequence[str]) -> float:
    """As in "the other one": something with a name of what was spoken of last."""
    names = looks.objects[spoken[-1]].names[:1] if spoken[-1] in looks.objects else ()
    return max((_noun_fit(thing, name, marks, looks) for name in names), default=0.0)


def _held(thing: str, holder: str, looks: Looks) -> bool:
    holders = [o.id for o in looks.objects.values() if looks.scene.domain.is_a(o.type, holder)]
    return any(looks.related(holder_id, "holding", thing) for holder_id in holders)


def _stands(thing: str, name: str, inner: NounPhrase, looks: Looks, spoken: Sequence[str]) -> bool:
    """Whether the thing stands in the relation to something that ``inner`` means."""
    positive = not name.startswith("not ")
    preposition = name.removeprefix("not ")
    others = refer(inner, looks, spoken, preposition)
    related = any(
        other != thing and looks.related(thing, preposition, other) for other, _ in others
    )
    return related == positive
