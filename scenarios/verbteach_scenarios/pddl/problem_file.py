"""A PDDL problem file read into objects, a start and a goal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from verbteach.world.domain import EQUALITY, Domain
from verbteach.world.fluents import Fluent, Goal, Literal, State
from verbteach_scenarios.errors import SceneFileError
from verbteach_scenarios.pddl.conditions import read_condition
from verbteach_scenarios.pddl.domain_file import check_requirements
from verbteach_scenarios.pddl.grammar import parse_tree, read_text
from verbteach_scenarios.pddl.scope import Scope, subtrees, word_of

if TYPE_CHECKING:
    from lark import Token, Tree


@dataclass(frozen=True)
class Problem:
    """A problem: its objects (name to type, the domain's constants among them), start and goal."""

    name: str
    objects: Mapping[str, str]
    initial: State
    goal: Goal


def read_problem(path: Path, domain: Domain) -> Problem:
    """Read a problem file; raise ``SceneFileError`` with path, line and reason."""
    return parse_problem(read_text(path, SceneFileError), domain, path)


def parse_problem(text: str, domain: Domain, path: Path = Path("problem.pddl")) -> Problem:
    """Read a problem from its text; ``path`` is what errors name."""
    tree = parse_tree(text, "problem", path, SceneFileError)
    scope = Scope(path, SceneFileError, domain.types, domain.predicates, domain.constants)
    check_requirements(tree, scope)
    named = word_of(subtrees(tree, "problem_domain")[0].children[2])
    if named != domain.name:
        scope.fail(named, f"it is about the domain {named}, but is read with {domain.name}")
    scope = replace(scope, terms={**domain.constants, **_objects(tree, scope)})
    for metric in subtrees(tree, "metric_spec"):
        scope.refuse(metric, ":metric")
    name = word_of(subtrees(tree, "problem_def")[0].children[2])
    return Problem(str(name), scope.terms, _initial(tree, scope), _goal(tree, scope))


def _objects(tree: Tree[Token], scope: Scope) -> dict[str, str]:
    found: dict[str, str] = {}
    for section in subtrees(tree, "objects"):
        found |= scope.declared(subtrees(section, "typed_list_name")[0], "object")
    return found


def _initial(tree: Tree[Token], scope: Scope) -> State:
    """Read the facts that hold; a fact said not to hold needs no word, but may have one."""
    said: dict[Fluent, bool] = {}
    for element in subtrees(subtrees(tree, "init")[0], "init_el"):
        literals = subtrees(element, "literal_name")
        if not literals:
            scope.refuse(element, "a number as a starting fact (=)")
        atom = subtrees(literals[0], "atomic_formula_name")[0]
        fluent = Fluent(*scope.atom(atom))
        positive = len(literals[0].children) == 1
        if said.setdefault(fluent, positive) != positive:
            scope.fail(atom, f"{fluent} is said both to hold and not to hold")
    return frozenset(fluent for fluent, positive in said.items() if positive)


def _goal(tree: Tree[Token], scope: Scope) -> Goal:
    literals: list[Literal] = []
    for part in subtrees(subtrees(tree, "goal")[0], "gd"):
        for condition in read_condition(part, scope):
            if condition.predicate == EQUALITY:
                scope.refuse(part, "equality (=) in a goal")
            fluent = Fluent(condition.predicate, condition.args)
            literals.append(Literal(fluent, condition.positive))
    return frozenset(literals)
