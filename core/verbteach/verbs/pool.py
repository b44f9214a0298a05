"""The goal belief: what a command may be meant to change, as arrays, with what answers did to it.

Each distinct change is a hypothesis; each way in which a demonstration, bound
to a joint grounding, gives it is a support. The probability of a hypothesis is
the sum of its supports' weights times the probability of their groundings,
times the likelihood of the answers so far. What to do is chosen by the
expected Jaccard index (minimum Bayes risk), and not only among the hypotheses:
a conjunction of what most of them want is a candidate too, and an answer edits
all of them, as far as the teacher is believed. It knows no question's wording and no policy.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import compress, islice

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.analogy import POSSIBLE, Analogies, Gathered
from verbteach.verbs.examples import Memory
from verbteach.verbs.goal_choice import Decision
from verbteach.verbs.in_hand import handed, held_things, speaking_of
from verbteach.verbs.resemblance import Kernel
from verbteach.verbs.vocabulary import Vocabulary
from verbteach.world.fluents import Fluent, Goal, Literal, State

Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

PLACES: Mapping[str, int] = {
    "On": 0, "In": 0, "Grasping": 1, "on": 0, "in": 0, "beside": 0, "grasping": 1,
}  # fmt: skip
"""Predicates that say where a thing is, with the argument that is the thing: it is in one place."""

CHOSEN = Kernel(
    verb=2.5,
    arity=0.4,
    slots=1.7,
    words=1.7,
    objects=0.85,
    kinds=2.1,
    possible=4.0,
    open=1.3,
    hand=2.0,
)
"""The kernel that was measured best on every second environment of the shared corpus."""


@dataclass(frozen=True)
class PoolParameters:
    """How demonstrations are weighed, and how far answers and hypotheses are trusted.

    ``examples`` are bound at most, the most alike first. ``fit`` is the
    probability that a right hypothesis agrees with a right answer (hypotheses
    are near the truth, rarely it); ``reliability`` that the teacher answers
    rightly: from ``edits_from`` on an answer settles its literal, below that
    it counts by Bayes' rule. ``kept`` hypotheses and ``choices`` of them take
    part in a decision; ``thresholds`` make conjunctions of the likely literals.
    """

    kernel: Kernel = CHOSEN
    examples: int = 150
    fit: float = 0.9
    reliability: float = 1.0
    edits_from: float = 0.95
    kept: int = 128
    choices: int = 40
    thresholds: tuple[float, ...] = (0.2, 0.3, 0.4, 0.5)
    places: Mapping[str, int] = field(default_factory=lambda: dict(PLACES))

    @cached_property
    def floors(self) -> Floats:
        """The thresholds, one in a row."""
        return np.array(self.thresholds)[:, None]

    @property
    def agreement(self) -> float:
        """The probability that a right hypothesis agrees with an answer as given."""
        return self.fit * self.reliability + (1.0 - self.fit) * (1.0 - self.reliability)


@dataclass(frozen=True)
class GoalPool:
    """A belief over hypotheses; values never change.

    ``truths`` (hypotheses x literals) are edited by the answers: what was said
    by a teacher who may err is there as a probability. ``source``,
    ``grounding`` and ``weight`` describe supports; ``chances`` are the joint
    groundings' probabilities; ``answers`` what was answered, by literal number.
    """

    parameters: PoolParameters
    literals: Vocabulary
    groundings: tuple[tuple[str, ...], ...]
    truths: Bools | Floats
    source: Ints
    grounding: Ints
    weight: Floats
    chances: Floats
    likelihood: Floats
    answers: tuple[tuple[int, bool], ...] = ()

    @property
    def empty(self) -> bool:
        """Whether nothing is known that could be meant."""
        return not len(self.truths)

    @cached_property
    def supports(self) -> Floats:
        """Each support's probability, given the answers; they sum to one."""
        mass = self.weight * self.chances[self.grounding] * self.likelihood[self.source]
        total = mass.sum()
        if total <= 0.0:  # the answers rule everything out: start again from the weights alone
            mass, total = self.weight, self.weight.sum()
        return np.asarray(mass / total)

    @cached_property
    def probabilities(self) -> Floats:
        """Each hypothesis's probability; they sum to one."""
        return _summed(self.source, self.supports, len(self.truths))

    @cached_property
    def marginals(self) -> Floats:
        """Each literal's probability of being part of what is meant."""
        return np.asarray(self.probabilities @ self.truths)

    @cached_property
    def doubts(self) -> Floats:
        """How doubtful each literal is: the lesser of its probability and what is left of 1."""
        return np.minimum(self.marginals, 1.0 - self.marginals)

    @cached_property
    def referents(self) -> Floats:
        """Each joint grounding's probability, given everything."""
        return _summed(self.grounding, self.supports, len(self.groundings))

    @cached_property
    def decision(self) -> Decision:
        """The choice to make now."""
        order = (-self.probabilities).argsort(kind="stable")[: self.parameters.kept]
        truths = self.truths.take(order, axis=0)
        chances = self.probabilities.take(order)
        likely = self.marginals > self.parameters.floors
        singles = truths.astype(np.float32)
        first = truths[: self.parameters.choices]
        wanted = first if first.dtype == np.bool_ else first > 0.5
        choices = np.concatenate([wanted, likely]).astype(np.float32)
        shared, sizes = choices @ singles.T, np.add.reduce(singles, 1)
        union = np.add.reduce(choices, 1)[:, None] + sizes - shared
        return Decision(singles, chances / chances.sum(), choices, sizes, shared, union, order)

    def ranked_goals(self) -> Iterator[tuple[Goal, float]]:
        """The goals with their expected Jaccard index, the best first, without repeats."""
        if self.empty:
            return
        now = self.decision
        met = {bytes(len(self.literals))}  # a choice of nothing is no goal
        for choice in now.order.tolist():
            row = now.choices[choice] > 0
            if (key := row.tobytes()) not in met:
                met.add(key)
                yield self.literals.goal(key), float(now.values[choice])

    def goals(self, most: int) -> tuple[tuple[Goal, float], ...]:
        """The ``most`` best goals of :meth:`ranked_goals`."""
        return tuple(islice(self.ranked_goals(), most))

    def goal(self, row: Bools) -> Goal:
        """The literals of a row as a goal."""
        return self.literals.goal(row.tobytes())

    def answered(self, literal: int, truth: bool) -> GoalPool:
        """The belief after the teacher said whether a literal should hold."""
        fit, reliability = self.parameters.fit, self.parameters.reliability
        held = self.truths[:, literal]
        wanted = np.where(held if held.dtype == np.bool_ else held > 0.5, fit, 1.0 - fit)
        said = wanted * (reliability if truth else 1.0 - reliability)
        likely = said + (1.0 - wanted) * (1.0 - reliability if truth else reliability)
        settles = reliability >= self.parameters.edits_from
        truths = self.truths.copy() if settles else self.truths.astype(np.float64)
        truths[:, literal] = truth if settles else said / likely
        return replace(
            self,
            truths=truths,
            likelihood=self.likelihood * likely,
            answers=(*self.answers, (literal, truth)),
        )

    def regrounded(self, chances: Floats) -> GoalPool:
        """The belief under other probabilities of the joint groundings."""
        return replace(self, chances=chances)

    def yes_chances(self, literals: Sequence[int]) -> list[float]:
        """The probability that the teacher will say yes, for each of the literals."""
        trust, chances = self.parameters.agreement, self.marginals[literals]
        yes: list[float] = (chances * trust + (1.0 - chances) * (1.0 - trust)).tolist()
        return yes

    def literal_gains(self, literals: Sequence[int]) -> Floats:
        """How much asking about each literal raises the expected Jaccard index of the best goal."""
        now, trust = self.decision, self.parameters.agreement
        wanted = now.truths[:, literals] > 0
        yes = now.chances[:, None] * np.where(wanted, trust, 1.0 - trust)
        no = now.chances[:, None] - yes
        chosen = now.choices[:, literals] > 0
        after_yes = now.if_added.expected(chosen, wanted, yes)
        after_no = now.if_taken.expected(chosen, wanted, no)
        return np.asarray(after_yes.max(0) + after_no.max(0) - now.value)

    def grounding_gain(self, part: Ints, parts: int) -> float:
        """The same for a question that tells apart ``parts`` of the joint groundings.

        ``part`` has the number of its part for each joint grounding.
        """
        now, size = self.decision, len(self.truths)
        place = part[self.grounding] * size + self.source
        mass = np.bincount(place, self.supports, minlength=parts * size).reshape(parts, size)
        values = [float((now.jaccard @ one).max()) for one in mass.take(now.index, axis=1)]
        scale = float(self.probabilities[now.index].sum())
        return sum(values) / scale - now.value if scale > 0 else 0.0

    @cached_property
    def certainty(self) -> float:
        """The probability that the best goal is exactly what is meant."""
        now = self.decision
        if self.truths.dtype == np.bool_:
            return float(now.chances[now.jaccard[now.order[0]] > 0.999].sum())
        best = now.choices[now.order[0]] > 0
        return float(now.chances @ np.where(best, now.truths, 1.0 - now.truths).prod(1))

    def likenesses(self, outcomes: Sequence[Goal]) -> list[float]:
        """The expected Jaccard index of what each of some executions would bring about."""
        now, number = self.decision, self.literals.numbers
        rows = np.zeros((len(outcomes), len(self.literals)), dtype=np.float32)
        for row, outcome in zip(rows, outcomes, strict=True):
            row[[number[literal] for literal in outcome if literal in number]] = 1.0
        # BLAS may raise the flag of an invalid value for what is beside the array; @ would warn.
        shared = rows.dot(now.truths.T)
        sizes = np.array([len(outcome) for outcome in outcomes], dtype=np.float32)
        union = sizes[:, None] + now.sizes - shared
        alike = np.where(union > 0, shared / np.maximum(union, 1e-9), 0.0).astype(np.float64)
        return [float(row @ now.chances) for row in alike]

    @property
    def numbers(self) -> Mapping[Literal, int]:
        """The literals' numbers."""
        return self.literals.numbers


