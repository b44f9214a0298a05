"""What the example corpus holds: who teaches, what, under which policy; drawn from one seed.

Nothing is carried out here. The people are made up: their rates and their
words come from the tables below, and every session says that it is simulated.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from verbteach.dialogue.lesson import Lesson
from verbteach_sessions.names import new_code
from verbteach_sessions.people.habits import ASKED, JUDGED, Habits, Phrasings, Rates
from verbteach_sessions.people.population import RATES, Beta, Population

POLICIES = ("random", "split", "random", "rl", "random", "manual", "random", "she16")
"""In turn. ``random`` is there often, since only a policy that explores can be learned from."""

NOISES = ("perfect", "std3")
LONGEST = 8
"""Actions in a demonstration: longer ones take a person, and a machine, too long."""

_ASKED = {
    "gives_up.first": Beta(0.3, 14.7),
    "gives_up.later": Beta(0.8, 9.2),
    "gives_up.late": Beta(1.8, 5.2),
    "unsure": Beta(0.9, 11.1),
    "error": Beta(0.9, 9.1),
    "words": Beta(1.0, 1.0),
    "yes": Beta(1.0, 1.0),
}
_JUDGED = {
    **_ASKED,
    **{name: Beta(0.2, 19.8) for name in RATES if name.startswith("gives_up")},
    "unsure": Beta(0.2, 19.8),
    "error": Beta(0.5, 11.5),
}
_WORDING: tuple[Mapping[str, Phrasings], ...] = (
    {"yes": (("yes", 5), ("yes please", 1)), "no": (("no", 1),), "unsure": (("not sure", 1),)},
    {
        "yes": (("yep", 3), ("sure", 2), ("that's right", 1)),
        "no": (("nope", 3), ("no way", 1)),
        "unsure": (("no idea", 1), ("dunno", 2)),
    },
    {
        "yes": (("yeah", 4), ("i think so", 1), ("exactly", 1)),
        "no": (("nah", 2), ("not really", 1), ("i don't think so", 1)),
        "unsure": (("hard to say", 1), ("i don't know", 2)),
    },
    {
        "yes": (("correct", 1), ("yes", 2)),
        "no": (("incorrect", 1), ("no", 2)),
        "unsure": (("i am not sure", 1),),
    },
)


@dataclass(frozen=True)
class Person:
    """Somebody made up: a code, habits, and whose manner of showing things they have."""

    code: str
    habits: Habits
    manner: str

    def to_json(self) -> dict[str, Any]:
        """What is true of the person, which a fit should find again."""
        rates = {name: one._asdict() for name, one in self.habits.rates.items()}
        return {"manner": self.manner, "rates": rates}


@dataclass(frozen=True)
class Planned:
    """One session to be held: the ``number``-th, from 0."""

    number: int
    person: Person
    policy: str
    noise: str
    seed: int
    lessons: tuple[Lesson, ...]


def invented(wording: Mapping[str, Phrasings]) -> Population:
    """The population that people of the example are drawn from, talking like this."""
    return Population({name: _JUDGED if name in JUDGED else _ASKED for name in ASKED}, wording)


def plan(lessons: Sequence[Lesson], sessions: int, each: int, seed: int) -> tuple[Planned, ...]:
    """``sessions`` sessions of ``each`` lessons; every person holds two, one after the other."""
    short = [one for one in lessons if len(one.demonstration) <= LONGEST]
    people = [_person(short, seed, number) for number in range((sessions + 1) // 2)]
    return tuple(_planned(short, people[n // 2], n, each, seed) for n in range(sessions))


def _person(lessons: Sequence[Lesson], seed: int, number: int) -> Person:
    rng = np.random.default_rng([seed, 1, number])
    manners = sorted({one.teacher for one in lessons})
    habits = invented(_WORDING[number % len(_WORDING)]).person(rng)
    habits = Habits({name: _shared(habits, name) for name in ASKED}, habits.wording)
    return Person(new_code(rng.bytes), habits, manners[number % len(manners)])


def _shared(habits: Habits, name: str) -> Rates:
    """A person types or presses keys in all questions alike."""
    return habits.rates[name]._replace(words=habits.rates[ASKED[0]].words)


def _planned(
    lessons: Sequence[Lesson], person: Person, number: int, each: int, seed: int
) -> Planned:
    rng = np.random.default_rng([seed, 2, number])
    return Planned(
        number,
        person,
        POLICIES[number % len(POLICIES)],
        NOISES[(number // len(POLICIES)) % len(NOISES)],
        int(rng.integers(2**31)),
        _curriculum([one for one in lessons if one.teacher == person.manner], each, rng),
    )


def _curriculum(
    lessons: Sequence[Lesson], each: int, rng: np.random.Generator
) -> tuple[Lesson, ...]:
    """Verbs shown in one scene and then asked for in another, so that there is something to do."""
    by_verb: dict[str, list[Lesson]] = {}
    for lesson in lessons:
        by_verb.setdefault(lesson.verb, []).append(lesson)
    verbs = [verb for verb in sorted(by_verb) if len({x.scene for x in by_verb[verb]}) > 1]
    drawn = [verbs[i] for i in rng.permutation(len(verbs))[: (each + 1) // 2].tolist()]
    pairs = [_two_scenes(by_verb[verb], rng) for verb in drawn]
    return (*(first for first, _ in pairs), *(second for _, second in pairs))[:each]


def _two_scenes(lessons: Sequence[Lesson], rng: np.random.Generator) -> tuple[Lesson, Lesson]:
    first = lessons[int(rng.integers(len(lessons)))]
    others = [lesson for lesson in lessons if lesson.scene != first.scene]
    return first, others[int(rng.integers(len(others)))]
