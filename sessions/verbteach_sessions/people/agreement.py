"""How well a fitted user foretells people it was not fitted to, beside simpler guesses.

People are left out in groups; for each of their answers the population that
was fitted to the others gives a probability for every answer. Where the right
answer is not known, the share of yes stands for it.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from verbteach_sessions.people.fitted_user import FittedUser, FittedUserError
from verbteach_sessions.people.habits import stage
from verbteach_sessions.people.observations import (
    GAVE_UP,
    NO,
    OBJECT,
    UNREAD,
    UNSURE,
    YES,
    Observed,
)
from verbteach_sessions.people.population import Beta

WRONG_OBJECT = "wrong object"
RESAMPLES = 1000
Chances = Mapping[str, float]


@dataclass(frozen=True)
class Share:
    """A mean over answers with its 95 % interval, bootstrapped over people."""

    mean: float
    ci95: tuple[float, float]

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        return {"mean": self.mean, "ci95": list(self.ci95)}


@dataclass(frozen=True)
class Agreement:
    """Held-out agreement.

    ``likeliest``: how often the likeliest answer was the one given; ``never_errs``
    the same of a teacher who always gives the right answer, ``majority`` of the
    answer most often given to that type of question. ``brier`` is the mean squared
    distance of the foretold probabilities from what came (0 is best, 2 worst), and
    ``brier_never_errs`` that of the teacher who always gives the right answer.
    ``rates`` are the predicted and the observed share of each outcome, by
    question type.
    """

    answers: int
    people: int
    likeliest: Share
    never_errs: Share
    majority: Share
    brier: Share
    brier_never_errs: Share
    rates: Mapping[str, Mapping[str, tuple[float, float]]]

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, as the command line prints it."""
        return {
            "answers": self.answers,
            "people": self.people,
            "agreement": self.likeliest.to_json(),
            "agreement_never_errs": self.never_errs.to_json(),
            "agreement_majority": self.majority.to_json(),
            "brier": self.brier.to_json(),
            "brier_never_errs": self.brier_never_errs.to_json(),
            "rates": {
                name: {
                    outcome: {"predicted": predicted, "observed": observed}
                    for outcome, (predicted, observed) in rates.items()
                }
                for name, rates in self.rates.items()
            },
        }


@dataclass(frozen=True)
class _Foretold:
    observed: Observed
    came: str
    chances: Chances
    majority: str


def agreement(observed: Sequence[Observed], rng: np.random.Generator, folds: int = 5) -> Agreement:
    """Leave people out and foretell their answers; what the robot could not read is left out.

    Raises :class:`FittedUserError` for fewer than two people.
    """
    answers = [one for one in observed if one.answer != UNREAD]
    people = sorted({one.person for one in answers})
    if len(people) < 2:
        raise FittedUserError("agreement needs the answers of two people at least")
    foretold: list[_Foretold] = []
    drawn = [people[i] for i in rng.permutation(len(people)).tolist()]
    for fold in range(min(folds, len(people))):
        out = set(drawn[fold :: min(folds, len(people))])
        foretold += _fold([one for one in answers if one.person not in out],
                          [one for one in answers if one.person in out])  # fmt: skip
    return Agreement(
        len(foretold),
        len(people),
        _share(foretold, lambda one: float(_likeliest(one.chances) == one.came), rng),
        _share(foretold, lambda one: float(_right(one.observed) == one.came), rng),
        _share(foretold, lambda one: float(one.majority == one.came), rng),
        _share(foretold, lambda one: _brier(one.chances, one.came), rng),
        _share(foretold, lambda one: _brier({_right(one.observed): 1.0}, one.came), rng),
        _rates(foretold),
    )


def _fold(known: Sequence[Observed], unseen: Sequence[Observed]) -> list[_Foretold]:
    user = FittedUser.of(known)
    usual = _usual(known)
    spread = user.population.spread
    return [
        _Foretold(one, _came(one), chances(one, spread[one.question]), usual.get(one.question, YES))
        for one in unseen
    ]


def chances(one: Observed, betas: Mapping[str, Beta]) -> Chances:
    """The probability of each answer to a question, by somebody of whom nothing is known."""
    gives_up = betas[f"gives_up.{stage(one.asked)}"].mean
    unsure = (1.0 - gives_up) * betas["unsure"].mean
    rest = 1.0 - gives_up - unsure
    error = betas["error"].mean
    if one.answer in (OBJECT,) or one.question == "np_grd_whq":
        told = {OBJECT: rest * (1.0 - error), WRONG_OBJECT: rest * error}
    elif one.truth is None:
        yes = betas["yes"].mean
        told = {YES: rest * yes, NO: rest * (1.0 - yes)}
    else:
        right, wrong = (YES, NO) if one.truth else (NO, YES)
        told = {right: rest * (1.0 - error), wrong: rest * error}
    return {GAVE_UP: gives_up, UNSURE: unsure, **told}


def _came(one: Observed) -> str:
    return WRONG_OBJECT if one.answer == OBJECT and one.right is False else one.answer


def _right(one: Observed) -> str:
    """What a teacher says who knows everything and never errs; yes where nobody knows."""
    if one.question == "np_grd_whq":
        return OBJECT
    return NO if one.truth is False else YES


def _likeliest(chances: Chances) -> str:
    return max(sorted(chances), key=lambda name: chances[name])


def _brier(chances: Chances, came: str) -> float:
    away = {**chances, came: chances.get(came, 0.0) - 1.0}
    return math.fsum(value * value for value in away.values())


def _usual(known: Sequence[Observed]) -> dict[str, str]:
    counts: dict[str, dict[str, int]] = defaultdict(lambda: defaultdict(int))
    for one in known:
        counts[one.question][_came(one)] += 1
    return {name: max(sorted(found), key=lambda a: found[a]) for name, found in counts.items()}


def _share(
    foretold: Sequence[_Foretold], value: Callable[[_Foretold], float], rng: np.random.Generator
) -> Share:
    people = sorted({one.observed.person for one in foretold})
    place = {person: i for i, person in enumerate(people)}
    sums, counts = np.zeros(len(people)), np.zeros(len(people))
    for one in foretold:
        sums[place[one.observed.person]] += value(one)
        counts[place[one.observed.person]] += 1.0
    drawn = rng.integers(len(people), size=(RESAMPLES, len(people)))
    means = sums[drawn].sum(axis=1) / counts[drawn].sum(axis=1)
    low, high = np.quantile(means, [0.025, 0.975])
    return Share(float(sums.sum() / counts.sum()), (float(low), float(high)))


def _rates(foretold: Sequence[_Foretold]) -> dict[str, dict[str, tuple[float, float]]]:
    found: dict[str, dict[str, tuple[float, float]]] = {}
    for name in sorted({one.observed.question for one in foretold}):
        rows = [one for one in foretold if one.observed.question == name]
        outcomes = sorted({key for one in rows for key in (*one.chances, one.came)})
        found[name] = {
            outcome: (
                sum(one.chances.get(outcome, 0.0) for one in rows) / len(rows),
                sum(one.came == outcome for one in rows) / len(rows),
            )
            for outcome in outcomes
        }
    return found
