"""A PDDL domain file read into a ``Domain``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from verbteach.world.domain import (
    ROOT_TYPE,
    ActionSchema,
    Condition,
    Domain,
    Effect,
    Predicate,
)
from verbteach_scenarios.errors import DomainFileError
from verbteach_scenarios.pddl.conditions import read_condition, read_effect
from verbteach_scenarios.pddl.grammar import parse_tree, read_text, tokens
from verbteach_scenarios.pddl.scope import Scope, subtrees, word_of

if TYPE_CHECKING:
    from lark import Token, Tree

SUPPORTED_REQUIREMENTS = frozenset(
    {
        ":strips",
        ":typing",
        ":equality",
        ":negative-preconditions",
        ":conditional-effects",
        ":universal-preconditions",  # where PDDL files announce a forall in an effect
        ":quantified-preconditions",
        ":adl",
    }
)


def read_domain(path: Path) -> Domain:
    """Read a domain file; raise ``DomainFileError`` with path, line and reason."""
    return parse_domain(read_text(path, DomainFileError), path)


def parse_domain(text: str, path: Path = Path("domain.pddl")) -> Domain:
    """Read a domain from its text; ``path`` is what errors name."""
    tree = parse_tree(text, "domain", path, DomainFileError)
    scope = Scope(path, DomainFileError)
    check_requirements(tree, scope)
    scope = replace(scope, types=_types(tree, scope))
    scope = replace(scope, terms=_constants(tree, scope))
    scope = replace(scope, predicates=_predicates(tree, scope))
    name = word_of(subtrees(tree, "domain_def")[0].children[2])
    return Domain(str(name), scope.types, scope.terms, scope.predicates, _actions(tree, scope))


def check_requirements(tree: Tree[Token], scope: Scope) -> None:
    """Raise where the file announces something that is not read."""
    for section in subtrees(tree, "requirements"):
        for word in list(tokens(section))[2:-1]:
            if word not in SUPPORTED_REQUIREMENTS:
                scope.refuse(word, f"the requirement {word}")


def _types(tree: Tree[Token], scope: Scope) -> dict[str, str]:
    found: dict[str, str] = {}
    for section in subtrees(tree, "types"):
        listed = scope.typed_list(subtrees(section, "typed_list_name")[0])
        parents = {str(word) for word, _ in listed} | {ROOT_TYPE}
        for word, parent in listed:
            if word in found:
                scope.fail(word, f"type {word} is declared twice")
            if parent not in parents:
                scope.fail(word, f"type {parent} is not declared")
            if word != ROOT_TYPE:
                found[str(word)] = parent
        for word, _ in listed:
            _check_ends(word, found, scope)
    return found


def _check_ends(word: Token, types: dict[str, str], scope: Scope) -> None:
    """Raise where a type is its own ancestor."""
    seen = {str(word)}
    parent = types.get(word, ROOT_TYPE)
    while parent != ROOT_TYPE:
        if parent in seen:
            scope.fail(word, f"type {word} is its own ancestor")
        seen.add(parent)
        parent = types[parent]


def _constants(tree: Tree[Token], scope: Scope) -> dict[str, str]:
    found: dict[str, str] = {}
    for section in subtrees(tree, "constants"):
        found |= scope.declared(subtrees(section, "typed_list_name")[0], "constant")
    return found


def _predicates(tree: Tree[Token], scope: Scope) -> dict[str, Predicate]:
    found: dict[str, Predicate] = {}
    for section in subtrees(tree, "predicates"):
        for skeleton in subtrees(section, "atomic_formula_skeleton"):
            name = word_of(skeleton.children[1])
            if name in found:
                scope.fail(name, f"predicate {name} is declared twice")
            parameters = scope.parameters(subtrees(skeleton, "typed_list_variable")[0])
            found[str(name)] = Predicate(str(name), parameters)
    for section in subtrees(tree, "functions"):
        scope.refuse(section, ":functions")
    return found


def _actions(tree: Tree[Token], scope: Scope) -> dict[str, ActionSchema]:
    for derived in subtrees(tree, "derived_predicates"):
        scope.refuse(derived, ":derived")
    found: dict[str, ActionSchema] = {}
    for definition in subtrees(tree, "action_def"):
        name = word_of(definition.children[2])
        if name in found:
            scope.fail(name, f"action {name} is declared twice")
        found[str(name)] = _action(str(name), definition, scope)
    return found


def _action(name: str, definition: Tree[Token], scope: Scope) -> ActionSchema:
    listed = subtrees(definition, "action_parameters")[0]
    parameters = scope.parameters(subtrees(listed, "typed_list_variable")[0])
    inner = scope.with_parameters(parameters)
    precondition: tuple[Condition, ...] = ()
    effects: tuple[Effect, ...] = ()
    for part in definition.find_pred(lambda t: t.data in ("emptyor_pregd", "emptyor_effect")):
        if part.data == "emptyor_pregd":
            read = (c for g in subtrees(part, "gd") for c in read_condition(g, inner))
            precondition = tuple(dict.fromkeys(read))
        else:
            made = (e for f in subtrees(part, "effect") for e in read_effect(f, inner))
            effects = tuple(dict.fromkeys(made))
    return ActionSchema(name, parameters, precondition, effects)
