"""A population of simulated people: Beta distributions of rates, from which persons are drawn."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np

from verbteach_sessions.people.habits import ASKED, STAGES, Habits, Phrasings, Rates

RATES = (*(f"gives_up.{stage}" for stage in STAGES), "unsure", "error", "words", "yes")
"""What is counted of every question type. ``yes`` is the share of yes among yes and no: the
answer where nobody can say what the right one is."""


@dataclass(frozen=True)
class Beta:
    """How a rate is spread over people: Beta(``a``, ``b``); ``a + b`` is how alike they are."""

    a: float
    b: float

    @property
    def mean(self) -> float:
        """The mean rate."""
        return self.a / (self.a + self.b)

    def after(self, times: float, of: float) -> Beta:
        """The posterior of a person who did it ``times`` of ``of`` times."""
        return Beta(self.a + times, self.b + of - times)


Spread: TypeAlias = Mapping[str, Mapping[str, Beta]]
"""Betas by question type and rate."""

Rate: TypeAlias = Callable[[Beta], float]


@dataclass(frozen=True)
class Population:
    """People in general: every question type has a Beta for every rate in ``RATES``."""

    spread: Spread
    wording: Mapping[str, Phrasings] = field(default_factory=dict)

    def person(self, rng: np.random.Generator) -> Habits:
        """Somebody new."""
        return self._habits(lambda beta: float(rng.beta(beta.a, beta.b)))

    def mean(self) -> Habits:
        """Nobody in particular: every rate at its mean."""
        return self._habits(lambda beta: beta.mean)

    def _habits(self, rate: Rate) -> Habits:
        return Habits({name: _rates(self.spread[name], rate) for name in ASKED}, self.wording)


def _rates(betas: Mapping[str, Beta], rate: Rate) -> Rates:
    first, later, late = (rate(betas[f"gives_up.{stage}"]) for stage in STAGES)
    unsure, error, words = (rate(betas[name]) for name in ("unsure", "error", "words"))
    return Rates((first, later, late), unsure, error, words)
