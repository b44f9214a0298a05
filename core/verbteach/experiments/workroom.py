"""A room to work in: what can be done there, planned there and seen there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TypeAlias

from verbteach.verbs.change import StateChange
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action, Planner
from verbteach.world.task import Task


@dataclass(frozen=True)
class Workroom:
    """A grounded task with its planner, and what the learner knows of the things in it."""

    task: Task
    planner: Planner
    surroundings: Surroundings

    @classmethod
    def of(cls, task: Task, planner: Planner) -> Workroom:
        """Furnish the room of a task."""
        return cls(task, planner, Surroundings.of_task(task))

    def outcome(self, state: State, actions: Sequence[Action]) -> State:
        """Where the actions lead, up to the first that cannot be done."""
        return self._with(state, self._after(self.task.encode(state), actions))

    def changed(self, state: State, actions: Sequence[Action]) -> StateChange:
        """What carrying the actions out changes, up to the first that cannot be done."""
        return self._changed(self.task.encode(state), tuple(actions))

    @cached_property
    def _changed(self) -> Callable[[int, tuple[Action, ...]], StateChange]:
        """Changes are remembered for a while: plans are weighed anew after each answer."""
        return lru_cache(maxsize=512)(self._change)

    def _change(self, bits: int, actions: tuple[Action, ...]) -> StateChange:
        after, named = self._after(bits, actions), self.task.named
        return StateChange(frozenset(named(after & ~bits)), frozenset(named(bits & ~after)))

    def _after(self, bits: int, actions: Sequence[Action]) -> int:
        for action in actions:
            ground = self.task.action(action)
            if ground is None or not ground.applicable(bits):
                break
            bits = ground.result(bits)
        return bits

    def reenact(self, state: State, actions: Sequence[Action]) -> tuple[State, State]:
        """Carry demonstrated actions out in the mind: the start, mended, and the end.

        Each action was done, so what it needs did hold: a needed fluent that
        ``state`` denies, and that no action before touched, is put right in
        the start. Actions that the task does not know are left out.
        """
        task, bits = self.task, self.task.encode(state)
        start, touched = bits, 0
        for action in actions:
            ground = task.action(action)
            if ground is None:
                continue
            missing, wrong = ground.needs_true & ~bits, ground.needs_false & bits
            start = (start | missing & ~touched) & ~(wrong & ~touched)
            bits = (bits | missing) & ~wrong
            after = ground.result(bits)
            touched |= missing | wrong | (bits ^ after)
            bits = after
        return self._with(state, start), self._with(state, bits)

    def _with(self, state: State, bits: int) -> State:
        """The state with the task's fluents as ``bits`` has them."""
        was = self.task.encode(state)
        gone, come = self.task.named(was & ~bits), self.task.named(bits & ~was)
        return state.difference(gone).union(come)

    def one_step_away(self, state: State) -> frozenset[Fluent]:
        """What some action that can be done in ``state`` would make true."""
        bits, reached = self.task.encode(state), 0
        for ground in self.task.actions:
            if ground.applicable(bits):
                reached |= ground.changes(bits)[0]
        return frozenset(self.task.named(reached & ~bits))


Workrooms: TypeAlias = Mapping[str, Workroom]
"""Workrooms by ``Instance.task_key``."""

PlannerMaker: TypeAlias = Callable[[Task], Planner]


def furnish(tasks: Mapping[str, Task], planner: PlannerMaker) -> dict[str, Workroom]:
    """Make a workroom of each task, by key."""
    return {key: Workroom.of(tasks[key], planner(tasks[key])) for key in sorted(tasks)}


_FURNISHED: dict[tuple[str, PlannerMaker], Workroom] = {}


def furnished(key: str, task: Task, planner: PlannerMaker) -> Workroom:
    """The workroom of a task, made once in a process though the task travels there often."""
    kept = _FURNISHED.get((key, planner))
    if kept is None or not _same(kept.task, task):
        kept = _FURNISHED[key, planner] = Workroom.of(task, planner(task))
    return kept


def _same(one: Task, other: Task) -> bool:
    """Whether two tasks are copies of each other."""
    if one is other:
        return True
    alike = one.objects == other.objects and one.static == other.static
    return alike and one.domain == other.domain
