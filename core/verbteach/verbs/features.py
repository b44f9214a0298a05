"""What can be said for and against one demonstration's vote for a goal, as numbers.

Known of She & Chai (2016) are ``satisfied``, ``other_things``, ``phrases``, and
two that are votes' own here: a hypothesis at the top level is one that is some
demonstration's ``whole`` change, and a frequent one has many votes. The others
are this project's. Each lies between 0 and 1 and depends on nothing but the
one demonstration and the situation, so that a fold leaves out a demonstration
by leaving out its votes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.application import Evidence, Situation, Support
from verbteach.verbs.space import Demonstration
from verbteach.world.fluents import Goal

NAMES: tuple[str, ...] = (
    "satisfied",  # share of the goal's fluents that hold already
    "other_things",  # share of its fluents about a thing that is no argument
    "phrases",  # likeness of the noun phrases, on average
    "best_phrase",  # likeness of the noun phrases that are most alike
    "least",  # the demonstration kept nothing more general
    "whole",  # it is all that the demonstration changed
    "confirmed",  # its teacher confirmed it
    "same_verb",  # it is the command's verb, not one borrowed from
    "same_frame",  # the demonstration's command had as many noun phrases
    "same_objects",  # share of the arguments that were the demonstration's too
    "alike_objects",  # likeness of what the arguments and the demonstration's afford
    "replaced",  # a thing of the demonstration's is missing here
    "size",  # number of fluents, six or more being 1
    "negative",  # share of fluents that must not hold
)


OF_GOAL = [0, 12, 13]
OF_SUPPORT = [1, 7, 8, 11]
OF_VOTE = [2, 3, 4, 5, 6, 9, 10]
"""The places in ``NAMES`` of what all votes for a goal have in common, those of a support, and
what is each vote's own."""

_LARGE = 6


class Vote(NamedTuple):
    """One demonstration's vote: features (as ``NAMES``) and its grounding's probability."""

    features: tuple[float, ...]
    probability: float
    demonstration: Demonstration


def votes(evidence: Evidence) -> Iterator[Vote]:
    """The votes for a goal, by support and then by demonstration."""
    supports = evidence.supports
    numbers = np.repeat(np.arange(len(supports)), [len(support.uses) for support in supports])
    found = features([evidence.goal], supports, np.zeros_like(numbers), numbers, evidence.situation)
    cast = [(support.probability, use) for support in supports for use in support.uses]
    for row, (probability, use) in zip(found.tolist(), cast, strict=True):
        yield Vote(tuple(row), probability, use.demonstration)


def features(
    goals: Iterable[Goal],
    supports: Sequence[Support],
    goals_of: NDArray[np.int64],
    support_of: NDArray[np.int64],
    situation: Situation,
) -> NDArray[np.float64]:
    """The features of votes (votes x ``NAMES``), given the numbers of their goals and supports."""
    found = np.empty((len(support_of), len(NAMES)))
    if len(support_of):
        found[:, OF_GOAL] = np.array([_of_goal(goal, situation) for goal in goals])[goals_of]
        found[:, OF_SUPPORT] = np.array([_of_support(s, situation) for s in supports])[support_of]
        found[:, OF_VOTE] = np.array(_of_votes(supports, situation)).reshape(-1, len(OF_VOTE))
    return found


def _of_goal(goal: Goal, situation: Situation) -> tuple[float, float, float]:
    held = negative = 0
    for fluent, positive in goal:
        held += (fluent in situation.state) == positive
        negative += not positive
    count = len(goal)
    return held / count, min(count, _LARGE) / _LARGE, negative / count


def _of_support(support: Support, situation: Situation) -> tuple[float, bool, bool, bool]:
    frame, wanted = support.frame.key, situation.frame
    own = frame.verb == wanted.verb, frame.arity == wanted.arity
    return support.node.mould.about_others, *own, support.replaced


def _of_votes(supports: Sequence[Support], situation: Situation) -> list[float]:
    """Each vote's own features, vote after vote."""
    found: list[float] = []
    said: dict[int, tuple[float, float]] = {}  # by identity: a demonstration takes long to hash
    for support in supports:
        for demonstration, _, whole, least, confirmed in support.uses:
            phrases = said.get(id(demonstration))
            if phrases is None:
                phrases = _phrases(situation.phrases, demonstration.phrases)
                said[id(demonstration)] = phrases
            objects = _objects(situation, support.arguments, demonstration.grounding)
            found += (*phrases, least, whole, confirmed, *objects)
    return found


@lru_cache(maxsize=65_536)
def _phrases(said: tuple[str, ...], known: tuple[str, ...]) -> tuple[float, float]:
    """Mean and best Jaccard index of words, phrase by phrase; those without a partner count 0."""
    pairs = [_overlap(a, b) for a, b in zip(said, known, strict=False)]
    longer = max(len(said), len(known))
    return (sum(pairs) / longer, max(pairs)) if pairs else (float(not longer),) * 2


def _overlap(one: str, other: str) -> float:
    words, others = set(one.split()), set(other.split())
    union = len(words | others)
    return len(words & others) / union if union else 1.0


def _objects(
    situation: Situation, arguments: tuple[str | None, ...], old: tuple[str, ...]
) -> tuple[float, float]:
    """How many arguments are the demonstration's own, and how alike they are, on average.

    Of an argument that the hypothesis does not speak of, the belief's mean.
    """
    key = arguments, old
    known = situation.likenesses.get(key)
    if known is None:
        known = situation.likenesses[key] = _compared(situation, arguments, old)
    return known


def _compared(
    situation: Situation, arguments: tuple[str | None, ...], old: tuple[str, ...]
) -> tuple[float, float]:
    longer = max(len(old), len(situation.phrases))
    if not longer:
        return 1.0, 1.0
    marks = situation.surroundings.affordances
    same = alike = 0.0
    own_frame = len(old) == len(situation.phrases)
    for index, (thing, before) in enumerate(zip(arguments, old, strict=True)):
        if thing is not None:
            same += thing == before
            alike += _likeness(marks.get(thing), marks.get(before))
        elif own_frame:
            hit, near = _expected(situation, index, before)
            same, alike = same + hit, alike + near
    return same / longer, alike / longer


def _expected(situation: Situation, index: int, before: str) -> tuple[float, float]:
    """How much of the belief about a phrase is the thing, and how like it the rest is."""
    known = situation.expectations.get((index, before))
    if known is None:
        marks, belief = situation.surroundings.affordances, situation.marginals[index]
        like = sum(p * _likeness(marks.get(o), marks.get(before)) for o, p in belief.items())
        known = situation.expectations[index, before] = belief.get(before, 0.0), like
    return known


@lru_cache(maxsize=65_536)
def _likeness(one: frozenset[str] | None, other: frozenset[str] | None) -> float:
    """The Jaccard index of two affordance sets; 0 where a thing is not here."""
    if one is None or other is None:
        return 0.0
    return len(one & other) / len(one | other) if one | other else 1.0
