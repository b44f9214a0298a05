"""A planning domain as plain values: types, predicates and action schemas.

This is the fragment of PDDL that the project supports: typing, negative
preconditions, equality, conditional effects and universal quantification in
effects. Preconditions and effect conditions are conjunctions of conditions.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

EQUALITY = "="
ROOT_TYPE = "object"


class Parameter(NamedTuple):
    """A typed variable; its name starts with a question mark."""

    name: str
    type: str = ROOT_TYPE


class Condition(NamedTuple):
    """A possibly negated atom over variables and constants; ``=`` is equality."""

    predicate: str
    args: tuple[str, ...]
    positive: bool = True


class Effect(NamedTuple):
    """``forall parameters: when condition: atom becomes positive (or negative)``."""

    predicate: str
    args: tuple[str, ...]
    positive: bool = True
    condition: tuple[Condition, ...] = ()
    parameters: tuple[Parameter, ...] = ()


class Predicate(NamedTuple):
    """A predicate's name and its typed parameters."""

    name: str
    parameters: tuple[Parameter, ...]


class ActionSchema(NamedTuple):
    """A primitive action, not yet grounded. Deletes happen before adds."""

    name: str
    parameters: tuple[Parameter, ...]
    precondition: tuple[Condition, ...]
    effects: tuple[Effect, ...]


@dataclass(frozen=True)
class Domain:
    """Types (child to parent), constants (name to type), predicates and actions by name."""

    name: str
    types: Mapping[str, str]
    constants: Mapping[str, str]
    predicates: Mapping[str, Predicate]
    actions: Mapping[str, ActionSchema]
    static: frozenset[str] = field(init=False)

    def __post_init__(self) -> None:
        changed = {e.predicate for a in self.actions.values() for e in a.effects}
        object.__setattr__(self, "static", frozenset(self.predicates) - changed)

    def is_a(self, type_name: str, ancestor: str) -> bool:
        """Whether ``type_name`` is ``ancestor`` or one of its subtypes."""
        while type_name != ancestor:
            if type_name == ROOT_TYPE or type_name not in self.types:
                return False
            type_name = self.types[type_name]
        return True
