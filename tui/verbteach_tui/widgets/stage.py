"""The panel for what is going on: showing the robot something, watching it, checking a goal."""

from __future__ import annotations

from textual.app import ComposeResult
from textual.containers import Container
from textual.widget import Widget

from verbteach.dialogue.moves import Phase
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.views.execution import Playback
from verbteach_tui.views.visible import shortened
from verbteach_tui.widgets.demonstration_builder import DemonstrationBuilder
from verbteach_tui.widgets.execution_view import ExecutionView
from verbteach_tui.widgets.read_back_view import ReadBackView

BRIEF = 4
"""As many steps or parts at most leave more rows to the panel beside them, where rows are few."""


class Stage(Container):
    """Shows one of its three views, or nothing."""

    DEFAULT_CSS = """
    Stage { display: none; & > * { display: none; } }
    """

    def compose(self) -> ComposeResult:
        """The three views."""
        yield DemonstrationBuilder(id="builder")
        yield ExecutionView(id="execution")
        yield ReadBackView(id="read-back")

    @property
    def execution(self) -> ExecutionView:
        """The view of an execution."""
        return self.query_one(ExecutionView)

    @property
    def builder(self) -> DemonstrationBuilder:
        """The view that demonstrations are made in."""
        return self.query_one(DemonstrationBuilder)

    def show_snapshot(self, snapshot: Snapshot, played: bool, speed: float) -> bool:
        """Show what ``snapshot`` is about; whether there is anything to show."""
        view = self._view(snapshot)
        for child in self.children:
            child.display = child is view
        self.border_title = view.BORDER_TITLE if view else ""
        if view is self.execution:
            playback = Playback(snapshot.steps, speed=speed, failed=snapshot.failure)
            self.execution.play(playback) if played else self.execution.show_over(playback)
        elif view is self.builder:
            self.border_title = f"{view.BORDER_TITLE}: {shortened(snapshot.command, 40)}"
            self.builder.show_snapshot(snapshot, speed)
        elif isinstance(view, ReadBackView):
            view.show_parts(snapshot.parts)
        brief = view is not self.builder and len(snapshot.steps) + len(snapshot.parts) <= BRIEF
        self.set_class(brief, "-brief")
        return view is not None

    def take_focus(self) -> None:
        """Put the keys into the view that is on."""
        if self.builder.display:
            self.builder.take_focus()
        else:
            on = [child for child in self.children if child.display]
            if on:
                on[0].focus()

    def _view(self, snapshot: Snapshot) -> Widget | None:
        if snapshot.phase is Phase.DEMONSTRATION:
            return self.builder
        if snapshot.phase is Phase.JUDGEMENT and snapshot.steps:
            return self.execution
        if snapshot.phase is Phase.READ_BACK:
            return self.query_one(ReadBackView)
        return None
