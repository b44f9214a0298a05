"""What can be said for and against one demonstration's vote for a goal, as numbers.

Known of She & Chai (2016) are ``satisfied``, ``other_things``, ``phrases``, and
two that are votes' own here: a hypothesis at the top level is one that is some
demonstration's ``whole`` change, and a frequent one has many votes. The others
are this project's. Each lies between 0 and 1 and depends on nothing but the
one demonstration and the situation, so that a fold leaves out a demonstration
by leaving out its votes.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from verbteach.verbs.application import Evidence, Situation, Support
from verbteach.verbs.knowledge import Use
from verbteach.verbs.space import Demonstration
from verbteach.world.fluents import Literal

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


class Vote(NamedTuple):
    """One demonstration's vote: features (as ``NAMES``) and its grounding's probability."""

    features: tuple[float, ...]
    probability: float
    demonstration: Demonstration


def votes(evidence: Evidence) -> Iterator[Vote]:
    """The votes for a goal, by support and then by demonstration."""
    satisfied = evidence.satisfied
    negative = sum(not literal.positive for literal in evidence.goal) / len(evidence.goal)
    size = min(len(evidence.goal), _LARGE) / _LARGE
    for support in evidence.supports:
        others = _other_things(support.node.literals)
        frame, wanted = support.frame.key, evidence.situation.frame
        own = (float(frame.verb == wanted.verb), float(frame.arity == wanted.arity))
        replaced = float(support.replaced)
        for use in support.uses:
            phrases = _phrases(evidence.situation.phrases, use.demonstration.phrases)
            marks = (float(use.leaf), float(use.base), float(use.confirmed))
            objects = _objects(evidence.situation, support, use)
            features = (
                satisfied, others, *phrases, *marks, *own, *objects, replaced, size, negative
            )  # fmt: skip
            yield Vote(features, support.probability, use.demonstration)


_LARGE = 6


@lru_cache(maxsize=65_536)
def _other_things(hypothesis: tuple[Literal, ...]) -> float:
    about = [any(word.startswith("<") for word in fluent.args) for fluent, _ in hypothesis]
    return sum(about) / len(about)


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


def _objects(situation: Situation, support: Support, use: Use) -> tuple[float, float]:
    """How many arguments are the demonstration's own, and how alike they are, on average.

    Of an argument that the hypothesis does not speak of, the belief's mean.
    """
    old = use.demonstration.grounding
    key = support.arguments, old
    known = situation.likenesses.get(key)
    if known is None:
        known = situation.likenesses[key] = _compared(situation, *key)
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
