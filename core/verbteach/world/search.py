"""Lazy greedy best-first search with preferred operators, over encoded states.

A state is judged when it is reached, not when it is generated. There are two
queues: children along preferred operators, and all children. Both are sorted
by the parent's distance and then by the order in which parents were judged;
children of one parent come in the order of the actions. Each queue's turn
comes by how often it was served, and progress earns the preferred one a start.
Nothing here depends on time or on hash order.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import TypeAlias

from verbteach.world.relaxed import Proposition, RelaxedTask
from verbteach.world.task import Task


@dataclass(frozen=True)
class SearchLimits:
    """``expansions`` bounds the states judged; ``boost`` is what progress earns (in turns)."""

    expansions: int = 2000
    boost: int = 20


@dataclass(frozen=True)
class Exhausted:
    """No plan: every state that could be reached was judged, or the bound was hit."""

    bound: bool


Steps: TypeAlias = tuple[int, ...]


def search(
    task: Task,
    relaxed: RelaxedTask,
    bits: int,
    goal: Sequence[Proposition],
    limits: SearchLimits,
) -> Steps | Exhausted:
    """Return action numbers that lead from ``bits`` to the goal, or why there are none."""
    first = relaxed.estimate(bits, goal)
    if first is None:
        return Exhausted(bound=False)
    frontier = _Frontier(task, limits.boost)
    frontier.judged(bits, -1, -1, first.distance, first.preferred)
    if first.distance == 0:
        return ()
    for _ in range(limits.expansions):
        child = frontier.next_child()
        if child is None:
            return Exhausted(bound=False)
        parent, action, reached = child
        found = relaxed.estimate(reached, goal)
        if found is None:
            frontier.seen.add(reached)
            continue
        state = frontier.judged(reached, parent, action, found.distance, found.preferred)
        if found.distance == 0:
            return frontier.path(state)
    return Exhausted(bound=True)


class _Frontier:
    """The states judged so far and the two queues of children still to judge."""

    def __init__(self, task: Task, boost: int) -> None:
        self.task = task
        self.boost = boost
        self.seen: set[int] = set()
        self.states: list[int] = []
        self.parents: list[int] = []
        self.actions: list[int] = []
        self.children: dict[int, list[int]] = {}
        self.preferred: list[tuple[int, int, int]] = []
        self.all: list[tuple[int, int]] = []
        self.best: int | None = None
        self.served_preferred = 0
        self.served_all = 0

    def judged(
        self, bits: int, parent: int, action: int, distance: int, preferred: Sequence[int]
    ) -> int:
        """Enter a state with its distance; return its number."""
        number = len(self.states)
        self.seen.add(bits)
        self.states.append(bits)
        self.parents.append(parent)
        self.actions.append(action)
        for wanted in preferred:
            heappush(self.preferred, (distance, number, wanted))
        heappush(self.all, (distance, number))
        if self.best is None or distance < self.best:
            self.best = distance
            self.served_preferred -= self.boost
        return number

    def next_child(self) -> tuple[int, int, int] | None:
        """Return parent, action and encoded state of the next state not yet seen."""
        while self.preferred or self.all:
            if self.preferred and (not self.all or self.served_preferred <= self.served_all):
                child = self._pop_preferred()
            else:
                child = self._pop_any()
            if child is not None:
                return child
        return None

    def path(self, state: int) -> Steps:
        """Return the actions that led to a state."""
        steps: list[int] = []
        while self.parents[state] >= 0:
            steps.append(self.actions[state])
            state = self.parents[state]
        return tuple(reversed(steps))

    def _pop_preferred(self) -> tuple[int, int, int] | None:
        _, parent, action = heappop(self.preferred)
        bits = self.task.actions[action].result(self.states[parent])
        if bits in self.seen:
            return None
        self.served_preferred += 1
        return parent, action, bits

    def _pop_any(self) -> tuple[int, int, int] | None:
        """Take the next unseen child of the first state in the queue of all; it keeps its place."""
        _, parent = self.all[0]
        here = self.states[parent]
        if parent not in self.children:
            ready = [a.index for a in self.task.actions if a.applicable(here)]
            self.children[parent] = ready[::-1]
        waiting = self.children[parent]
        while waiting:
            action = waiting.pop()
            bits = self.task.actions[action].result(here)
            if bits not in self.seen:
                self.served_all += 1
                return parent, action, bits
        del self.children[parent]
        heappop(self.all)
        return None
