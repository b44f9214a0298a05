"""Fluents, literals and states: the vocabulary in which worlds and goals are written.

A fluent is a predicate with its arguments, such as ``(on Mug_1 Counter_1)``.
A state is the closed-world set of the fluents that are true.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, TypeAlias


class FluentSyntaxError(ValueError):
    """A text that should name a fluent does not."""


class Fluent(NamedTuple):
    """A ground atom. Sorting fluents sorts by predicate, then by arguments."""

    predicate: str
    args: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"({' '.join((self.predicate, *self.args))})"

    @classmethod
    def parse(cls, text: str) -> Fluent:
        """Read ``(on Mug_1 Counter_1)``; the outer parentheses may be left out."""
        inner = text.strip()
        if inner.startswith("(") and inner.endswith(")"):
            inner = inner[1:-1]
        words = inner.split()
        if not words or any(c in inner for c in "()"):
            raise FluentSyntaxError(f"not a fluent: {text!r}; write (predicate object ...)")
        return cls(words[0], tuple(words[1:]))


class Literal(NamedTuple):
    """A fluent that should hold (``positive``) or should not."""

    fluent: Fluent
    positive: bool = True

    def __str__(self) -> str:
        return str(self.fluent) if self.positive else f"(not {self.fluent})"

    def holds(self, state: State) -> bool:
        """Whether the literal is true in ``state``."""
        return (self.fluent in state) == self.positive

    @classmethod
    def parse(cls, text: str) -> Literal:
        """Read ``(on a b)`` or ``(not (on a b))``."""
        inner = text.strip()
        if inner.startswith("(not ") and inner.endswith(")"):
            return cls(Fluent.parse(inner[len("(not ") : -1]), positive=False)
        return cls(Fluent.parse(inner))


State: TypeAlias = frozenset[Fluent]
Goal: TypeAlias = frozenset[Literal]


def satisfied(goal: Iterable[Literal], state: State) -> bool:
    """Whether every literal of ``goal`` holds in ``state``."""
    return all(literal.holds(state) for literal in goal)
