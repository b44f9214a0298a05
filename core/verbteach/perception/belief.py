"""What the robot believes of a state: a confidence for each fluent, never more than that.

A confidence is a probability, not a proof: at one half or below nothing is
taken for true. An answer settles a fluent.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

from verbteach.world.fluents import Fluent, State

BELIEVED = 0.5
_SURE = 1.0 - 1e-9
"""Full confidence, as evidence: two things seen so may still exclude each other."""


class Exclusivity(NamedTuple):
    """At most one fluent about the same thing is true.

    ``arguments`` names the predicates, each with the number of the argument
    that is the thing: ``(("on", 0), ("in", 0))`` for a thing that is in one
    place. ``joint``: the fluents' confidences are weighed against each other
    (see ``Belief.weighed``), otherwise the likeliest stands.
    """

    arguments: tuple[tuple[str, int], ...]
    joint: bool = False

    @property
    def predicates(self) -> tuple[str, ...]:
        """Whose fluents exclude each other."""
        return tuple(predicate for predicate, _ in self.arguments)

    def group(self, fluent: Fluent) -> str | None:
        """What the fluent is in competition about; None if the rule is not about it."""
        for predicate, position in self.arguments:
            if predicate == fluent.predicate and position < len(fluent.args):
                return fluent.args[position]
        return None


@dataclass(frozen=True)
class Belief:
    """Confidences above 0, in the fluents' order; a fluent left out has confidence 0."""

    confidences: Mapping[Fluent, float] = field(default_factory=dict)
    exclusive: tuple[Exclusivity, ...] = ()

    @classmethod
    def of(
        cls, confidences: Mapping[Fluent, float], exclusive: tuple[Exclusivity, ...] = ()
    ) -> Belief:
        """Sort, check and keep. Raises ``ValueError`` for a confidence outside [0, 1]."""
        for fluent, confidence in confidences.items():
            if not 0.0 <= confidence <= 1.0:
                raise ValueError(f"{fluent}: a confidence is between 0 and 1, not {confidence}")
        kept = {f: float(confidences[f]) for f in sorted(confidences) if confidences[f] > 0.0}
        return cls(kept, exclusive)

    @classmethod
    def certain(cls, state: State, exclusive: tuple[Exclusivity, ...] = ()) -> Belief:
        """The belief of one who sees everything."""
        return _certain(state, exclusive)

    def __getitem__(self, fluent: Fluent) -> float:
        return self.confidences.get(fluent, 0.0)

    def items(self) -> Iterator[tuple[Fluent, float]]:
        """Fluents with confidence above 0, in their order."""
        return iter(self.confidences.items())

    def doubtful(self, floor: float) -> tuple[tuple[Fluent, float], ...]:
        """The fluents with confidence above ``floor`` and below one minus that, in their order."""
        if floor not in self._doubtful:
            rows = ((f, c) for f, c in self.items() if floor < c < 1.0 - floor)
            self._doubtful[floor] = tuple(rows)
        return self._doubtful[floor]

    @cached_property
    def _doubtful(self) -> dict[float, tuple[tuple[Fluent, float], ...]]:
        """By the floor: a belief is asked for them after every answer that leaves it as it is."""
        return {}

    def believed(self, threshold: float = BELIEVED) -> State:
        """The fluents strictly above ``threshold``; of exclusive ones only the likeliest."""
        return self._believed if threshold == BELIEVED else self._above(threshold)

    @cached_property
    def _believed(self) -> State:
        return self._above(BELIEVED)

    def _above(self, threshold: float) -> State:
        above = [f for f, confidence in self.items() if confidence > threshold]
        return frozenset(above) - self._beaten(above)

    def answered(self, fluent: Fluent, truth: bool, trust: float = 1.0) -> Belief:
        """The belief after a yes (the fluent at 1, its rivals at 0) or a no (at 0).

        Rivals that share one probability have the more of it after a no.
        An answer that is right only with the probability ``trust`` moves the
        fluent's confidence by Bayes' rule and leaves its rivals alone.
        """
        changed = dict(self.confidences)
        if trust < 1.0:
            changed[fluent] = posterior(self[fluent], trust if truth else 1.0 - trust)
            return Belief.of(changed, self.exclusive)
        if truth:
            changed.update(dict.fromkeys(self.rivals(fluent), 0.0))
        else:
            changed.update(self._relieved(fluent))
        changed[fluent] = float(truth)
        return Belief.of(changed, self.exclusive)

    def rivals(self, fluent: Fluent) -> tuple[Fluent, ...]:
        """The other fluents that cannot be true beside this one, in their order."""
        return tuple(
            other
            for other, _ in self.items()
            if other != fluent and any(_compete(rule, fluent, other) for rule in self.exclusive)
        )

    def weighed(self) -> Belief:
        """Each fluent's probability, given that of joint rivals at most one is true.

        Confidences are taken for independent evidence (Bayes' rule over which of
        them is true, or none). None grows, so nothing comes to be believed by this.
        """
        if not any(rule.joint for rule in self.exclusive):
            return self
        changed = dict(self.confidences)
        for rule in self.exclusive:
            for group in self._joint_groups(rule):
                changed.update(_shared({fluent: changed[fluent] for fluent in group}))
        return Belief.of(changed, self.exclusive)

    def _joint_groups(self, rule: Exclusivity) -> list[list[Fluent]]:
        """The fluents of each competition of two or more under a joint rule."""
        groups: dict[str, list[Fluent]] = {}
        for fluent, _ in self.items() if rule.joint else ():
            thing = rule.group(fluent)
            if thing is not None:
                groups.setdefault(thing, []).append(fluent)
        return [group for group in groups.values() if len(group) > 1]

    def _relieved(self, fluent: Fluent) -> dict[Fluent, float]:
        """What joint rivals come to when a fluent turns out false."""
        left = 1.0 - self[fluent]
        joint = tuple(rule for rule in self.exclusive if rule.joint)
        rivals = [o for o in self.rivals(fluent) if any(_compete(r, fluent, o) for r in joint)]
        return {rival: min(1.0, self[rival] / left) for rival in rivals} if left > 0.0 else {}

    def entropy_of(self, fluent: Fluent) -> float:
        """The uncertainty about one fluent, in bits: 1 at one half, 0 when settled."""
        return entropy(self[fluent])

    @property
    def entropy(self) -> float:
        """The uncertainty about all fluents, in bits, taking them for independent."""
        return math.fsum(entropy(confidence) for _, confidence in self.items())

    def to_json(self) -> dict[str, float]:
        """Fluents as text with their confidences; the exclusivities are the scene's, not kept."""
        return {str(fluent): confidence for fluent, confidence in self.items()}

    @classmethod
    def from_json(cls, data: Mapping[str, Any], exclusive: tuple[Exclusivity, ...] = ()) -> Belief:
        """Read what ``to_json`` wrote. Raises ``ValueError`` on other data."""
        return cls.of({Fluent.parse(text): float(c) for text, c in data.items()}, exclusive)

    def _beaten(self, fluents: Iterable[Fluent]) -> State:
        """Those of ``fluents`` that a likelier rival excludes; among equals the first stays."""
        ruled = {predicate for rule in self.exclusive for predicate in rule.predicates}
        rivals = [fluent for fluent in fluents if fluent.predicate in ruled]
        standing: dict[tuple[int, str], Fluent] = {}
        beaten = set()
        for fluent in sorted(rivals, key=lambda f: (-self[f], f)):
            groups = self._groups(fluent)
            if any(group in standing for group in groups):
                beaten.add(fluent)
            else:
                standing.update(dict.fromkeys(groups, fluent))
        return frozenset(beaten)

    def _groups(self, fluent: Fluent) -> list[tuple[int, str]]:
        named = ((index, rule.group(fluent)) for index, rule in enumerate(self.exclusive))
        return [(index, group) for index, group in named if group is not None]


