"""The lab's earlier runs: a list gone through with the arrow keys; each can be looked at."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.message import Message

from verbteach_tui.lab.jobs import TRAIN
from verbteach_tui.lab.results import Earlier
from verbteach_tui.messages import TargetPicked
from verbteach_tui.views.rows import Row, Span, clipped, padded
from verbteach_tui.widgets.rows_view import RowsView

_NONE: list[Row] = [(Span("None yet: results are kept in the folder lab.", "muted"),)]


class EarlierRuns(RowsView):
    """Up and Down choose a run, which is then shown; Enter takes its settings over."""

    HELP = (
        "What came of earlier runs, the newest first. Up and Down choose one, and its curve or "
        "its table is shown above. Enter takes its settings over, to run it again or to change "
        "them."
    )
    BORDER_TITLE = "Earlier runs"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "move(-1)", "Run before", show=False),
        Binding("down", "move(1)", "Next run", show=False),
        Binding("enter", "take", "Take its settings", show=False),
    ]

    class Looked(Message):
        """A run is to be shown."""

        def __init__(self, run: Earlier) -> None:
            super().__init__()
            self.run = run

    class Taken(Message):
        """The settings of a run are to be taken over."""

        def __init__(self, run: Earlier) -> None:
            super().__init__()
            self.run = run

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._runs: tuple[Earlier, ...] = ()
        self._at = 0

    def show_runs(self, runs: Sequence[Earlier]) -> None:
        """Show ``runs``, the newest first; the cursor begins there."""
        self._runs, self._at = tuple(runs), 0
        self._redraw_all()

    def watch_has_focus(self, has_focus: bool) -> None:
        """Whoever comes here wants to look; the cursor goes with the keys."""
        super().watch_has_focus(has_focus)
        if has_focus:
            self._look()
        else:
            self._redraw_all()

    def action_move(self, by: int) -> None:
        """Another run."""
        self._at = min(max(self._at + by, 0), max(len(self._runs) - 1, 0))
        self._look()

    def action_take(self) -> None:
        """Take the settings over."""
        if self._runs:
            self.post_message(self.Taken(self._runs[self._at]))

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click chooses a run."""
        message.stop()
        self.focus()
        self._at = int(message.target)
        self._look()

    def _look(self) -> None:
        self._redraw_all()
        if self._runs:
            self.post_message(self.Looked(self._runs[self._at]))

    def _redraw_all(self) -> None:
        self.show(self._drawn)
        self.reveal(self._at)

    def _drawn(self, width: int) -> Sequence[Row]:
        return [self._row(number, run, width) for number, run in enumerate(self._runs)] or _NONE

    def _row(self, number: int, run: Earlier, width: int) -> Row:
        here = number == self._at and self.has_focus
        style = "strong" if here else "text"
        spans = [Span("▸ " if here else "  ", "accent"), Span(told(run), style, str(number))]
        return padded(clipped(spans, width), width)


def told(run: Earlier) -> str:
    """As in: 20300102-030405-abcdefgh  compare  std3  silent .41, manual .55."""
    job = run.job
    if job.kind == TRAIN:
        what = "weights.json" if run.trained else ""
    else:
        what = ", ".join(f"{row['policy']} {row['sji']['mean']:.2f}" for row in run.rows)
    return f"{run.path.name}  {job.kind:7}  {job.noise:7}  {what or 'not finished'}"
