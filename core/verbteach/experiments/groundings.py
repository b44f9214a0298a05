"""The three grounding modes, always named beside a result.

A demonstration tells the learner which of a phrase's objects was meant: the
one that changed. A new command does not, unless the mode is ``oracle``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from verbteach.verbs.application import GroundingBelief, certain, uniform
from verbteach.verbs.instance import Instance
from verbteach.verbs.space import Demonstration

Grounder: TypeAlias = Callable[[Instance, Sequence[Demonstration]], GroundingBelief]
"""Grounds an instance's noun phrases, given the demonstrations that were learned from."""


def oracle(instance: Instance, experience: Sequence[Demonstration]) -> GroundingBelief:
    """The gold objects: what the published scores used, though it looks at the outcome."""
    return certain(instance.grounding)


def corpus(instance: Instance, experience: Sequence[Demonstration]) -> GroundingBelief:
    """Uniform over the corpus's mapping: the default."""
    return uniform(instance.candidates)


GROUNDERS: Mapping[str, Grounder] = {"oracle": oracle, "corpus": corpus}


def shown(
    belief: GroundingBelief, changed: frozenset[str], handled: frozenset[str]
) -> tuple[str, ...]:
    """The grounding that a demonstration settles on.

    The one with most objects among those that ``changed``, then among those
    ``handled``; then the likeliest, then the first.
    """

    def order(row: tuple[tuple[str, ...], float]) -> tuple[int, int, float]:
        objects, probability = row
        return (
            sum(thing in changed for thing in objects),
            sum(thing in handled for thing in objects),
            probability,
        )

    return max(belief, key=order)[0]
