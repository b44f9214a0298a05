"""A verb's hypotheses as a graph, from the most specific at the top to the most general below."""

from __future__ import annotations

from collections.abc import Collection, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeVar

from verbteach.world.fluents import Literal
from verbteach_tui.views.braille import BrailleCanvas
from verbteach_tui.views.rows import Row, Span, clipped, wrapped
from verbteach_tui.views.visible import shortened

T = TypeVar("T", bound=Hashable)

GAP = 2
"""Rows between two levels, for the links."""

_BETWEEN = 2

CONDITION = "condition:"
"""Begins the target of a hypothesis' condition; its index follows."""


@dataclass(frozen=True)
class GraphNode:
    """One hypothesis.

    ``name`` is how the graph calls it (A, B, ...). ``conditions`` are its
    fluents in words. ``demonstrations`` are the commands that it was seen in,
    ``frequency`` how many. ``whole``: a demonstration's whole goal;
    ``confirmed``: its teacher said so. ``news`` says what the last learning did
    to it: "new", "seen again", or nothing. ``literals`` are the conditions as the
    record names them, in their order.
    """

    name: str
    conditions: tuple[str, ...]
    frequency: int = 1
    demonstrations: tuple[str, ...] = ()
    whole: bool = False
    confirmed: bool = False
    news: str = ""
    literals: tuple[Literal, ...] = ()

    @property
    def label(self) -> str:
        """As drawn: its name, how often it was seen, whether that is news, and if confirmed."""
        star = {"new": "✱", "seen again": "↑"}.get(self.news, "")
        return f" {star}{self.name} ×{self.frequency}{'✓' if self.confirmed else ''} "


@dataclass(frozen=True)
class HypothesisGraph:
    """One verb frame's hypotheses in levels, and its links from the specific to the general."""

    title: str
    levels: tuple[tuple[GraphNode, ...], ...] = ()
    links: tuple[tuple[str, str], ...] = ()
    demonstrations: tuple[str, ...] = ()
    gone: tuple[str, ...] = field(default=())

    @cached_property
    def nodes(self) -> Mapping[str, GraphNode]:
        """The nodes by name, specific to general."""
        return {node.name: node for level in self.levels for node in level}

    @property
    def foremost(self) -> str:
        """The node to look at first: confirmed, in the news, seen often, and general."""
        nodes = list(enumerate(self.nodes.values()))
        order = [
            (node.confirmed, bool(node.news), node.frequency, index, node.name)
            for index, node in nodes
        ]
        return max(order)[-1] if order else ""

    def general(self, name: str) -> tuple[str, ...]:
        """The next more general nodes."""
        return tuple(lower for upper, lower in self.links if upper == name)

    def specific(self, name: str) -> tuple[str, ...]:
        """The next more specific nodes."""
        return tuple(upper for upper, lower in self.links if lower == name)


def node_name(index: int) -> str:
    """A, B, ..., Z, A2, B2, ..."""
    letter, turn = chr(ord("A") + index % 26), index // 26
    return letter if turn == 0 else f"{letter}{turn + 1}"


@dataclass(frozen=True)
class Drawing:
    """Drawn rows with each node's place as (row, first column, columns)."""

    rows: tuple[Row, ...]
    places: Mapping[str, tuple[int, int, int]]


def draw_graph(graph: HypothesisGraph, width: int, chosen: str = "") -> Drawing:
    """The graph drawn in at least ``width`` columns, more where a level needs them."""
    room = max([width, *(_level_width(level) for level in graph.levels)])
    places = _places(graph, room)
    canvas = BrailleCanvas(room, len(graph.levels) * (GAP + 1))
    # The chosen node's links come last, so that they stay on top where links cross.
    for upper, lower in sorted(graph.links, key=lambda link: chosen in link):
        style = "accent" if chosen in (upper, lower) else "border"
        canvas.line(_below(places[upper]), _above(places[lower]), style)
    rows = []
    for index, level in enumerate(graph.levels):
        rows.append(_node_row(level, places, chosen))
        if index < len(graph.levels) - 1:
            top = index * (GAP + 1) + 1
            rows.extend(_link_row(canvas, y) for y in range(top, top + GAP))
    return Drawing(tuple(rows), places)


def _level_width(level: Sequence[GraphNode]) -> int:
    return sum(len(node.label) + _BETWEEN for node in level)


