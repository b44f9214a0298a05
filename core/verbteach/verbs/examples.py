"""Demonstrations as examples to reason from by analogy, and a memory of many of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.lifting import Binding, Lifted
from verbteach.verbs.resemblance import Said
from verbteach.verbs.space import Demonstration


@dataclass(frozen=True, eq=False)
class Pattern:
    """What of an example decides how it is bound elsewhere; alike only to itself: see ``_one``."""

    change: Lifted
    binding: Binding
    phrases: tuple[str, ...]
    grounding: tuple[str, ...]


@lru_cache(maxsize=1 << 16)
def _one(
    change: Lifted, binding: Binding, phrases: tuple[str, ...], grounding: tuple[str, ...]
) -> Pattern:
    """The same pattern for the same things: tables by pattern find it without comparing."""
    return Pattern(change, binding, phrases, grounding)


@dataclass(frozen=True)
class Example:
    """A demonstration's whole change, lifted: the top of its hypothesis space."""

    demonstration: Demonstration
    change: Lifted
    binding: Binding

    @cached_property
    def said(self) -> Said:
        """The command that was demonstrated."""
        return Said(self.demonstration.verb, self.demonstration.phrases)

    @cached_property
    def pattern(self) -> Pattern:
        """How it is bound."""
        shown = self.demonstration
        return _one(self.change, self.binding, shown.phrases, shown.grounding)


@dataclass(frozen=True)
class Memory:
    """Examples in a fixed order: it breaks ties."""

    examples: tuple[Example, ...] = ()

    @classmethod
    def of(cls, knowledge: VerbKnowledge) -> Memory:
        """Every demonstration of every verb, by frame and then in the frame's order."""
        spaces = (space for space in knowledge.spaces if space.nodes)
        return cls.keeping(
            Example(s.demonstration, s.nodes[0].literals, s.nodes[0].bindings[0]) for s in spaces
        )

    @classmethod
    def keeping(cls, examples: Iterable[Example]) -> Memory:
        """Keep examples by id, whatever order they come in."""
        return cls(tuple(sorted(examples, key=lambda e: (e.demonstration, e.change, e.binding))))

    @cached_property
    def patterns(self) -> tuple[Pattern, ...]:
        """How each example is bound."""
        return tuple(example.pattern for example in self.examples)

    @cached_property
    def commands(self) -> tuple[Said, ...]:
        """The distinct commands."""
        return tuple(dict.fromkeys(example.said for example in self.examples))

    @cached_property
    def numbers(self) -> NDArray[np.int64]:
        """The distinct commands' numbers: see ``Said.number``."""
        return np.array([said.number for said in self.commands], dtype=np.int64)

    @cached_property
    def command_of(self) -> NDArray[np.int64]:
        """Each example's command, as an index."""
        number = {said: index for index, said in enumerate(self.commands)}
        return np.array([number[e.said] for e in self.examples], dtype=np.int64)
