"""From action schemas to ground actions, symbolically: every way to bind the parameters.

Bindings are pruned on types, static predicates and equality only, never on
what happens to hold at the start, so the result serves every later state.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

from verbteach.world.domain import (
    EQUALITY,
    ROOT_TYPE,
    ActionSchema,
    Condition,
    Domain,
    Effect,
    Parameter,
)
from verbteach.world.fluents import Fluent, Literal
from verbteach.world.plan import Action

Binding: TypeAlias = dict[str, str]


class SymbolicEffect(NamedTuple):
    """``fluent`` becomes ``positive`` where every literal of ``condition`` held before."""

    fluent: Fluent
    positive: bool
    condition: tuple[Literal, ...]


class SymbolicAction(NamedTuple):
    """A ground action with what is left of its conditions once the static ones are decided."""

    action: Action
    precondition: tuple[Literal, ...]
    effects: tuple[SymbolicEffect, ...]


@dataclass(frozen=True)
class Grounder:
    """Grounds schemas for one domain, one set of objects (name to type) and one set of facts."""

    domain: Domain
    objects: Mapping[str, str]
    static: frozenset[Fluent]

    def ground(self, schema: ActionSchema) -> Iterator[SymbolicAction]:
        """Yield every grounding that static facts and equality allow, sorted by arguments."""
        fixed, dynamic = self._split(schema.precondition)
        effects = [self._effect(effect) for effect in schema.effects]
        for binding in self._join(schema.parameters, fixed).bindings({}):
            action = Action(schema.name, tuple([binding[p.name] for p in schema.parameters]))
            made = [
                SymbolicEffect(_fluent(effect, b), effect.positive, _literals(conditions, b))
                for effect, join, conditions in effects
                for b in join.bindings(binding)
            ]
            yield SymbolicAction(action, _literals(dynamic, binding), tuple(made))

    def holds(self, condition: Condition, binding: Mapping[str, str]) -> bool:
        """Whether a static condition or an equality is true."""
        if condition.predicate == EQUALITY:
            left, right = condition.args
            return (binding.get(left, left) == binding.get(right, right)) == condition.positive
        return (_fluent(condition, binding) in self.static) == condition.positive

    def _is_fixed(self, condition: Condition) -> bool:
        return condition.predicate == EQUALITY or condition.predicate in self.domain.static

    def _split(
        self, conditions: Sequence[Condition]
    ) -> tuple[tuple[Condition, ...], tuple[Condition, ...]]:
        """Part conditions that no action can change from those that some action may."""
        fixed = tuple(c for c in conditions if self._is_fixed(c))
        return fixed, tuple(c for c in conditions if not self._is_fixed(c))

    def _effect(self, effect: Effect) -> tuple[Effect, _Join, tuple[Condition, ...]]:
        fixed, dynamic = self._split(effect.condition)
        return effect, self._join(effect.parameters, fixed), dynamic

    def _join(self, parameters: Sequence[Parameter], fixed: Sequence[Condition]) -> _Join:
        names = [p.name for p in parameters]
        due = _due(names, fixed)
        options = []
        for place, parameter in enumerate(parameters, start=1):
            own = [c for c in due[place] if _others(c, parameter.name) == ()]
            tying = [c for c in due[place] if c not in own and self._ties(c, parameter.name)][:1]
            due[place] = [c for c in due[place] if c not in own + tying]
            options.append(self._options(parameter, own, tying))
        return _Join(self, names, options, due)

    def _options(
        self, parameter: Parameter, own: Sequence[Condition], tying: Sequence[Condition]
    ) -> _Options:
        """Objects of the parameter's type that meet the conditions, by what one is tied to."""
        name = parameter.name
        fitting = [
            thing
            for thing in self._instances[parameter.type]
            if all(self.holds(c, {name: thing}) for c in own)
        ]
        if not tying:
            return _Options((), {(): fitting})
        (tie,) = tying
        at, by_rest = tie.args.index(name), defaultdict(set)
        for fact in self.static:
            if fact.predicate == tie.predicate:
                by_rest[fact.args[:at] + fact.args[at + 1 :]].add(fact.args[at])
        chosen = {rest: [o for o in fitting if o in found] for rest, found in by_rest.items()}
        return _Options(tie.args[:at] + tie.args[at + 1 :], chosen)

    def _ties(self, condition: Condition, name: str) -> bool:
        """Whether it asks for a fact that names the variable just once."""
        asked = condition.positive and condition.predicate != EQUALITY
        return asked and condition.args.count(name) == 1

    @cached_property
    def _instances(self) -> Mapping[str, list[str]]:
        """Objects by type, those of subtypes included, sorted."""
        is_a, things = self.domain.is_a, sorted(self.objects.items())
        names = (ROOT_TYPE, *self.domain.types)
        return {name: [o for o, t in things if is_a(t, name)] for name in names}


class _Options(NamedTuple):
    """What a variable may stand for, by what the ``others`` that it is tied to stand for."""

    others: tuple[str, ...]
    things: Mapping[tuple[str, ...], list[str]]

    def given(self, binding: Binding) -> Sequence[str]:
        """The objects, sorted."""
        return self.things.get(tuple([binding.get(arg, arg) for arg in self.others]), ())


@dataclass(frozen=True)
class _Join:
    """All ways to bind some variables: depth first, each condition checked as soon as it can be."""

    grounder: Grounder
    names: list[str]
    options: list[_Options]
    due: list[list[Condition]]

    def bindings(self, outer: Binding) -> Iterator[Binding]:
        """Yield ``outer`` with the variables bound; the dictionary is the same one each time."""
        return self._bind(0, dict(outer) if self.names else outer)

    def _bind(self, depth: int, binding: Binding) -> Iterator[Binding]:
        for condition in self.due[depth]:
            if not self.grounder.holds(condition, binding):
                return
        if depth == len(self.names):
            yield binding
            return
        name = self.names[depth]
        for candidate in self.options[depth].given(binding):
            binding[name] = candidate
            yield from self._bind(depth + 1, binding)


def _due(names: Sequence[str], fixed: Iterable[Condition]) -> list[list[Condition]]:
    """Sort conditions by how many of the variables must be bound before they can be checked."""
    depth = {name: i + 1 for i, name in enumerate(names)}
    due: list[list[Condition]] = [[] for _ in range(len(names) + 1)]
    for condition in fixed:
        due[max((depth.get(arg, 0) for arg in condition.args), default=0)].append(condition)
    return due


def _others(condition: Condition, name: str) -> tuple[str, ...]:
    """The variables besides this one that the condition is about."""
    return tuple(arg for arg in condition.args if arg != name and arg.startswith("?"))


def _fluent(atom: Condition | Effect, binding: Mapping[str, str]) -> Fluent:
    return Fluent(atom.predicate, tuple([binding.get(arg, arg) for arg in atom.args]))


def _literals(conditions: Sequence[Condition], binding: Mapping[str, str]) -> tuple[Literal, ...]:
    if not conditions:
        return ()
    return tuple([Literal(_fluent(c, binding), c.positive) for c in conditions])
