"""How far the grammar agrees with frames that a statistical parser made.

The other parser's frames are flat: a verb and every noun phrase of the clause.
They hold its errors ("sink" as a verb), so what differs is counted by kind.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

from verbteach.language.frames import NounPhrase, VerbFrame
from verbteach.language.household import NOUNS, VERBS
from verbteach.language.morphology import singular


class Parsed(NamedTuple):
    """A clause's words with the other parser's verb and noun phrases."""

    text: str
    verb: str
    phrases: tuple[str, ...]


class Difference(Enum):
    """What kind of difference there is about the verb, or about a noun."""

    NO_WORDS = "the clause has no words"
    UNREAD = "the grammar reads nothing"
    NOT_A_VERB = "the other parser's verb is no verb"
    OTHER_VERB = "another verb"
    VERB_AS_NOUN = "the other parser takes a verb for a noun"
    PART_OF_NAME = "one of us cuts a compound differently"
    LEFT_OUT = "the grammar leaves the noun out"
    ADDED = "only the grammar has the noun"


@dataclass(frozen=True)
class Agreement:
    """Shares over the clauses that have words; ``differences`` counts every kind."""

    clauses: int
    verbs: float
    heads_precision: float
    heads_recall: float
    differences: Mapping[Difference, int]


def agreement(clauses: Iterable[tuple[Parsed, Sequence[VerbFrame]]]) -> Agreement:
    """Compare readings with the other parser's frames."""
    kinds: Counter[Difference] = Counter()
    worded = agreed = shared = ours_total = theirs_total = 0
    for parsed, frames in clauses:
        if not any(letter.isalpha() for letter in parsed.text):
            kinds[Difference.NO_WORDS] += 1
            continue
        worded += 1
        verb = _verb_difference(parsed, frames)
        agreed += verb is None
        kinds.update([verb] if verb else [])
        ours, theirs = list(_heads(frames)), [_head(text) for text in parsed.phrases]
        common = Counter(ours) & Counter(theirs)
        shared, ours_total = shared + common.total(), ours_total + len(ours)
        theirs_total += len(theirs)
        kinds.update(_noun_differences(frames, Counter(ours) - common, Counter(theirs) - common))
    return Agreement(
        clauses=worded,
        verbs=agreed / max(worded, 1),
        heads_precision=shared / max(ours_total, 1),
        heads_recall=shared / max(theirs_total, 1),
        differences={kind: kinds[kind] for kind in Difference if kinds[kind]},
    )


def _verb_difference(parsed: Parsed, frames: Sequence[VerbFrame]) -> Difference | None:
    if not frames:
        return Difference.UNREAD
    if any(parsed.verb in frame.verb.split() for frame in frames):
        return None
    return Difference.OTHER_VERB if parsed.verb in VERBS - NOUNS else Difference.NOT_A_VERB


def _noun_differences(
    frames: Sequence[VerbFrame], ours: Counter[str], theirs: Counter[str]
) -> Iterator[Difference]:
    verbs = {frame.verb.split()[0] for frame in frames}
    parts = {word for frame in frames for a in frame.arguments for word in _modifiers(a.phrase)}
    for noun in theirs.elements():
        if noun in verbs:
            yield Difference.VERB_AS_NOUN
        else:
            yield Difference.PART_OF_NAME if noun in parts else Difference.LEFT_OUT
    for _ in ours.elements():
        yield Difference.ADDED


def _heads(frames: Sequence[VerbFrame]) -> Iterator[str]:
    for frame in frames:
        for argument in frame.arguments:
            yield from _inner(argument.phrase)


def _inner(phrase: NounPhrase) -> Iterator[str]:
    yield phrase.head
    for _, inner in phrase.relations:
        yield from _inner(inner)


def _modifiers(phrase: NounPhrase) -> Iterator[str]:
    yield from phrase.modifiers
    for _, inner in phrase.relations:
        yield from _modifiers(inner)


def _head(text: str) -> str:
    words = text.lower().split()
    return singular(words[-1]) if words else ""
