"""The hypothesis space of one demonstration: a value that is computed once and then only merged.

It is independent of every other demonstration. Its plain-JSON form is what
sessions keep, and it rebuilds without planning.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

from verbteach.verbs.lifting import Binding, Lifted
from verbteach.world.fluents import Literal


class FrameKey(NamedTuple):
    """A verb with the number of its grounded noun phrases."""

    verb: str
    arity: int

    def __str__(self) -> str:
        return f"{self.verb}/{self.arity}"

    @classmethod
    def parse(cls, text: str) -> FrameKey:
        """Read ``fill/2``."""
        verb, slash, arity = text.rpartition("/")
        if not slash or not arity.isdecimal():
            raise ValueError(f"not a verb frame: {text!r}; write verb/number")
        return cls(verb, int(arity))


class Demonstration(NamedTuple):
    """Whom a hypothesis comes from: an id, the command's noun phrases and their objects."""

    id: str
    verb: str
    phrases: tuple[str, ...]
    grounding: tuple[str, ...]

    @property
    def frame(self) -> FrameKey:
        """The frame that the demonstration teaches."""
        return FrameKey(self.verb, len(self.grounding))


class SpaceNode(NamedTuple):
    """A hypothesis and the things its abstract terms stood for, once for each ground goal."""

    literals: Lifted
    bindings: tuple[Binding, ...]


@dataclass(frozen=True)
class HypothesisSpace:
    """What one demonstration teaches.

    ``base`` is the ground base goal, sorted. ``nodes`` go from specific to
    general; the first one is the lifted base. ``edges`` lead from a node's
    index to that of a node with one fluent less. ``confirmed`` says that a
    teacher gave or corrected the goal.
    """

    demonstration: Demonstration
    base: tuple[Literal, ...]
    nodes: tuple[SpaceNode, ...]
    edges: tuple[tuple[int, int], ...] = ()
    confirmed: bool = False

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the space's canonical JSON."""
        text = json.dumps(self.to_json(), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()

    @cached_property
    def general(self) -> frozenset[int]:
        """Indices of the nodes that nothing more general follows."""
        return frozenset(range(len(self.nodes))) - {upper for upper, _ in self.edges}

    @property
    def order(self) -> tuple[Any, ...]:
        """What knowledge sorts spaces by: the demonstration, then everything else."""
        return (self.demonstration, self.base, self.nodes, self.edges, self.confirmed)

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {
            "demonstration": {
                "id": self.demonstration.id,
                "verb": self.demonstration.verb,
                "phrases": list(self.demonstration.phrases),
                "grounding": list(self.demonstration.grounding),
            },
            "base": [str(literal) for literal in self.base],
            "nodes": [
                {"literals": [str(x) for x in node.literals], "bindings": _lists(node.bindings)}
                for node in self.nodes
            ],
            "edges": _lists(self.edges),
            "confirmed": self.confirmed,
        }

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> HypothesisSpace:
        """Rebuild a space. Raises ``ValueError`` where the data is not one."""
        try:
            return cls(
                _demonstration(data["demonstration"]),
                _literals(data["base"]),
                tuple(
                    SpaceNode(_literals(n["literals"]), tuple(_words(b) for b in n["bindings"]))
                    for n in data["nodes"]
                ),
                tuple((int(upper), int(lower)) for upper, lower in data["edges"]),
                bool(data["confirmed"]),
            )
        except (AttributeError, KeyError, TypeError) as error:
            raise ValueError(f"not a hypothesis space: {error!r}") from error


def _lists(rows: Sequence[Sequence[Any]]) -> list[list[Any]]:
    return [list(row) for row in rows]


def _words(values: Sequence[Any]) -> tuple[str, ...]:
    return tuple(str(value) for value in values)


def _literals(texts: Sequence[str]) -> tuple[Literal, ...]:
    return tuple(_literal(text) for text in texts)


# Few literals occur in many spaces, and reading one takes longer than finding it again.
_literal = lru_cache(maxsize=8192)(Literal.parse)


def _demonstration(data: Mapping[str, Any]) -> Demonstration:
    phrases, grounding = _words(data["phrases"]), _words(data["grounding"])
    return Demonstration(str(data["id"]), str(data["verb"]), phrases, grounding)
