"""How far a goal seems: the relaxed task, in which nothing true ever becomes false again.

The heuristic is h_FF (Hoffmann and Nebel 2001) with the best supporters of
h_add, and its preferred operators. A fluent and its negation are two
propositions, and an action's conditional effects are operators of their own.
Ties go to the lowest operator number, so the estimate is a function of state
and goal alone, in whatever order it is computed.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from heapq import heappop, heappush
from typing import NamedTuple, TypeAlias

from verbteach.world.fluents import Literal
from verbteach.world.task import Task

Proposition: TypeAlias = int
Operator: TypeAlias = int

_FLIP = str.maketrans("01", "10")


class Estimate(NamedTuple):
    """Number of actions in the relaxed plan, and those of them that can be done now, sorted."""

    distance: int
    preferred: Sequence[int]


class _Relevant(NamedTuple):
    """The operators that may help with what is wanted, and what joins them.

    ``users`` are the operators that wait for a proposition, ``unmet`` counts
    what an operator waits for, ``feeds`` are the propositions it is wanted for.
    """

    users: dict[Proposition, list[Operator]]
    unmet: dict[Operator, int]
    feeds: dict[Operator, list[Proposition]]
    ready: list[Operator]


class RelaxedTask:
    """A task's delete relaxation. Proposition ``i`` is fluent ``i``, ``i + n`` its negation.

    Operators are numbered by action, unconditional effects first: operator
    ``o`` belongs to action ``actor[o]``, needs ``needs[o]``, makes true ``makes[o]``.
    """

    def __init__(self, task: Task) -> None:
        self.size = len(task.fluents)
        self.actor: list[int] = []
        self.needs: list[tuple[Proposition, ...]] = []
        self.makes: list[tuple[Proposition, ...]] = []
        for action in task.actions:
            true, false = action.needs_true, action.needs_false
            self._operator(action.index, (true, false), (action.add, action.delete))
            for when in action.conditional:
                needs = (true | when.needs_true, false | when.needs_false)
                self._operator(action.index, needs, (when.add, when.delete))
        self.achievers: list[list[Operator]] = [[] for _ in range(2 * self.size)]
        for operator, made in enumerate(self.makes):
            for proposition in made:
                self.achievers[proposition].append(operator)
        self._number = {fluent: i for i, fluent in enumerate(task.fluents)}
        self._pattern = f"0{self.size}b"

    def propositions(self, literals: Iterable[Literal]) -> tuple[Proposition, ...]:
        """Number literals over the task's fluents, ascending."""
        found = (self._number[x.fluent] + (0 if x.positive else self.size) for x in literals)
        return tuple(sorted(found))

    def estimate(self, bits: int, goal: Sequence[Proposition]) -> Estimate | None:
        """Return the distance to the goal; none where even the relaxed task never reaches it."""
        truth = self._truth(bits)
        wanted = [proposition for proposition in goal if truth[proposition] == "0"]
        if not wanted:
            return Estimate(0, ())
        best = _supporters(wanted, self._relevant(wanted, truth))
        return None if best is None else self._relaxed_plan(wanted, best, truth)

    def _operator(self, action: int, needs: tuple[int, int], made: tuple[int, int]) -> None:
        if made != (0, 0):
            self.actor.append(action)
            self.needs.append(self._numbers(*needs))
            self.makes.append(self._numbers(*made))

    def _numbers(self, true: int, false: int) -> tuple[Proposition, ...]:
        return (*_set_bits(true), *(self.size + i for i in _set_bits(false)))

    def _truth(self, bits: int) -> str:
        """Spell the state as a text of 0 and 1, one character a proposition."""
        text = format(bits, self._pattern)[::-1] if self.size else ""
        return text + text.translate(_FLIP)

    def _relevant(self, wanted: Sequence[Proposition], truth: str) -> _Relevant:
        """Gather backwards what may make the wanted true; what is true already needs nothing."""
        achievers, needs = self.achievers, self.needs
        users: dict[Proposition, list[Operator]] = {proposition: [] for proposition in wanted}
        found = _Relevant(users, {}, {}, [])
        _, unmet, feeds, ready = found
        stack = list(wanted)
        while stack:
            proposition = stack.pop()
            for operator in achievers[proposition]:
                if operator in feeds:
                    feeds[operator].append(proposition)
                    continue
                feeds[operator] = [proposition]
                missing = [need for need in needs[operator] if truth[need] == "0"]
                unmet[operator] = len(missing)
                if not missing:
                    ready.append(operator)
                for need in missing:
                    if need not in users:
                        users[need] = []
                        stack.append(need)
                    users[need].append(operator)
        return found

    def _relaxed_plan(
        self, wanted: Sequence[Proposition], best: Mapping[Proposition, Operator], truth: str
    ) -> Estimate:
        """Follow the best supporters back from the goal."""
        marked: set[Operator] = set()
        preferred: set[int] = set()
        stack = list(wanted)
        while stack:
            operator = best[stack.pop()]
            if operator in marked:
                continue
            marked.add(operator)
            missing = [need for need in self.needs[operator] if truth[need] == "0"]
            stack += missing
            if not missing:
                preferred.add(self.actor[operator])
        return Estimate(len({self.actor[operator] for operator in marked}), sorted(preferred))


def _supporters(
    wanted: Sequence[Proposition], relevant: _Relevant
) -> dict[Proposition, Operator] | None:
    """Return the cheapest operator for each proposition up to the wanted ones (h_add).

    An operator costs one more than all it waits for, so propositions are
    settled in the order of their costs; the lowest number wins a tie.
    """
    users, unmet, feeds, ready = relevant
    cost: dict[Proposition, int] = {}
    best: dict[Proposition, Operator] = {}
    spent = dict.fromkeys(unmet, 1)
    waiting: list[tuple[int, Proposition]] = []

    def offer(operator: Operator) -> None:
        price = spent[operator]
        for proposition in feeds[operator]:
            old = cost.get(proposition)
            if old is None or price < old:
                cost[proposition], best[proposition] = price, operator
                heappush(waiting, (price, proposition))
            elif price == old and operator < best[proposition]:
                best[proposition] = operator

    for operator in ready:
        offer(operator)
    left = set(wanted)
    while waiting and left:
        price, proposition = heappop(waiting)
        if price > cost[proposition]:
            continue
        left.discard(proposition)
        for operator in users[proposition]:
            spent[operator] += price
            unmet[operator] -= 1
            if not unmet[operator]:
                offer(operator)
    return None if left else best


def _set_bits(bits: int) -> list[int]:
    found = []
    while bits:
        low = bits & -bits
        found.append(low.bit_length() - 1)
        bits ^= low
    return found
