"""A verb's hypothesis graph: move between hypotheses with the arrow keys, or click one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.geometry import Region

from verbteach_tui.messages import NodeChosen, TargetPicked
from verbteach_tui.views.graph import Drawing, HypothesisGraph, draw_graph
from verbteach_tui.views.rows import Row
from verbteach_tui.widgets.rows_view import RowsView


class HypothesisView(RowsView):
    """The graph, specific at the top; the chosen node and its links stand out."""

    HELP = (
        "The hypotheses about what the verb means: at the top those with the most conditions, "
        "below them ever more general ones. A ×2 was seen in two lessons; ✱ is new, ↑ was seen "
        "once more, ✓ was confirmed by the teacher. The arrow keys choose a hypothesis; below "
        "stands what it says."
    )
    BORDER_TITLE = "Hypotheses, specific to general"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left", "step(-1)", "Left", show=False),
        Binding("right", "step(1)", "Right", show=False),
        Binding("up", "level(-1)", "More specific", show=False),
        Binding("down", "level(1)", "More general", show=False),
    ]
    DEFAULT_CSS = "HypothesisView { overflow-x: auto; }"

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._graph = HypothesisGraph("")
        self._chosen = ""
        self._drawing = Drawing((), {})

    @property
    def chosen(self) -> str:
        """The chosen node's name."""
        return self._chosen

    def show_graph(self, graph: HypothesisGraph) -> None:
        """Show ``graph``, its foremost node chosen."""
        self._graph = graph
        self.choose(graph.foremost)

    def action_step(self, by: int) -> None:
        """The next hypothesis to the left or right."""
        order = self._in_level(self._level)
        if order:
            here = order.index(self._chosen)
            self.choose(order[min(max(here + by, 0), len(order) - 1)])

    def action_level(self, by: int) -> None:
        """A linked hypothesis above or below, else the nearest one of that level."""
        linked = self._graph.general(self._chosen) if by > 0 else self._graph.specific(self._chosen)
        level = self._level + by
        names = linked or (self._in_level(level) if 0 <= level < len(self._graph.levels) else ())
        if names:
            column = self._drawing.places[self._chosen][1]
            self.choose(min(names, key=lambda name: abs(self._drawing.places[name][1] - column)))

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a node chooses it."""
        message.stop()
        self.choose(message.target)

    @property
    def _level(self) -> int:
        for index, level in enumerate(self._graph.levels):
            if any(node.name == self._chosen for node in level):
                return index
        return 0

    def _in_level(self, level: int) -> list[str]:
        names = [node.name for node in self._graph.levels[level]] if self._graph.levels else []
        return sorted(names, key=lambda name: self._drawing.places[name][1])

    def choose(self, name: str) -> None:
        """Choose a node, and bring it into view."""
        self._chosen = name
        self.show(self._drawn)
        self.post_message(NodeChosen(name))
        self._reveal_chosen()

    def on_resize(self, event: events.Resize) -> None:
        """The chosen node stays in view."""
        self._reveal_chosen()

    def _reveal_chosen(self) -> None:
        place = self._drawing.places.get(self._chosen)
        if place is not None:
            row, column, size = place
            self.reveal_region(Region(column, row, size, 1))

    def widest(self, width: int) -> int:
        """A level may be wider than the view, which then scrolls sideways."""
        return max([width, *(start + size for _, start, size in self._drawing.places.values())])

    def _drawn(self, width: int) -> Sequence[Row]:
        self._drawing = draw_graph(self._graph, width, self._chosen)
        return self._drawing.rows
