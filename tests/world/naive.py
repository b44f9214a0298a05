"""The domain's meaning told a second time, slowly and without grounding: the tests' oracle."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from itertools import product

from verbteach.world.domain import Condition, Domain, Effect, Parameter
from verbteach.world.fluents import Fluent, Goal, State, satisfied
from verbteach.world.plan import Action

Objects = Mapping[str, str]


def bindings(
    domain: Domain, objects: Objects, parameters: Iterable[Parameter]
) -> Iterator[dict[str, str]]:
    """Every way to bind the parameters to objects of their types."""
    listed = list(parameters)
    fitting = [[o for o in sorted(objects) if domain.is_a(objects[o], p.type)] for p in listed]
    for values in product(*fitting):
        yield {p.name: value for p, value in zip(listed, values, strict=True)}


def holds(condition: Condition, binding: Mapping[str, str], state: State) -> bool:
    """Whether one condition is true in the state."""
    args = tuple(binding.get(arg, arg) for arg in condition.args)
    true = args[0] == args[1] if condition.predicate == "=" else Fluent(condition[0], args) in state
    return true == condition.positive


def applicable(domain: Domain, objects: Objects, state: State) -> set[Action]:
    """Every action that can be done."""
    return {
        Action(schema.name, tuple(binding[p.name] for p in schema.parameters))
        for schema in domain.actions.values()
        for binding in bindings(domain, objects, schema.parameters)
        if all(holds(c, binding, state) for c in schema.precondition)
    }


def apply(domain: Domain, objects: Objects, state: State, action: Action) -> State:
    """The state afterwards."""
    schema = domain.actions[action.name]
    outer = {p.name: arg for p, arg in zip(schema.parameters, action.args, strict=True)}
    added: set[Fluent] = set()
    deleted: set[Fluent] = set()
    for effect in schema.effects:
        for fluent in _changed(domain, objects, state, effect, outer):
            (added if effect.positive else deleted).add(fluent)
    return frozenset((state - deleted) | added)


def _changed(
    domain: Domain, objects: Objects, state: State, effect: Effect, outer: Mapping[str, str]
) -> Iterator[Fluent]:
    for inner in bindings(domain, objects, effect.parameters):
        binding = {**outer, **inner}
        if all(holds(c, binding, state) for c in effect.condition):
            yield Fluent(effect.predicate, tuple(binding.get(a, a) for a in effect.args))


def shortest(
    domain: Domain, objects: Objects, state: State, goal: Goal, limit: int = 100_000
) -> list[Action] | None:
    """A shortest plan, breadth first; none where the goal cannot be reached."""
    parents: dict[State, tuple[State, Action] | None] = {state: None}
    waiting = deque([state])
    while waiting:
        here = waiting.popleft()
        if satisfied(goal, here):
            return _path(parents, here)
        for action in sorted(applicable(domain, objects, here)):
            there = apply(domain, objects, here, action)
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
