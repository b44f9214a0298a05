"""Verb frames: what the robot reads in a command."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class NounPhrase:
    """A noun phrase as it was said.

    ``head`` is the singular noun in lower case; ``modifiers`` are the words
    before it, determiners excluded ("red", "coffee"); ``relations`` are
    prepositional phrases attached to it, as (preposition, noun phrase).
    """

    text: str
    head: str
    modifiers: tuple[str, ...] = ()
    determiner: str = ""
    plural: bool = False
    relations: tuple[tuple[str, NounPhrase], ...] = ()

    @property
    def is_pronoun(self) -> bool:
        """Whether the phrase points back at something said before."""
        return self.head in PRONOUNS


PRONOUNS = frozenset({"it", "them", "this", "that", "these", "those", "one"})


@dataclass(frozen=True)
class Argument:
    """A noun phrase with its role: ``obj``, the preposition before it, or ``loc``."""

    role: str
    phrase: NounPhrase


@dataclass(frozen=True)
class VerbFrame:
    """A verb, its particle joined by a space ("turn on"), and its arguments in order said."""

    verb: str
    arguments: tuple[Argument, ...] = ()

    @property
    def phrases(self) -> tuple[NounPhrase, ...]:
        """The arguments' noun phrases, in order."""
        return tuple(argument.phrase for argument in self.arguments)
