"""The domain's meaning told a second time, slowly and in full: the tests' oracle.

Nothing is left out because it can never hold or never changes: every binding is
spelled out, and every condition is looked up in the state.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from itertools import product
from typing import NamedTuple

from verbteach.world.domain import ActionSchema, Condition, Domain, Parameter
from verbteach.world.fluents import Fluent, Goal, State, satisfied
from verbteach.world.plan import Action

Objects = Mapping[str, str]


class Change(NamedTuple):
    """A fluent that becomes true, or false, where all of ``when`` has the truth it says."""

    when: tuple[tuple[Fluent, bool], ...]
    fluent: Fluent
    positive: bool


def bindings(
    domain: Domain, objects: Objects, parameters: Iterable[Parameter]
) -> Iterator[dict[str, str]]:
    """Every way to bind the parameters to objects of their types."""
    listed = list(parameters)
    fitting = [[o for o in sorted(objects) if domain.is_a(objects[o], p.type)] for p in listed]
    for values in product(*fitting):
        yield {p.name: value for p, value in zip(listed, values, strict=True)}


def holds(when: Iterable[tuple[Fluent, bool]], state: State) -> bool:
    """Whether each fluent is as true in the state as is said of it."""
    return all((fluent in state) == positive for fluent, positive in when)


def possible(domain: Domain, objects: Objects) -> dict[Action, tuple[tuple[Fluent, bool], ...]]:
    """Every action with its preconditions, but those that ask for equality that there is not."""
    return {
        Action(schema.name, tuple(binding[p.name] for p in schema.parameters)): needs
        for schema in domain.actions.values()
        for binding in bindings(domain, objects, schema.parameters)
        if (needs := _spelled(schema.precondition, binding)) is not None
    }


def applicable(domain: Domain, objects: Objects, state: State) -> set[Action]:
    """Every action that can be done."""
    return {action for action, needs in possible(domain, objects).items() if holds(needs, state)}


def changes(domain: Domain, objects: Objects, action: Action) -> list[Change]:
    """Everything that the action may change."""
    schema = domain.actions[action.name]
    outer = {p.name: arg for p, arg in zip(schema.parameters, action.args, strict=True)}
    return list(_changes(domain, objects, schema, outer))


def apply(domain: Domain, objects: Objects, state: State, action: Action) -> State:
    """The state afterwards."""
    return _after(changes(domain, objects, action), state)


def _changes(
    domain: Domain, objects: Objects, schema: ActionSchema, outer: Mapping[str, str]
) -> Iterator[Change]:
    for effect in schema.effects:
        for inner in bindings(domain, objects, effect.parameters):
            binding = {**outer, **inner}
            when = _spelled(effect.condition, binding)
            if when is not None:
                args = tuple(binding.get(a, a) for a in effect.args)
                yield Change(when, Fluent(effect.predicate, args), effect.positive)


def _spelled(
    conditions: Iterable[Condition], binding: Mapping[str, str]
) -> tuple[tuple[Fluent, bool], ...] | None:
    """The conditions on a state; none where one on equality does not hold."""
    spelled = []
    for condition in conditions:
        args = tuple(binding.get(arg, arg) for arg in condition.args)
        if condition.predicate != "=":
            spelled.append((Fluent(condition.predicate, args), condition.positive))
        elif (args[0] == args[1]) != condition.positive:
            return None
    return tuple(spelled)


def _after(changes: Iterable[Change], state: State) -> State:
    added: set[Fluent] = set()
    deleted: set[Fluent] = set()
    for change in changes:
        if holds(change.when, state):
            (added if change.positive else deleted).add(change.fluent)
    return frozenset((state - deleted) | added)


def shortest(
    domain: Domain, objects: Objects, state: State, goal: Goal, limit: int = 100_000
) -> list[Action] | None:
    """A shortest plan, breadth first; none where the goal cannot be reached."""
    ways = sorted(possible(domain, objects).items())
    changes_of = cache(lambda action: changes(domain, objects, action))
    parents: dict[State, tuple[State, Action] | None] = {state: None}
    waiting = deque([state])
    while waiting:
        here = waiting.popleft()
        if satisfied(goal, here):
            return _path(parents, here)
        for action in (action for action, needs in ways if holds(needs, here)):
            there = _after(changes_of(action), here)
            if there not in parents:
                parents[there] = (here, action)
                waiting.append(there)
        if len(parents) > limit:
            raise RuntimeError("the problem is too large for the oracle")
    return None


def _path(parents: Mapping[State, tuple[State, Action] | None], end: State) -> list[Action]:
    path: list[Action] = []
    step = parents[end]
    while step is not None:
        path.append(step[1])
        step = parents[step[0]]
    return path[::-1]
