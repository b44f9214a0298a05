"""The robot's own grounding: how likely each object is what a noun phrase means.

Joins what the words say of the scene (``refer``) with experience: what the same
words, or words with the same head, have meant before. Where neither says
anything, all objects that fit the role are equally likely.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

from verbteach.language import words
from verbteach.language.frames import NounPhrase, VerbFrame
from verbteach.language.looks import Looks
from verbteach.language.morphology import singular
from verbteach.language.refer import refer

Distribution: TypeAlias = tuple[tuple[str, float], ...]
"""Object ids with probabilities that sum to 1, the likeliest first, then by id."""


@dataclass(frozen=True)
class OwnParameters:
    """How much each source of evidence counts, in past uses of the very same phrase.

    ``names``: a perfect fit of the words; ``phrase``, ``head``: a past use of
    the phrase, of another phrase with its head; ``kind``: the share of a past
    use that passes to other objects of the same kind; ``contents``: the share
    of a substance's weight that passes to what it is in; ``values``: whether a
    phrase may mean a value of the domain, such as a substance, itself.
    """

    names: float = 2.0
    phrase: float = 1.0
    head: float = 0.5
    kind: float = 0.5
    contents: float = 0.5
    values: bool = True


@dataclass(frozen=True)
class Experience:
    """Counts of (noun phrase in lower case, object id) pairs; counts may be fractions."""

    counts: Mapping[tuple[str, str], float]

    @classmethod
    def of(cls, pairs: Iterable[tuple[str, str, float]]) -> Experience:
        """Gather weighted pairs; a phrase that could have meant several shares its weight."""
        counts: dict[tuple[str, str], float] = {}
        for phrase, thing, weight in pairs:
            key = (phrase.lower(), thing)
            counts[key] = counts.get(key, 0.0) + weight
        return cls(counts)

    @cached_property
    def by_phrase(self) -> Mapping[str, Mapping[str, float]]:
        """For each phrase the objects it has meant, with counts."""
        return self._grouped(str)

    @cached_property
    def by_head(self) -> Mapping[str, Mapping[str, float]]:
        """The same for each head noun in the singular."""
        return self._grouped(head_of)

    def _grouped(self, key_of: Callable[[str], str]) -> Mapping[str, Mapping[str, float]]:
        found: dict[str, dict[str, float]] = {}
        for (phrase, thing), count in sorted(self.counts.items()):
            group = found.setdefault(key_of(phrase), {})
            group[thing] = group.get(thing, 0.0) + count
        return found


NO_EXPERIENCE = Experience({})
DEFAULTS = OwnParameters()


def head_of(phrase: str) -> str:
    """The singular of a phrase's last word."""
    last = phrase.rpartition(" ")[2]
    return singular(last)


def ground(
    frame: VerbFrame,
    looks: Looks,
    experience: Experience = NO_EXPERIENCE,
    spoken: Sequence[str] = (),
    parameters: OwnParameters = DEFAULTS,
) -> tuple[tuple[NounPhrase, Distribution], ...]:
    """A distribution over objects for each of the frame's noun phrases, in the order said."""
    return tuple(
        (a.phrase, ground_phrase(a.phrase, looks, experience, spoken, a.role, parameters))
        for a in frame.arguments
    )


def ground_phrase(
    phrase: NounPhrase,
    looks: Looks,
    experience: Experience = NO_EXPERIENCE,
    spoken: Sequence[str] = (),
    role: str = "",
    parameters: OwnParameters = DEFAULTS,
) -> Distribution:
    """A distribution over the objects that ``phrase`` may mean; empty in an empty scene."""
    weights = _named(phrase, looks, spoken, role, parameters)
    for thing, weight in _experienced(phrase, looks, experience, parameters).items():
        weights[thing] = weights.get(thing, 0.0) + weight
    if not parameters.values:
        weights = {thing: w for thing, w in weights.items() if looks.is_thing(thing)}
    return _normalised(weights) or _normalised(dict.fromkeys(fitting(looks, role), 1.0))


def _named(
    phrase: NounPhrase, looks: Looks, spoken: Sequence[str], role: str, parameters: OwnParameters
) -> dict[str, float]:
    """The fits that the words alone have, passed on from substances to what they are in."""
    weights = {t: parameters.names * fit for t, fit in refer(phrase, looks, spoken, role)}
    for value in [thing for thing in weights if not looks.is_thing(thing)]:
        for holder in looks.objects:
            if looks.is_thing(holder) and looks.related(holder, "with", value):
                share = parameters.contents * weights[value]
                weights[holder] = weights.get(holder, 0.0) + share
    return weights


def _experienced(
    phrase: NounPhrase, looks: Looks, experience: Experience, parameters: OwnParameters
) -> dict[str, float]:
    text = phrase.text.lower()
    said = experience.by_phrase.get(text) or experience.by_phrase.get(bare_text(phrase), {})
    alike = experience.by_head.get(phrase.head, {})
    weights: dict[str, float] = {}
    for group, trust in ((said, parameters.phrase), (alike, parameters.head)):
        total = math.fsum(group.values())
        for thing, count in group.items():
            # Many uses settle a phrase more than one does, but never by their number alone.
            weight = trust * count * (1 + math.log1p(total)) / max(total, 1.0)
            _pass_on(thing, weight, looks, parameters, weights)
    return weights


def _pass_on(
    thing: str,
    weight: float,
    looks: Looks,
    parameters: OwnParameters,
    weights: dict[str, float],
) -> None:
    """Count a past use for the object itself, or where it is not here for its like."""
    if thing in looks.objects:
        weights[thing] = weights.get(thing, 0.0) + weight
        return
    like = [o for o in looks.objects if kind_of(o) == kind_of(thing)]
    for other in like:
        weights[other] = weights.get(other, 0.0) + parameters.kind * weight / len(like)


def bare_text(phrase: NounPhrase) -> str:
    """The phrase without its determiner, as experience may hold it."""
    return phrase.text.lower().removeprefix(phrase.determiner).strip()


def kind_of(object_id: str) -> str:
    """What an id says without its number: ``Mug`` for ``Mug_2``."""
    stem, _, number = object_id.rpartition("_")
    return stem if number.isdecimal() else object_id


def fitting(looks: Looks, role: str) -> tuple[str, ...]:
    """The things that a phrase in this role could mean at all, where its words say nothing.

    Behind a preposition of place those that something is on, in or next to.
    """
    things = tuple(thing for thing in looks.objects if looks.is_thing(thing))
    if role not in words.LOCATIVES | {"into", "onto", "from", "out of", "off"}:
        return things
    places = {place[1] for thing in things if (place := looks.place(thing))}
    return tuple(thing for thing in things if thing in places) or things


def _normalised(weights: Mapping[str, float]) -> Distribution:
    total = math.fsum(sorted(weights.values()))
    if total <= 0:
        return ()
    ranked = sorted(weights.items(), key=lambda item: (-item[1], item[0]))
    return tuple((thing, weight / total) for thing, weight in ranked if weight > 0)
