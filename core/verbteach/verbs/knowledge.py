"""What the robot knows of its verbs: the merge of its demonstrations' hypothesis spaces.

Values never change: learning returns new knowledge that shares what it can
with the old. Knowledge is a multiset of spaces, kept in a fixed order, so the
order of learning leaves no trace in it.
"""

from __future__ import annotations

import hashlib
from bisect import insort
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

from verbteach.verbs.lifting import Binding, Lifted, Mould, mould_of
from verbteach.verbs.space import Demonstration, FrameKey, HypothesisSpace


class Use(NamedTuple):
    """One demonstration of a hypothesis with the things its abstract terms stood for.

    ``base``: it was the demonstration's whole goal; ``leaf``: nothing more
    general was kept of it; ``confirmed``: its teacher confirmed that goal.
    """

    demonstration: Demonstration
    binding: Binding
    base: bool
    leaf: bool
    confirmed: bool


Bindings: TypeAlias = tuple[tuple[Binding, tuple[Use, ...]], ...]
"""Things that stood for a hypothesis' abstract terms, with who had them stand so."""


@dataclass(frozen=True)
class HypothesisNode:
    """A hypothesis merged over demonstrations.

    ``frequency`` counts the demonstrations it comes from; one that holds it
    twice, of different things, has several ``uses``. ``general`` lists the
    hypotheses with one fluent less that it is linked to.
    """

    literals: Lifted
    uses: tuple[Use, ...] = ()
    frequency: int = 0
    general: frozenset[Lifted] = frozenset()

    @property
    def base(self) -> int:
        """How many demonstrations had it as their whole goal."""
        return _demonstrations(use for use in self.uses if use.base)

    @property
    def leaf(self) -> int:
        """Of how many demonstrations nothing more general was kept."""
        return _demonstrations(use for use in self.uses if use.leaf)

    @property
    def confirmed(self) -> int:
        """How many teachers confirmed it as the goal."""
        return _demonstrations(use for use in self.uses if use.confirmed)

    @cached_property
    def mould(self) -> Mould:
        """The hypothesis, prepared for being bound."""
        return mould_of(self.literals)

    @cached_property
    def bindings(self) -> Bindings:
        """Each binding once, sorted, with its uses."""
        return _by_binding(self.uses)

    @cached_property
    def least(self) -> Bindings:
        """The bindings by demonstrations that kept nothing more general."""
        return _by_binding(use for use in self.uses if use.leaf)


def _by_binding(uses: Iterable[Use]) -> Bindings:
    found: dict[Binding, list[Use]] = defaultdict(list)
    for use in uses:
        found[use.binding].append(use)
    return tuple((binding, tuple(found[binding])) for binding in sorted(found))


@dataclass(frozen=True)
class FrameSpace:
    """The merged space of one verb frame; ``spaces`` are sorted by ``HypothesisSpace.order``."""

    key: FrameKey
    spaces: tuple[HypothesisSpace, ...]

    @cached_property
    def nodes(self) -> Mapping[Lifted, HypothesisNode]:
        """Every hypothesis, specific to general, then in the hypotheses' own order."""
        return _in_order(_merge({}, self.spaces))

    @cached_property
    def specific(self) -> Mapping[Lifted, frozenset[Lifted]]:
        """For each hypothesis those with one fluent more that are linked to it."""
        above: dict[Lifted, set[Lifted]] = {key: set() for key in self.nodes}
        for key, node in self.nodes.items():
            for lower in node.general:
                above[lower].add(key)
        return {key: frozenset(found) for key, found in above.items()}

    @cached_property
    def highest(self) -> int:
        """The highest frequency of a hypothesis; 0 without any."""
        return max((node.frequency for node in self.nodes.values()), default=0)

    def with_space(self, space: HypothesisSpace) -> FrameSpace:
        """The frame with one demonstration more; nodes it does not touch are shared."""
        spaces = list(self.spaces)
        insort(spaces, space, key=lambda s: s.order)
        larger = FrameSpace(self.key, tuple(spaces))
        if "nodes" in self.__dict__:
            touched = _merge(self.nodes, [space])
            larger.__dict__["nodes"] = _in_order({**self.nodes, **touched})
        return larger

    def without(self, space: HypothesisSpace) -> FrameSpace:
        """The frame without one occurrence of ``space``."""
        spaces = list(self.spaces)
        spaces.remove(space)
        return FrameSpace(self.key, tuple(spaces))


def _demonstrations(uses: Iterable[Use]) -> int:
    return len({use.demonstration for use in uses})


