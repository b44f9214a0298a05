"""The verbs the robot has learned: each verb's hypotheses, from specific to general."""

from __future__ import annotations

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.screen import Screen
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from verbteach.verbs.space import FrameKey
from verbteach_tui.hypotheses import hypothesis_graph
from verbteach_tui.messages import NodeChosen, TargetPicked
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.views.graph import HypothesisGraph, describe_node
from verbteach_tui.views.mind import KnownVerb
from verbteach_tui.views.rows import Span, wrapped
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.hypothesis_view import HypothesisView
from verbteach_tui.widgets.rows_view import RowsView
from verbteach_tui.widgets.title_bar import TitleBar

_NOTHING = (
    "The robot knows no verb yet. Go back, give a command, show what it means and say that the "
    "goal it reads back is right: then its hypotheses grow here."
)


class VerbsScreen(Screen[None]):
    """A list of verbs, the chosen one's graph, and what the chosen hypothesis says."""

    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 (the base class declares its type)
        (0, "-narrow"),
        (100, "-wide"),
    ]
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,f5", "dismiss", "Back"),
        Binding("tab", "app.focus_next", "Next panel", show=False),
    ]

    def __init__(self, snapshot: Snapshot, frame: str = "") -> None:
        super().__init__()
        self._snapshot = snapshot
        self._frame = frame
        self._graph = HypothesisGraph("")

    def compose(self) -> ComposeResult:
        """The three panels."""
        yield TitleBar()
        with Horizontal(id="verbs"):
            yield OptionList(id="frames", compact=True)
            with Vertical(id="meaning"):
                yield HypothesisView(id="graph")
                yield RowsView(id="node")
        yield Foot()

    def on_mount(self) -> None:
        """List the verbs; the one that was just learned first."""
        verbs = self._snapshot.mind.verbs
        self.query_one(TitleBar).show_title(f"{self._snapshot.scene}  ·  verbs", ())
        frames = self.query_one("#frames", OptionList)
        frames.border_title = "Verbs"
        frames.set_options(Option(_label(verb), id=verb.target) for verb in verbs)
        self.query_one("#node", RowsView).border_title = "What it says"
        if not verbs:
            self.query_one("#node", RowsView).show(lambda w: wrapped([Span(_NOTHING)], w))
            return
        wanted = [i for i, verb in enumerate(verbs) if verb.target == self._frame]
        fresh = [i for i, verb in enumerate(verbs) if verb.news]
        frames.highlighted = (wanted or fresh or [0])[0]
        self.query_one(HypothesisView).focus()

    def on_option_list_option_highlighted(self, message: OptionList.OptionHighlighted) -> None:
        """Another verb."""
        if message.option_id is None:
            return
        snapshot = self._snapshot
        key = FrameKey.parse(message.option_id)
        self._graph = hypothesis_graph(
            snapshot.knowledge, snapshot.learned_from, key, snapshot.words
        )
        view = self.query_one(HypothesisView)
        view.border_title = f"{self._graph.title}: specific to general"
        view.show_graph(self._graph)

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """Into the graph."""
        self.query_one(HypothesisView).focus()

    def on_node_chosen(self, message: NodeChosen) -> None:
        """Another hypothesis."""
        graph = self._graph
        self.query_one("#node", RowsView).show(lambda w: describe_node(graph, message.name, w))

    def on_target_picked(self, message: TargetPicked) -> None:
        """A link to another hypothesis was clicked."""
        if message.target in self._graph.nodes:
            self.query_one(HypothesisView).choose(message.target)


def _label(verb: KnownVerb) -> Content:
    star = "✱ " if verb.news else "  "
    hypotheses = f"{verb.hypotheses} hypothes{'is' if verb.hypotheses == 1 else 'es'}"
    lessons = f"{verb.demonstrations} lesson{'s' * (verb.demonstrations != 1)}"
    return Content(f"{star}{verb.title}\n  {hypotheses}\n  {lessons}")
