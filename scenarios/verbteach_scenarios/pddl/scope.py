"""The names that are known at a point of a file, and whether a word fits them.

Every misfit becomes one error of the file's own kind with path and line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from verbteach.world.domain import EQUALITY, ROOT_TYPE, Parameter, Predicate
from verbteach_scenarios.errors import WorldFileError
from verbteach_scenarios.pddl.grammar import UNSUPPORTED

if TYPE_CHECKING:
    from lark import Token, Tree


@dataclass(frozen=True)
class Scope:
    """Types (child to parent), predicates, and the terms in sight with their types.

    Terms are constants, objects, and variables with their question mark.
    """

    path: Path
    error: type[WorldFileError]
    types: Mapping[str, str] = field(default_factory=dict)
    predicates: Mapping[str, Predicate] = field(default_factory=dict)
    terms: Mapping[str, str] = field(default_factory=dict)

    def fail(self, where: Token | Tree[Token], reason: str) -> NoReturn:
        """Raise the file's error at the line of ``where``."""
        raise self.error(self.path, line_of(where), reason)

    def refuse(self, where: Token | Tree[Token], construct: str) -> NoReturn:
        """Raise the file's error for a construct outside the supported fragment."""
        self.fail(where, f"{UNSUPPORTED.get(construct, construct)} is not supported")

    def typed_list(self, listed: Tree[Token]) -> list[tuple[Token, str]]:
        """Read ``a b - t c``: each word with its type, ``object`` where none is written."""
        read: list[tuple[Token, str]] = []
        untyped: list[Token] = []
        typing = False
        for child in listed.children:
            word = self._type_word(child) if typing else child
            if typing:
                read += [(name, str(word)) for name in untyped]
                untyped, typing = [], False
            elif word == "-":
                typing = True
            else:
                untyped.append(word_of(word))
        return read + [(name, ROOT_TYPE) for name in untyped]

    def declared(self, listed: Tree[Token], kind: str, mark: str = "") -> dict[str, str]:
        """Read a typed list of new names, each of a known type, none declared before."""
        found: dict[str, str] = {}
        for word, type_name in self.typed_list(listed):
            name = mark + word
            if name in found or name in self.terms:
                self.fail(word, f"{kind} {name} is declared twice")
            self.check_type(word, type_name)
            found[name] = type_name
        return found

    def parameters(self, listed: Tree[Token]) -> tuple[Parameter, ...]:
        """Read a list of typed variables."""
        found = self.declared(listed, "variable", mark="?")
        return tuple(Parameter(name, type_name) for name, type_name in found.items())

    def with_parameters(self, parameters: Sequence[Parameter]) -> Scope:
        """Return the scope in which ``parameters`` are in sight as well."""
        return replace(self, terms={**self.terms, **dict(parameters)})

    def check_type(self, where: Token | Tree[Token], type_name: str) -> None:
        """Raise unless the type is declared."""
        if type_name != ROOT_TYPE and type_name not in self.types:
            self.fail(where, f"type {type_name} is not declared")

    def atom(self, tree: Tree[Token]) -> tuple[str, tuple[str, ...]]:
        """Read an atom; predicate, number of arguments and their types must fit."""
        _, predicate, *terms, _ = tree.children
        ground = tree.data == "atomic_formula_name"
        args = tuple(_term(child, ground) for child in terms)
        for child, arg in zip(terms, args, strict=True):
            if arg not in self.terms:
                self.fail(child, f"{_kind(arg)} {arg} is not declared")
        if predicate != EQUALITY:
            self._check_atom(word_of(predicate), args)
        return str(predicate), args

    def _check_atom(self, where: Token, args: tuple[str, ...]) -> None:
        predicate = str(where)
        if predicate not in self.predicates:
            self.fail(where, f"predicate {predicate} is not declared")
        wanted = self.predicates[predicate].parameters
        if len(args) != len(wanted):
            self.fail(where, f"{predicate} takes {_count(len(wanted))}, not {len(args)}")
        for arg, parameter in zip(args, wanted, strict=True):
            if not self.is_a(self.terms[arg], parameter.type):
                self.fail(
                    where,
                    f"{predicate} takes a {parameter.type} for {parameter.name}, "
                    f"but {arg} is a {self.terms[arg]}",
                )

    def is_a(self, type_name: str, ancestor: str) -> bool:
        """Whether ``type_name`` is ``ancestor`` or a subtype of it."""
        while type_name not in (ancestor, ROOT_TYPE):
            type_name = self.types[type_name]
        return type_name == ancestor

    def _type_word(self, child: Token | Tree[Token]) -> Token:
        if not isinstance(child, str) and len(child.children) > 1:
            self.refuse(child, "either")
        return word_of(child)


def line_of(where: Token | Tree[Token]) -> int:
    """Return the line on which a word or a subtree begins."""
    return (where.line if isinstance(where, str) else where.meta.line) or 0


def word_of(child: Token | Tree[Token]) -> Token:
    """Return the one word of a leaf."""
    while not isinstance(child, str):
        child = child.children[0]
    return child


def subtrees(tree: Tree[Token], rule: str) -> list[Tree[Token]]:
    """Return the direct children that the grammar's ``rule`` made, in order."""
    return [c for c in tree.children if c is not None and not isinstance(c, str) and c.data == rule]


def _term(child: Token | Tree[Token], ground: bool) -> str:
    """Spell a term; the grammar wraps constants and drops the question marks of variables."""
    return str(child) if ground else f"?{child}" if isinstance(child, str) else str(word_of(child))


def _kind(arg: str) -> str:
    return "variable" if arg.startswith("?") else "object"


def _count(number: int) -> str:
    return "1 argument" if number == 1 else f"{number} arguments"
