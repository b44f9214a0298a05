"""How well the robot's own grounding finds the objects that people say a phrase means.

Every phrase is grounded with the experience of the other environments only.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from verbteach.language.frames import NounPhrase
from verbteach.language.looks import Looks
from verbteach.language.own import (
    DEFAULTS,
    NO_EXPERIENCE,
    Distribution,
    Experience,
    OwnParameters,
    bare_text,
    ground_phrase,
)

IN_THE_SET = 0.5
"""Objects at least this likely, measured by the likeliest, make up the candidate set."""


class Case(NamedTuple):
    """A noun phrase in a scene with the objects it may mean; cases of a document are in order."""

    phrase: NounPhrase
    looks: Looks
    objects: tuple[str, ...]
    document: str
    environment: str


@dataclass(frozen=True)
class GroundingScore:
    """Means over phrases, each between 0 and 1.

    ``best``: the likeliest object is one of those meant. ``precision``,
    ``recall``, ``jaccard``: the candidate set against those meant. ``mass``: the
    """

    phrases: int
    best: float
    precision: float
    recall: float
    jaccard: float
    mass: float


def leave_one_environment_out(
    cases: Sequence[Case], parameters: OwnParameters = DEFAULTS, *, experienced: bool = True
) -> GroundingScore:
    """Score every case with what the cases of all other environments teach."""
    found: list[tuple[Case, Distribution]] = []
    for environment in sorted({case.environment for case in cases}):
        seen = [case for case in cases if case.environment != environment]
        experience = learned(seen) if experienced else NO_EXPERIENCE
        found += _grounded(
            [c for c in cases if c.environment == environment], experience, parameters
        )
    return summary(found)


def learned(cases: Iterable[Case]) -> Experience:
    """What the cases teach: each object that a phrase may mean gets its share of one use."""
    return Experience.of(
        (bare_text(case.phrase), thing, 1 / len(case.objects))
        for case in cases
        for thing in case.objects
    )


def _grounded(
    cases: Sequence[Case], experience: Experience, parameters: OwnParameters
) -> list[tuple[Case, Distribution]]:
    found: list[tuple[Case, Distribution]] = []
    spoken: list[str] = []
    document = ""
    for case in cases:
        spoken = spoken if case.document == document else []
        document = case.document
        told = ground_phrase(case.phrase, case.looks, experience, spoken[-1:], "", parameters)
        found.append((case, told))
        spoken += [told[0][0]] if told else []
    return found


def summary(found: Sequence[tuple[Case, Distribution]]) -> GroundingScore:
    """Average over phrases."""
    rows = [_row(set(case.objects), told) for case, told in found]
    count = max(len(rows), 1)
    best, precision, recall, jaccard, mass = (
        sum(column) / count for column in zip(*rows, strict=True)
    )
    return GroundingScore(len(rows), best, precision, recall, jaccard, mass)


def _row(meant: set[str], told: Distribution) -> tuple[float, float, float, float, float]:
    top = told[0][1] if told else 1.0
    chosen = {thing for thing, chance in told if chance >= IN_THE_SET * top}
    both = len(chosen & meant)
    return (
        float(bool(told) and told[0][0] in meant),
        both / max(len(chosen), 1),
        both / len(meant),
        both / len(chosen | meant),
        sum(chance for thing, chance in told if thing in meant),
    )
