"""The verbs the robot has learned: each verb's hypotheses, from specific to general."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, TypeAlias

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.screen import Screen
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from verbteach.dialogue import acts
from verbteach.verbs.space import FrameKey
from verbteach_tui.hypotheses import hypothesis_graph
from verbteach_tui.messages import ConditionJudged, NodeChosen, TargetPicked
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.views.graph import HypothesisGraph
from verbteach_tui.views.mind import KnownVerb
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.hypothesis_view import HypothesisView
from verbteach_tui.widgets.node_view import NodeView
from verbteach_tui.widgets.title_bar import TitleBar

Revising: TypeAlias = acts.RuleOut | acts.Confirm
"""What the teacher can say about a fluent that was learned."""

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
        Binding("x,delete", "judge(False)", "Strike out"),
        Binding("c", "judge(True)", "Confirm"),
    ]

    def __init__(
        self, snapshot: Snapshot, frame: str = "", revise: Callable[[Revising], None] | None = None
    ) -> None:
        super().__init__(classes="-of-verbs")
        self._snapshot = snapshot
        self._frame = frame
        self._revise = revise
        self._graph = HypothesisGraph("")

    def compose(self) -> ComposeResult:
        """The three panels."""
        yield TitleBar()
        with Horizontal(id="verbs"):
            yield OptionList(id="frames", compact=True)
            with Vertical(id="meaning"):
                yield HypothesisView(id="graph")
                yield NodeView(id="node")
        yield Foot()

    def on_mount(self) -> None:
        """List the verbs; the one that was just learned first."""
        self.query_one("#frames", OptionList).border_title = "Verbs"
        self.show_snapshot(self._snapshot)
        known = bool(self._snapshot.mind.verbs)
        self.query_one(HypothesisView if known else NodeView).focus()

    def show_snapshot(self, snapshot: Snapshot) -> None:
        """Show what the robot knows now; the verb that was chosen stays so."""
        self._snapshot, verbs = snapshot, snapshot.mind.verbs
        self.query_one(TitleBar).show_title(f"{snapshot.scene}  ·  verbs", ())
        self.set_class(not verbs, "-empty")
        frames = self.query_one("#frames", OptionList)
        chosen = frames.highlighted_option
        wanted = chosen.id if chosen else self._frame
        self._list_frames()
        if not verbs:
            self.query_one(NodeView).tell(_NOTHING)
            return
        before = [i for i, verb in enumerate(verbs) if verb.target == wanted]
        fresh = [i for i, verb in enumerate(verbs) if verb.news]
        frames.highlighted = (before or fresh or [0])[0]
        self._show_frame(verbs[frames.highlighted].target)

    def _list_frames(self) -> None:
        """A verb takes three rows in a column of their own, one where that is above the graph."""
        frames, label = self.query_one("#frames", OptionList), _label
        if self.has_class("-narrow"):
            label = _short_label
        at = frames.highlighted
        with self.prevent(OptionList.OptionHighlighted):
            frames.set_options(Option(label(v), id=v.target) for v in self._snapshot.mind.verbs)
            frames.highlighted = at

    def on_resize(self) -> None:
        """The list goes above the graph, or back beside it."""
        self.call_after_refresh(self._list_frames)

    @property
    def idle_actions(self) -> frozenset[str]:
        """Where no verb is known there is nothing to judge."""
        judging = frozenset({"judge(False)", "judge(True)"})
        return frozenset() if self._snapshot.mind.verbs else judging

    def on_option_list_option_highlighted(self, message: OptionList.OptionHighlighted) -> None:
        """Another verb."""
        if message.option_id is not None:
            self._show_frame(message.option_id)

    def _show_frame(self, frame: str) -> None:
        snapshot, self._frame = self._snapshot, frame
        key = FrameKey.parse(frame)
        self._graph = hypothesis_graph(
            snapshot.knowledge, snapshot.learned_from, key, snapshot.words
        )
        view = self.query_one(HypothesisView)
        view.border_title = f"{self._graph.title}: specific to general"
        view.show_graph(self._graph)

    def action_judge(self, wanted: bool) -> None:
        """Confirm the chosen condition, or strike it out."""
        self.query_one(NodeView).judge(wanted)

    def on_condition_judged(self, message: ConditionJudged) -> None:
        """Say so to the robot."""
        node = self._graph.nodes[message.node]
        if self._revise is None:
            self.notify("What was recorded cannot be changed.")
            return
        kind = acts.Confirm if message.wanted else acts.RuleOut
        self._revise(kind(self._frame, frozenset(node.literals), node.literals[message.index]))

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """Into the graph."""
        self.query_one(HypothesisView).focus()

    def on_node_chosen(self, message: NodeChosen) -> None:
        """Another hypothesis."""
        self.query_one(NodeView).show_node(self._graph, message.name)

    def on_target_picked(self, message: TargetPicked) -> None:
        """A link to another hypothesis was clicked."""
        if message.target in self._graph.nodes:
            self.query_one(HypothesisView).choose(message.target)


def _label(verb: KnownVerb) -> Content:
    star, hypotheses, lessons = _told(verb)
    return Content(f"{star}{verb.title}\n  {hypotheses}\n  {lessons}")


def _short_label(verb: KnownVerb) -> Content:
    star, hypotheses, lessons = _told(verb)
    return Content(f"{star}{verb.title:20}  {hypotheses}, {lessons}")


def _told(verb: KnownVerb) -> tuple[str, str, str]:
    hypotheses = f"{verb.hypotheses} hypothes{'is' if verb.hypotheses == 1 else 'es'}"
    lessons = f"{verb.demonstrations} lesson{'s' * (verb.demonstrations != 1)}"
    return "✱ " if verb.news else "  ", hypotheses, lessons
