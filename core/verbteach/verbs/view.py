"""The hypothesis graph of a verb frame as data to draw, and what changed between two of them."""

from __future__ import annotations

from dataclasses import dataclass

from verbteach.verbs.knowledge import FrameSpace, HypothesisNode, VerbKnowledge
from verbteach.verbs.lifting import Lifted
from verbteach.verbs.space import FrameKey


@dataclass(frozen=True)
class NodeView:
    """One hypothesis: how often it was seen, in which demonstrations, and as whose whole goal."""

    literals: Lifted
    frequency: int
    base: int
    confirmed: int
    demonstrations: tuple[str, ...]


@dataclass(frozen=True)
class GraphView:
    """A frame's hypotheses in levels from specific to general, and its links downwards."""

    frame: FrameKey
    levels: tuple[tuple[NodeView, ...], ...]
    edges: tuple[tuple[Lifted, Lifted], ...]
    demonstrations: tuple[str, ...]


@dataclass(frozen=True)
class FrameDifference:
    """What learning or undoing did to one frame's hypotheses."""

    frame: FrameKey
    added: tuple[Lifted, ...]
    removed: tuple[Lifted, ...]
    frequencies: tuple[tuple[Lifted, int, int], ...]


def graph(frame: FrameSpace) -> GraphView:
    """The frame's graph; within a level the more frequent come first."""
    sizes = sorted({len(key) for key in frame.nodes}, reverse=True)
    levels = tuple(
        tuple(sorted(
            (_node(n) for n in frame.nodes.values() if len(n.literals) == size),
            key=lambda view: (-view.frequency, view.literals),
        ))
        for size in sizes
    )  # fmt: skip
    edges = tuple(
        (key, lower) for key, node in frame.nodes.items() for lower in sorted(node.general)
    )
    ids = tuple(space.demonstration.id for space in frame.spaces)
    return GraphView(frame.key, levels, edges, ids)


def graphs(knowledge: VerbKnowledge) -> tuple[GraphView, ...]:
    """Every frame's graph, by frame."""
    return tuple(graph(knowledge.frames[key]) for key in sorted(knowledge.frames))


def diff(before: VerbKnowledge, after: VerbKnowledge) -> tuple[FrameDifference, ...]:
    """The frames whose hypotheses differ, by frame: hypotheses new, gone, and counted anew."""
    found = []
    for key in sorted({*before.frames, *after.frames}):
        old, new = before.frames.get(key), after.frames.get(key)
        if old != new:
            found.append(_difference(key, old, new))
    return tuple(found)


def _difference(key: FrameKey, old: FrameSpace | None, new: FrameSpace | None) -> FrameDifference:
    was = old.nodes if old else {}
    now = new.nodes if new else {}
    counts = ((k, was[k].frequency, now[k].frequency) for k in now if k in was)
    return FrameDifference(
        key,
        tuple(k for k in now if k not in was),
        tuple(k for k in was if k not in now),
        tuple(row for row in counts if row[1] != row[2]),
    )


def _node(node: HypothesisNode) -> NodeView:
    return NodeView(
        node.literals,
        node.frequency,
        node.base,
        node.confirmed,
        tuple(sorted({use.demonstration.id for use in node.uses})),
    )