def _places(graph: HypothesisGraph, width: int) -> dict[str, tuple[int, int, int]]:
    places: dict[str, tuple[int, int, int]] = {}
    for index, level in enumerate(graph.levels):
        slack = width - _level_width(level)
        column: float = slack / (len(level) + 1)
        for node in level:
            size = len(node.label)
            places[node.name] = (index * (GAP + 1), int(column), size)
            column += size + _BETWEEN + slack / (len(level) + 1)
    return places


def uncrossed(
    levels: Sequence[Sequence[T]], links: Collection[tuple[T, T]]
) -> tuple[tuple[T, ...], ...]:
    """Order each level by the middle of what it hangs from above, so that fewer links cross."""
    above: dict[T, list[T]] = {}
    for upper, lower in links:
        above.setdefault(lower, []).append(upper)
    place: dict[T, float] = {}
    ordered = []
    for level in levels:
        middles = {
            node: [place[upper] for upper in above.get(node, ()) if upper in place]
            for node in level
        }
        order = sorted(level, key=lambda n: sum(middles[n]) / len(middles[n]) if middles[n] else 1)
        place.update({node: (rank + 0.5) / len(order) for rank, node in enumerate(order)})
        ordered.append(tuple(order))
    return tuple(ordered)


def _below(place: tuple[int, int, int]) -> tuple[float, float]:
    row, column, size = place
    return column + size / 2, row + 1


def _above(place: tuple[int, int, int]) -> tuple[float, float]:
    row, column, size = place
    return column + size / 2, row - 0.01


def _node_row(
    level: Sequence[GraphNode], places: Mapping[str, tuple[int, int, int]], chosen: str
) -> Row:
    spans, used = [], 0
    for node in sorted(level, key=lambda node: places[node.name][1]):
        column = places[node.name][1]
        style = "cursor" if node.name == chosen else "new" if node.news else "strong"
        spans += [Span(" " * (column - used)), Span(node.label, style, node.name)]
        used = column + len(node.label)
    return tuple(spans)


def _link_row(canvas: BrailleCanvas, y: int) -> Row:
    cells = [canvas.cell(x, y) for x in range(canvas.width)]
    return tuple(Span(character, style or "text") for character, style in cells)


def describe_node(graph: HypothesisGraph, name: str, width: int, cursor: int = -1) -> list[Row]:
    """What a node says: its conditions, where it comes from, and what lies around it.

    ``cursor`` is the index of the condition that is chosen.
    """
    node = graph.nodes.get(name)
    if node is None:
        return wrapped([Span("No hypothesis is chosen.", "muted")], width)
    rows = wrapped([Span(f"{node.name}: {_rank(graph, node)}", "strong")], width, 3)
    rows += wrapped([Span("What must hold afterwards", "muted")], width)
    for index, text in enumerate(node.conditions):
        style, target = ("strong" if index == cursor else "text"), f"{CONDITION}{index}"
        mark = [Span("▸ " if index == cursor else "  ", "accent"), Span("● ", "good", target)]
        rows += wrapped([Span(text, style, target)], width, 4, mark)
    rows += _around(graph, node, width)
    return rows


def _rank(graph: HypothesisGraph, node: GraphNode) -> str:
    first, last = node in graph.levels[0], node in graph.levels[-1]
    rank = "most specific" if first else "most general" if last else "in between"
    marks = [rank if len(graph.levels) > 1 else "the only hypothesis"]
    marks += ["a whole goal as shown"] * node.whole + ["confirmed by its teacher"] * node.confirmed
    marks += [node.news] * bool(node.news)
    return ", ".join(marks)


def _around(graph: HypothesisGraph, node: GraphNode, width: int) -> list[Row]:
    rows: list[Row] = []
    for title, names in (
        ("More specific", graph.specific(node.name)),
        ("More general", graph.general(node.name)),
    ):
        if names:
            spans = [Span(f"{title}: ", "muted")]
            for other in names:
                spans += [Span(other, "accent", other), Span(" ")]
            rows += wrapped(spans, width, 2)
    rows += wrapped([Span(f"Seen {_times(node.frequency)}, in:", "muted")], width)
    for command in node.demonstrations:
        rows += wrapped([Span(shortened(command, 120))], width, 4, [Span("  – ", "muted")])
    return rows


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"


def graph_heading(graph: HypothesisGraph, width: int) -> Row:
    """The graph's title with its size."""
    count = len(graph.nodes)
    size = f"{count} hypothes{'is' if count == 1 else 'es'}"
    shown = len(graph.demonstrations)
    text = f" · {size} from {shown} demonstration{'s' * (shown != 1)}"
    return clipped([Span(graph.title, "strong"), Span(text, "muted")], width)
