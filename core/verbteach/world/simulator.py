"""What actions do to a state, and what stands in the way of one that cannot be done.

Reasons are data: how they read is the language room's business. Fluents that
the task does not know stay in the state as they are.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

from verbteach.world.domain import EQUALITY, ActionSchema
from verbteach.world.fluents import Fluent, Literal, State
from verbteach.world.plan import Action
from verbteach.world.task import Task


@dataclass(frozen=True)
class UnknownAction:
    """The domain has no action of that name."""

    name: str


@dataclass(frozen=True)
class WrongNumber:
    """The action takes ``expected`` objects and was given ``given``."""

    name: str
    expected: int
    given: int


@dataclass(frozen=True)
class UnknownObject:
    """There is no such object."""

    name: str


@dataclass(frozen=True)
class WrongType:
    """The action wants an ``expected`` in this place; the object is an ``actual``."""

    name: str
    expected: str
    actual: str


@dataclass(frozen=True)
class Unequal:
    """The action wants both to be the same object (``positive``), or different ones."""

    left: str
    right: str
    positive: bool


@dataclass(frozen=True)
class Unmet:
    """A condition that does not hold; ``static`` where no action could ever change that."""

    literal: Literal
    static: bool = False


Obstacle: TypeAlias = UnknownAction | WrongNumber | UnknownObject | WrongType | Unequal | Unmet


class InapplicableError(ValueError):
    """An action cannot be done in this state; ``obstacles`` say why."""

    def __init__(self, action: Action, obstacles: tuple[Obstacle, ...]) -> None:
        self.action = action
        self.obstacles = obstacles
        super().__init__(f"{action} cannot be done: {', '.join(map(str, obstacles))}")


def applicable(task: Task, state: State) -> list[Action]:
    """Return the actions that can be done, in the task's order."""
    bits = task.encode(state)
    return [ground.action for ground in task.actions if ground.applicable(bits)]


def apply(task: Task, state: State, action: Action) -> State:
    """Return the state after ``action``; raise ``InapplicableError`` if it cannot be done."""
    ground = task.action(action)
    bits = task.encode(state)
    if ground is None or not ground.applicable(bits):
        raise InapplicableError(action, explain(task, state, action))
    return _changed(task, state, bits, ground.changes(bits))


def run(task: Task, state: State, actions: Iterable[Action]) -> list[State]:
    """Return ``state`` and the state after each action, up to the first that cannot be done."""
    return list(_run(task, state, tuple(actions)))


@lru_cache(maxsize=64)
def _run(task: Task, state: State, actions: tuple[Action, ...]) -> tuple[State, ...]:
    """The robot carries a plan out and whoever judges it looks at the same states again."""
    states = [state]
    bits = task.encode(state)
    for action in actions:
        ground = task.action(action)
        if ground is None or not ground.applicable(bits):
            break
        add, delete = ground.changes(bits)
        states.append(_changed(task, states[-1], bits, (add, delete)))
        bits = (bits & ~delete) | add
    return tuple(states)


def _changed(task: Task, state: State, bits: int, changes: tuple[int, int]) -> State:
    """Carry bits that were set and cleared over to the state as a set."""
    add, delete = changes
    return state.difference(task.named(delete & bits)).union(task.named(add & ~bits))


def explain(task: Task, state: State, action: Action) -> tuple[Obstacle, ...]:
    """Return what stands in the way of ``action``: nothing where it can be done.

    Misfits of the words (name, number, objects, types) come alone; else every
    unmet condition is listed, in the schema's order.
    """
    schema = task.domain.actions.get(action.name)
    if schema is None:
        return (UnknownAction(action.name),)
    if len(action.args) != len(schema.parameters):
        return (WrongNumber(action.name, len(schema.parameters), len(action.args)),)
    misfits = _misfits(task, schema, action)
    return misfits if misfits else _unmet(task, schema, state, action)


def _misfits(task: Task, schema: ActionSchema, action: Action) -> tuple[Obstacle, ...]:
    found: list[Obstacle] = []
    for arg, parameter in zip(action.args, schema.parameters, strict=True):
        actual = task.objects.get(arg)
        if actual is None:
            found.append(UnknownObject(arg))
        elif not task.domain.is_a(actual, parameter.type):
            found.append(WrongType(arg, parameter.type, actual))
    return tuple(found)


def _unmet(task: Task, schema: ActionSchema, state: State, action: Action) -> tuple[Obstacle, ...]:
    binding = {p.name: arg for p, arg in zip(schema.parameters, action.args, strict=True)}
    found: list[Obstacle] = []
    for condition in schema.precondition:
        args = tuple(binding.get(arg, arg) for arg in condition.args)
        if condition.predicate == EQUALITY:
            if (args[0] == args[1]) != condition.positive:
                found.append(Unequal(args[0], args[1], condition.positive))
            continue
        literal = Literal(Fluent(condition.predicate, args), condition.positive)
        static = condition.predicate in task.domain.static
        if not literal.holds(task.static if static else state):
            found.append(Unmet(literal, static))
    return tuple(found)