class PoolSource:
    """What a command's pool is made from, whatever the state is believed to be."""

    def __init__(self, analogies: Analogies, memory: Memory, parameters: PoolParameters) -> None:
        self.analogies = analogies
        self.parameters = parameters
        self.nearest = analogies.nearness(memory)
        self._gathered: Gathered = analogies.gathered(
            memory, parameters.kernel, parameters.examples
        )

    def pool(self, state: State, chances: Floats) -> GoalPool:
        """The belief where ``state`` is believed and groundings have the probabilities ``chances``.

        What holds already is no change, and what comes to a new place leaves
        the place it is believed to be at.
        """
        found = self._gathered
        spoken_of = np.zeros(len(self.analogies.literals), dtype=bool)
        spoken_of[found.literals] = True
        literals = list(compress(self.analogies.literals, spoken_of.tolist()))
        bound = np.zeros((len(found.grounding), len(literals)), dtype=bool)
        bound[found.row, (spoken_of.cumsum() - 1)[found.literals]] = True
        held = held_things(state) if self.parameters.kernel.hand else ()
        if held:
            literals, bound, found = self._with_held(literals, bound, held)
        literals, wanted = self._with_departures(literals, bound, state)
        return self._merged(found, literals, wanted, state, held, chances)

    def _with_held(
        self, literals: list[Literal], bound: Bools, held: Sequence[str]
    ) -> tuple[list[Literal], Bools, Gathered]:
        """Add what demonstrations let go of, for the things in the hand."""
        found = self._gathered
        now = handed(literals, bound, held, self.analogies.surroundings.possible)
        alike = found.alike[now.source]
        alike[:, POSSIBLE] *= now.possible
        wider = found._replace(
            grounding=np.concatenate([found.grounding, found.grounding[now.source]]),
            share=np.concatenate([found.share, found.share[now.source]]),
            alike=np.concatenate([found.alike, alike]),
            words=np.concatenate([found.words, found.words[now.source]]),
        )
        return now.literals, now.bound, wider

    def _with_departures(
        self, literals: list[Literal], bound: Bools, state: State
    ) -> tuple[list[Literal], Bools]:
        """Add what ceases because a thing comes to another place."""
        places = self.parameters.places
        now = _whereabouts(state, tuple(sorted(places.items())))
        index = {literal: column for column, literal in enumerate(literals)}
        leaves: list[tuple[int, int]] = []
        for column, (fluent, positive) in enumerate(tuple(literals)):
            if positive and fluent.predicate in places:
                for old in now.get(fluent.args[places[fluent.predicate]], ()):
                    if old != fluent:
                        leaves.append((column, index.setdefault(Literal(old, False), len(index))))
        wider = np.zeros((len(bound), len(index)), dtype=bool)
        wider[:, : len(literals)] = bound
        for column, departure in leaves:
            wider[:, departure] |= bound[:, column]
        return list(index), wider

    def _merged(
        self,
        found: Gathered,
        literals: list[Literal],
        wanted: Bools,
        state: State,
        held: Sequence[str],
        chances: Floats,
    ) -> GoalPool:
        order = sorted(
            (c for c, literal in enumerate(literals) if not literal.holds(state)),
            key=lambda c: literals[c],
        )
        rows = wanted[:, order]
        left = rows.any(1)
        truths, source = _distinct(rows[left])
        share_open = _counts(rows) / np.maximum(_counts(wanted), 1)
        about = speaking_of([literals[c] for c in order] if held else (), held)
        of_held: Bools = np.zeros(len(rows), dtype=bool)
        if held:
            of_held = np.asarray(rows[:, about].any(1))
        alike = np.concatenate([found.alike, share_open[:, None], of_held[:, None]], axis=1)
        log = found.words + alike @ self.parameters.kernel.of_bindings
        weight = found.share * np.exp(log - (log.max() if len(log) else 0.0))
        return GoalPool(
            self.parameters,
            Vocabulary(literals[c] for c in order),
            self.analogies.groundings,
            truths,
            source,
            found.grounding[left],
            weight[left],
            chances,
            np.ones(len(truths)),
        )


