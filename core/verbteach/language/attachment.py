"""Where a prepositional phrase belongs, decided by the scene.

"put the mug on the table in the sink" can mean three things. ``readings`` lists
them from the frame alone; ``attach`` takes the one that the scene bears out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from typing import NamedTuple

from verbteach.language import household, words
from verbteach.language.assembly import OBJECT, PLACE, attached
from verbteach.language.frames import Argument, NounPhrase, VerbFrame
from verbteach.language.looks import Looks
from verbteach.language.refer import refer

_MOST = 4
"""Phrases whose place is reconsidered; 2 ** 4 readings are enough for any sentence."""
_AS_READ = 0.5


class _Link(NamedTuple):
    """A bare phrase, the preposition before it, and whether it is tied to the noun before."""

    role: str
    phrase: NounPhrase
    tied: bool
    free: bool


def readings(frame: VerbFrame) -> tuple[VerbFrame, ...]:
    """The frame with each phrase of place on the verb or on a noun; as it was read comes first."""
    links = [link for argument in frame.arguments for link in _links(argument)]
    links = [_with_freedom(link, links[:index]) for index, link in enumerate(links)]
    free = [index for index, link in enumerate(links) if link.free][:_MOST]
    found = {frame: None}
    for choice in product((True, False), repeat=len(free)):
        tied = dict(zip(free, choice, strict=True))
        chosen = [link._replace(tied=tied.get(i, link.tied)) for i, link in enumerate(links)]
        found.setdefault(replace(frame, arguments=tuple(_arguments(chosen))))
    return tuple(found)


def _links(argument: Argument) -> Iterator[_Link]:
    """An argument as a chain: what was said in order, without its brackets."""
    phrase = argument.phrase
    yield _Link(argument.role, _bare(phrase), tied=False, free=False)
    for name, inner in phrase.relations:
        for index, link in enumerate(_links(Argument(name, inner))):
            yield link._replace(tied=True) if index == 0 else link


def _bare(phrase: NounPhrase) -> NounPhrase:
    if not phrase.relations:
        return phrase
    text = " ".join(filter(None, (phrase.determiner, *phrase.modifiers, phrase.head)))
    short = phrase.text.partition(f" {phrase.relations[0][0]} ")[0]
    return replace(phrase, text=short or text, relations=())


def _with_freedom(link: _Link, before: Sequence[_Link]) -> _Link:
    """Only a phrase of place behind a noun can be moved."""
    fixed = not before or before[-1].role == PLACE or before[-1].phrase.is_pronoun
    placed = link.role in words.LOCATIVES and link.phrase.head not in words.TIME_NOUNS
    return link._replace(free=placed and not fixed)


def _arguments(links: Sequence[_Link]) -> list[Argument]:
    found: list[Argument] = []
    for link in links:
        if link.tied and found:
            last = found[-1]
            found[-1] = Argument(last.role, attached(last.phrase, link.role, link.phrase))
        else:
            found.append(Argument(link.role, link.phrase))
    return found


def attach(frame: VerbFrame, looks: Looks, spoken: Sequence[str] = ()) -> VerbFrame:
    """The reading that the scene bears out best; the frame as it is where it says nothing."""
    options = readings(frame)
    if len(options) == 1:
        return frame
    scores = [_AS_READ, *([0.0] * (len(options) - 1))]
    scores = [s + _support(o, looks, spoken) for s, o in zip(scores, options, strict=True)]
    return options[scores.index(max(scores))]


def _support(frame: VerbFrame, looks: Looks, spoken: Sequence[str]) -> float:
    inside = sum(_truth(argument.phrase, looks, spoken) for argument in frame.arguments)
    return inside - _strain(frame)


def _truth(phrase: NounPhrase, looks: Looks, spoken: Sequence[str]) -> float:
    """+1 for each phrase of place that is true of its noun now, -2 for each that is not."""
    total = 0.0
    for name, inner in phrase.relations:
        if name in words.LOCATIVES:
            alone = replace(phrase, relations=((name, inner),))
            total += 1.0 if refer(alone, looks, spoken) else -2.0
        total += _truth(inner, looks, spoken)
    return total


def _strain(frame: VerbFrame) -> float:
    """How ill the places left on the verb suit it: putting takes one, fetching none."""
    verb = frame.verb.removeprefix("not ").partition(" ")[0]
    directed = any(a.role in words.DIRECTIONALS for a in frame.arguments)
    places = sum(a.role in words.LOCATIVES for a in frame.arguments)
    if verb in household.PLACING:
        return (
            abs(places + directed - 1) * 1.5 if any(_is_object(a) for a in frame.arguments) else 0
        )
    if verb in household.PROCESSING | household.INTRANSITIVE or verb not in household.VERBS:
        return 0.5 * max(places - 1, 0)
    return 3.0 * places


def _is_object(argument: Argument) -> bool:
    return argument.role == OBJECT
