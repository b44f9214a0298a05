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

import numpy as np
import numpy.typing as npt

from verbteach.world.fluents import Literal
from verbteach.world.task import Task

Proposition: TypeAlias = int
Operator: TypeAlias = int


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
        self._need_rows = self._padded_needs()

    def propositions(self, literals: Iterable[Literal]) -> tuple[Proposition, ...]:
        """Number literals over the task's fluents, ascending."""
        found = (self._number[x.fluent] + (0 if x.positive else self.size) for x in literals)
        return tuple(sorted(found))

    def estimate(self, bits: int, goal: Sequence[Proposition]) -> Estimate | None:
        """Return the distance to the goal; none where even the relaxed task never reaches it."""
        false, unmet = self._lacking(bits)
        wanted = [proposition for proposition in goal if false[proposition]]
        if not wanted:
            return Estimate(0, ())
        best = _supporters(wanted, self._relevant(wanted, false, unmet))
        return None if best is None else self._relaxed_plan(wanted, best, false)

    def _operator(self, action: int, needs: tuple[int, int], made: tuple[int, int]) -> None:
        if made != (0, 0):
            self.actor.append(action)
            self.needs.append(self._numbers(*needs))
            self.makes.append(self._numbers(*made))

    def _numbers(self, true: int, false: int) -> tuple[Proposition, ...]:
        return (*set_bits(true), *(self.size + i for i in set_bits(false)))

    def _padded_needs(self) -> npt.NDArray[np.intp]:
        """One column an operator, its needs filled up with a proposition that is always true."""
        height = max(map(len, self.needs), default=0)
        rows = np.full((max(height, 1), len(self.needs)), 2 * self.size, dtype=np.intp)
        for operator, needs in enumerate(self.needs):
            rows[: len(needs), operator] = needs
        return rows

    def _lacking(self, bits: int) -> tuple[bytes, bytes]:
        """Return what is false (1) by proposition, and how many needs are unmet by operator."""
        size = self.size
        raw = np.frombuffer(bits.to_bytes(size // 8 + 1, "little"), dtype=np.uint8)
        true = np.unpackbits(raw, count=size, bitorder="little")
        false = np.zeros(2 * size + 1, dtype=np.uint8)
        np.subtract(1, true, out=false[:size])
        false[size : 2 * size] = true
        unmet = np.add.reduce(false.take(self._need_rows), axis=0, dtype=np.uint8)
        return false.tobytes(), unmet.tobytes()

    def _relevant(self, wanted: Sequence[Proposition], false: bytes, unmet: bytes) -> _Relevant:
        """Gather backwards what may make the wanted true; what is true already needs nothing."""
        needs = self.needs
        users: dict[Proposition, list[Operator]] = {proposition: [] for proposition in wanted}
        found = _Relevant(users, {}, {}, [])
        _, waiting, feeds, ready = found
        easy: dict[Proposition, bool] = {}
        stack = list(wanted)
        while stack:
            proposition = stack.pop()
            for operator in self._promising(proposition, false, unmet, easy):
                if operator in feeds:
                    feeds[operator].append(proposition)
                    continue
                feeds[operator] = [proposition]
                waiting[operator] = unmet[operator]
                if not unmet[operator]:
                    ready.append(operator)
                    continue
                for need in needs[operator]:
                    if false[need]:
                        if need not in users:
                            users[need] = []
                            stack.append(need)
                        users[need].append(operator)
        return found

    def _promising(
        self, proposition: Proposition, false: bytes, unmet: bytes, easy: dict[Proposition, bool]
    ) -> Sequence[Operator]:
        """Return the achievers without those that cannot be the cheapest.

        An operator that can be done now beats all others. One whose lacks can
        each be made true at once costs one more than their number, and so
        beats all that lack more.
        """
        achievers = self.achievers[proposition]
        if len(achievers) < 2:
            return achievers
        counts = [unmet[operator] for operator in achievers]
        for number in sorted(set(counts)):
            fewest = [o for o, count in zip(achievers, counts, strict=True) if count == number]
            if number == 0:
                return fewest[:1]
            if any(self._is_easy_operator(o, false, unmet, easy) for o in fewest):
                return [o for o, count in zip(achievers, counts, strict=True) if count <= number]
        return achievers

    def _is_easy_operator(
        self, operator: Operator, false: bytes, unmet: bytes, easy: dict[Proposition, bool]
    ) -> bool:
        """Whether everything the operator lacks can be made true at once."""
        for need in self.needs[operator]:
            if false[need]:
                if need not in easy:
                    easy[need] = any(not unmet[o] for o in self.achievers[need])
                if not easy[need]:
                    return False
        return True

    def _relaxed_plan(
        self, wanted: Sequence[Proposition], best: Mapping[Proposition, Operator], false: bytes
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
            missing = [need for need in self.needs[operator] if false[need]]
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


def set_bits(bits: int) -> list[int]:
    """Return the positions of the bits that are set, ascending."""
    found = []
    while bits:
        low = bits & -bits
        found.append(low.bit_length() - 1)
        bits ^= low
    return found