@lru_cache(maxsize=256)
def _certain(state: State, exclusive: tuple[Exclusivity, ...]) -> Belief:
    """Beliefs are values: who sees truly thinks the same of the same state each time."""
    return Belief.of(dict.fromkeys(state, 1.0), exclusive)


def posterior(prior: float, said: float) -> float:
    """The probability of what was answered about; the answer is ``said`` likely if it is true.

    The answer is one minus that likely if it is false; an answer that cannot err settles.
    """
    yes, no = prior * said, (1.0 - prior) * (1.0 - said)
    if said in (0.0, 1.0) or yes + no == 0.0:
        return said if said in (0.0, 1.0) else prior
    return yes / (yes + no)


def entropy(probability: float) -> float:
    """The entropy of a yes or no with this probability, in bits."""
    rest = 1.0 - probability
    return -sum(p * math.log2(p) for p in (probability, rest) if p > 0.0)


def change_probability(before: Belief, after: Belief, fluent: Fluent) -> float:
    """The probability that a fluent differs between two states seen independently."""
    start, end = before[fluent], after[fluent]
    return end * (1.0 - start) + start * (1.0 - end)


def _shared(confidences: Mapping[Fluent, float]) -> dict[Fluent, float]:
    """The probability of each of several fluents of which at most one is true."""
    odds = {f: min(c, _SURE) / (1.0 - min(c, _SURE)) for f, c in confidences.items()}
    total = 1.0 + math.fsum(odds.values())
    return {f: min(confidences[f], o / total) for f, o in odds.items()}


def _compete(rule: Exclusivity, one: Fluent, other: Fluent) -> bool:
    group = rule.group(one)
    return group is not None and group == rule.group(other)
