"""What a hypothesis says: each of its conditions can be struck out or confirmed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.binding import Binding, BindingType

from verbteach_tui.messages import ConditionJudged, TargetPicked
from verbteach_tui.views.graph import CONDITION, HypothesisGraph, describe_node
from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.widgets.rows_view import RowsView


class NodeView(RowsView):
    """One hypothesis with a cursor among its conditions."""

    HELP = (
        "What the chosen hypothesis says must hold. Up and Down choose a condition. x strikes it "
        "out: the verb does not ask for it, and the hypotheses that hold it go. c confirms it: "
        "those of the same lessons without it go. Both can be undone."
    )
    BORDER_TITLE = "What it says"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "move(-1)", "Up", show=False),
        Binding("down", "move(1)", "Down", show=False),
    ]

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._graph = HypothesisGraph("")
        self._shown = ""
        self._cursor = 0

    def show_node(self, graph: HypothesisGraph, name: str) -> None:
        """Show a hypothesis; another one begins at its first condition."""
        if (graph.title, name) != (self._graph.title, self._shown):
            self._cursor = 0
        self._graph, self._shown = graph, name
        self._cursor = min(self._cursor, max(len(self._conditions) - 1, 0))
        self.show(self._drawn)

    def tell(self, text: str) -> None:
        """Show ``text`` instead of a hypothesis."""
        self._graph, self._shown = HypothesisGraph(""), ""
        self.show(lambda width: wrapped([Span(text)], width))

    def judge(self, wanted: bool) -> None:
        """Confirm the condition under the cursor, or strike it out."""
        if self._conditions:
            self.post_message(ConditionJudged(self._shown, self._cursor, wanted))

    def action_move(self, by: int) -> None:
        """Another condition."""
        self._cursor = min(max(self._cursor + by, 0), max(len(self._conditions) - 1, 0))
        self.show(self._drawn)
        self.reveal(self._cursor + 2)

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a condition chooses it; a click on another hypothesis goes on."""
        if message.target.startswith(CONDITION):
            message.stop()
            self._cursor = int(message.target.removeprefix(CONDITION))
            self.show(self._drawn)

    @property
    def _conditions(self) -> Sequence[str]:
        node = self._graph.nodes.get(self._shown)
        return node.conditions if node else ()

    def _drawn(self, width: int) -> Sequence[Row]:
        return describe_node(self._graph, self._shown, width, self._cursor)
