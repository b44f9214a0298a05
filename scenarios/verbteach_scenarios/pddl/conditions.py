"""Conjunctions of literals and effects, read from their syntax trees.

Refused here: disjunction, implication, quantifiers in conditions, numbers,
and whatever else would make a condition more than a conjunction of literals.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

from verbteach.world.domain import EQUALITY, Condition, Effect, Parameter
from verbteach_scenarios.pddl.grammar import UNSUPPORTED
from verbteach_scenarios.pddl.scope import Scope, subtrees

if TYPE_CHECKING:
    from lark import Token, Tree


def read_condition(tree: Tree[Token], scope: Scope) -> tuple[Condition, ...]:
    """Read a ``gd``: an atom, its negation, or a conjunction of conditions."""
    operator = _operator(tree)
    if operator == "":
        return (Condition(*scope.atom(_only(tree))),)
    if operator == "and":
        return tuple(c for part in subtrees(tree, "gd") for c in read_condition(part, scope))
    if operator == "not":
        return (_negation(subtrees(tree, "gd")[0], scope),)
    return _refuse(tree, operator, scope)


def _refuse(tree: Tree[Token], operator: str, scope: Scope) -> NoReturn:
    if operator == "forall":
        scope.refuse(tree, "universal quantification (forall) in a condition")
    if operator in UNSUPPORTED:
        scope.refuse(tree, operator)
    scope.refuse(tree, f"a numeric condition ({operator})")


def _negation(inner: Tree[Token], scope: Scope) -> Condition:
    operator = _operator(inner)
    if operator:
        scope.refuse(inner, f"a negation of ({operator} ...)")
    return Condition(*scope.atom(_only(inner)), positive=False)


def read_effect(
    tree: Tree[Token], scope: Scope, quantified: tuple[Parameter, ...] = ()
) -> tuple[Effect, ...]:
    """Read an ``effect``: literals, each maybe under ``forall`` and one ``when``."""
    parts = [*subtrees(tree, "effect"), *subtrees(tree, "c_effect")]
    if tree.data == "effect":
        return tuple(e for part in parts for e in read_effect(part, scope, quantified))
    operator = _operator(tree)
    if operator == "oneof":
        scope.refuse(tree, operator)
    if operator == "forall":
        new = scope.parameters(subtrees(tree, "typed_list_variable")[0])
        return read_effect(parts[0], scope.with_parameters(new), quantified + new)
    if operator == "when":
        condition = read_condition(subtrees(tree, "gd")[0], scope)
        literals = subtrees(subtrees(tree, "cond_effect")[0], "p_effect")
        return tuple(_literal(p, scope, condition, quantified) for p in literals)
    return (_literal(subtrees(tree, "p_effect")[0], scope, (), quantified),)


def _literal(
    tree: Tree[Token],
    scope: Scope,
    condition: tuple[Condition, ...],
    quantified: tuple[Parameter, ...],
) -> Effect:
    atoms = subtrees(tree, "atomic_formula_term")
    if not atoms:
        scope.refuse(tree, "a numeric effect")
    predicate, args = scope.atom(atoms[0])
    if predicate == EQUALITY:
        scope.fail(tree, "an effect cannot change equality (=)")
    return Effect(predicate, args, _operator(tree) != "not", condition, quantified)


def _operator(tree: Tree[Token]) -> str:
    """Return the word after the opening parenthesis, or nothing where ``tree`` wraps an atom."""
    if len(tree.children) < 2:
        return ""
    operator = tree.children[1]
    return str(operator if isinstance(operator, str) else operator.children[0])


def _only(tree: Tree[Token]) -> Tree[Token]:
    child = tree.children[0]
    assert not isinstance(child, str), "the grammar puts an atom here"
    return child
