"""What a demonstration changed, as far as can be told: seen unsurely, but done with known actions.

The robot knows what its actions do. So a fluent that no demonstrated action
touches did not change, whatever was seen; what an action needed was true
before it; and what the last action about a fluent surely brings about is true
at the end. Only the rest hangs on the eyes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

from verbteach.perception.belief import Belief, posterior
from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action
from verbteach.world.task import GroundAction, Task


@dataclass(frozen=True)
class SeenChange:
    """Each literal that may have come true by the demonstration, with its probability above 0."""

    chances: tuple[tuple[Literal, float], ...]

    @cached_property
    def table(self) -> dict[Literal, float]:
        """The probabilities by literal."""
        return dict(self.chances)

    @property
    def likely(self) -> Goal:
        """What probably changed: strictly above one half."""
        return frozenset(literal for literal, chance in self.chances if chance > 0.5)

    @property
    def certainty(self) -> float:
        """The probability that just ``likely`` changed, literals taken for independent."""
        product = 1.0
        for _, chance in self.chances:
            product *= max(chance, 1.0 - chance)
        return product

    def answered(self, literal: Literal, truth: bool, trust: float = 1.0) -> SeenChange:
        """The belief after a yes (1) or a no (0), by Bayes where it is right with ``trust``."""
        said = trust if truth else 1.0 - trust
        return SeenChange(
            tuple((one, posterior(p, said) if one == literal else p) for one, p in self.chances)
        )


def seen_change(
    task: Task, before: Belief, after: Belief, actions: Sequence[Action], model: float = 0.5
) -> SeenChange:
    """Weigh what was seen with what the actions do.

    Where an action's effect hangs on what is believed, it counts ``model``
    against what was seen afterwards.
    """
    done = [ground for action in actions if (ground := task.action(action)) is not None]
    traced = _Trace(task.encode(before.believed()))
    for ground in done:
        traced.follow(ground)
    found = []
    for fluent in task.named(traced.touched & ~_never_true(task, traced, before, after)):
        bit = task.bit[fluent]
        start = _known(bit, traced.needed, traced.excluded, before[fluent])
        seen = model * bool(traced.bits & bit) + (1.0 - model) * after[fluent]
        end = _known(bit, traced.made, traced.unmade, seen)
        found += _chances(fluent, start, end)
    return SeenChange(tuple(sorted(found)))


def observed_change(before: Belief, after: Belief, fluents: Iterable[Fluent]) -> SeenChange:
    """The change by the eyes alone, both looks taken for independent (METHOD, features)."""
    found: list[tuple[Literal, float]] = []
    for fluent in sorted(fluents):
        found += _chances(fluent, before[fluent], after[fluent])
    return SeenChange(tuple(sorted(found)))


def _chances(fluent: Fluent, start: float, end: float) -> list[tuple[Literal, float]]:
    pairs = ((Literal(fluent), end * (1.0 - start)), (Literal(fluent, False), start * (1.0 - end)))
    return [(literal, chance) for literal, chance in pairs if chance > 0.0]


def _never_true(task: Task, traced: _Trace, before: Belief, after: Belief) -> int:
    """The bits of what was neither true before nor is after, by far the most of what may change."""
    seen_before, seen_after = (task.encode(frozenset(b.confidences)) for b in (before, after))
    not_before = ~traced.needed & (traced.excluded | ~seen_before)
    return not_before & ~traced.made & (traced.unmade | ~(traced.bits | seen_after))


def _known(bit: int, yes: int, no: int, otherwise: float) -> float:
    return 1.0 if bit & yes else 0.0 if bit & no else otherwise


class _Trace:
    """Follows actions from a believed state, taking it for granted that each could be done.

    ``needed`` and ``excluded`` are what must have been true and false at the
    start; ``made`` and ``unmade`` what surely is at the end; ``touched`` what
    may have changed on the way.
    """

    def __init__(self, bits: int) -> None:
        self.bits = bits
        self.needed = self.excluded = self.made = self.unmade = self.touched = 0

    def follow(self, ground: GroundAction) -> None:
        fresh = ~(self.touched | self.needed | self.excluded)
        self.needed |= ground.needs_true & fresh
        self.excluded |= ground.needs_false & fresh
        bits = (self.bits | ground.needs_true) & ~ground.needs_false
        maybe = 0
        for when in ground.conditional:
            maybe |= when.add | when.delete
        sure_add, sure_delete = ground.add & ~maybe, ground.delete & ~ground.add & ~maybe
        self.made = (self.made | sure_add) & ~sure_delete & ~maybe
        self.unmade = (self.unmade | sure_delete) & ~sure_add & ~maybe
        self.touched |= ground.add | ground.delete | maybe
        self.bits = ground.result(bits)