@lru_cache(maxsize=128)
def _whereabouts(
    state: State, places: tuple[tuple[str, int], ...]
) -> Mapping[str, Sequence[Fluent]]:
    """What says where each thing is; a state is met again with each memory of demonstrations."""
    argument = dict(places)
    found: dict[str, list[Fluent]] = {}
    for fluent in sorted(f for f in state if f.predicate in argument):
        found.setdefault(fluent.args[argument[fluent.predicate]], []).append(fluent)
    return found


def _summed(index: Ints, values: Floats, size: int) -> Floats:
    return np.bincount(index, values, minlength=size).astype(np.float64)


def _counts(rows: Bools) -> Ints:
    """How many are set in each row: numpy adds bytes up faster than truth values."""
    counted: Ints = np.add.reduce(rows.view(np.uint8), axis=1, dtype=np.uint16).astype(np.int64)
    return counted


def _distinct(rows: Bools) -> tuple[Bools, Ints]:
    """The distinct rows in a fixed order, and for each row which one it is."""
    if not rows.size:
        return rows[:0], np.zeros(0, dtype=np.int64)
    packed = np.packbits(rows, axis=1)
    keys = np.ascontiguousarray(packed).view(np.dtype((np.void, packed.shape[1]))).ravel()
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    return rows[first], inverse.astype(np.int64)
