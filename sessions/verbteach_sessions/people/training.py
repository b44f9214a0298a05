"""A fitted user as the simulated humans that a policy is trained with.

In training a question that is passed over and one that is answered with "I
don't know" come to the same, so the two rates become one. Training knows no
stages of patience: the rate is that of a command's first questions.
"""

from __future__ import annotations

import numpy as np

from verbteach.experiments.simulated_human import AnswerRates, People, Person
from verbteach_sessions.people.habits import Habits
from verbteach_sessions.people.population import Population

PEOPLE = 40


def training_person(habits: Habits) -> Person:
    """One person's rates, as training has them."""
    rates = {
        name: AnswerRates(one.error, 1.0 - (1.0 - one.passes(0)) * (1.0 - one.unsure))
        for name, one in sorted(habits.rates.items())
    }
    return Person(by_question=rates)


def training_people(
    population: Population, rng: np.random.Generator, count: int = PEOPLE
) -> People:
    """``count`` people drawn from the population, each of whom teaches some of the lessons."""
    return People(people=tuple(training_person(population.person(rng)) for _ in range(count)))