def _merge(
    known: Mapping[Lifted, HypothesisNode], spaces: Iterable[HypothesisSpace]
) -> dict[Lifted, HypothesisNode]:
    """The nodes that the spaces touch, as they are with them."""
    found: dict[Lifted, _Growing] = {}
    for space in spaces:
        lower: dict[int, list[Lifted]] = defaultdict(list)
        for upper, one in space.edges:
            lower[upper].append(space.nodes[one].literals)
        for index, (literals, bindings) in enumerate(space.nodes):
            if literals not in found:
                found[literals] = _Growing(known.get(literals) or HypothesisNode(literals))
            first = index == 0
            kind = (first, index in space.general, first and space.confirmed)
            uses = [Use(space.demonstration, binding, *kind) for binding in bindings]
            found[literals].add(uses, lower[index])
    return {literals: growing.node for literals, growing in found.items()}


class _Growing:
    """A node that demonstrations are being added to."""

    def __init__(self, node: HypothesisNode) -> None:
        self._literals = node.literals
        self._uses = list(node.uses)
        self._frequency = node.frequency
        self._general = set(node.general)

    def add(self, uses: Iterable[Use], general: Iterable[Lifted]) -> None:
        """Add one demonstration's uses, and what it links the node to."""
        self._uses += uses
        self._frequency += 1
        self._general.update(general)

    @property
    def node(self) -> HypothesisNode:
        """The node as it is now."""
        uses, general = tuple(sorted(self._uses)), frozenset(self._general)
        return HypothesisNode(self._literals, uses, self._frequency, general)


def _in_order(nodes: Mapping[Lifted, HypothesisNode]) -> dict[Lifted, HypothesisNode]:
    return {key: nodes[key] for key in sorted(nodes, key=lambda k: (-len(k), k))}


@dataclass(frozen=True)
class VerbKnowledge:
    """The frames the robot has learned, by key; empty to begin with."""

    frames: Mapping[FrameKey, FrameSpace] = field(default_factory=dict)

    @classmethod
    def merged(cls, spaces: Iterable[HypothesisSpace]) -> VerbKnowledge:
        """Knowledge of these spaces, in whatever order they come."""
        found: dict[FrameKey, list[HypothesisSpace]] = defaultdict(list)
        for space in spaces:
            found[space.demonstration.frame].append(space)
        return cls(
            {key: FrameSpace(key, tuple(sorted(found[key], key=lambda s: s.order)))
             for key in sorted(found)}
        )  # fmt: skip

    @property
    def spaces(self) -> tuple[HypothesisSpace, ...]:
        """Every demonstration's space, by frame and then in the frame's order."""
        return tuple(space for key in sorted(self.frames) for space in self.frames[key].spaces)

    @cached_property
    def verbs(self) -> tuple[str, ...]:
        """The verbs with at least one hypothesis, sorted."""
        return tuple(sorted({key.verb for key in self.frames}))

    def taught(self, verb: str) -> int:
        """How many demonstrations of the verb there are, over all its frames."""
        return sum(len(f.spaces) for key, f in self.frames.items() if key.verb == verb)

    def with_space(self, space: HypothesisSpace) -> VerbKnowledge:
        """Knowledge with one demonstration more; other frames are shared."""
        key = space.demonstration.frame
        frame = self.frames.get(key) or FrameSpace(key, ())
        return VerbKnowledge({**self.frames, key: frame.with_space(space)})

    def without(self, space: HypothesisSpace) -> VerbKnowledge:
        """Knowledge without one occurrence of ``space``. Raises ``ValueError`` if there is none."""
        key = space.demonstration.frame
        if key not in self.frames:
            raise ValueError(f"nothing is known of {key}")
        frame = self.frames[key].without(space)
        others = {k: f for k, f in self.frames.items() if k != key}
        return VerbKnowledge({**others, key: frame} if frame.spaces else others)

    def replaced(self, old: HypothesisSpace, new: HypothesisSpace | None) -> VerbKnowledge:
        """Knowledge in which a corrected space stands for ``old``; None takes it away."""
        rest = self.without(old)
        return rest if new is None else rest.with_space(new)

    @cached_property
    def digest(self) -> str:
        """SHA-256 over the spaces' digests: the content hash, free of the order of learning."""
        text = "\n".join(space.digest for space in self.spaces)
        return hashlib.sha256(text.encode()).hexdigest()

    def to_json(self) -> dict[str, Any]:
        """Plain JSON: the demonstrations' spaces, from which ``from_json`` rebuilds the rest."""
        return {"spaces": [space.to_json() for space in self.spaces]}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> VerbKnowledge:
        """Rebuild knowledge, without planning. Raises ``ValueError`` on other data."""
        if not isinstance(data.get("spaces"), list):
            raise ValueError("not verb knowledge: the list 'spaces' is missing")
        return cls.merged(HypothesisSpace.from_json(space) for space in data["spaces"])
