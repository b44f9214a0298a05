"""The lab: train the robot's asking, or compare policies, and watch it learn.

The work is done in another process; the screen looks now and then how it
stands. Leaving the screen leaves the work going on.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.screen import Screen

from verbteach_tui.lab.drawing import curve_rows, progress_rows, table_rows
from verbteach_tui.lab.jobs import COMPARE, TRAIN
from verbteach_tui.lab.lab import DONE, Lab, LabState
from verbteach_tui.lab.results import Earlier, earlier_runs
from verbteach_tui.screens.lab_settings import LabSettings
from verbteach_tui.views.rows import Row, Span, clipped, wrapped
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.rows_view import RowsView
from verbteach_tui.widgets.title_bar import TitleBar

LOOKS = 5.0
"""Looks a second at how the work stands."""

_SHOWN = 20


class LabScreen(Screen[None]):
    """Settings, progress, what comes of it, and what came of earlier runs."""

    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 (the base class declares its type)
        (0, "-narrow"),
        (100, "-wide"),
    ]
    HELP = "The lab. Tab goes from panel to panel, x cancels what is going on, Escape goes back."
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "dismiss", "Back"),
        Binding("x", "cancel", "Cancel the run"),
        Binding("tab", "app.focus_next", "Next panel", show=False),
    ]
    DEFAULT_CSS = """
    LabScreen #lab { height: 1fr; }
    LabScreen RowsView { border: round $rule; border-title-color: $quiet; }
    LabScreen RowsView:focus { border: round $primary; border-title-color: $primary; }
    LabScreen TitleBar, LabScreen Foot { border: none; }
    LabScreen #settings { width: 34; height: 1fr; }
    LabScreen #course { width: 1fr; }
    LabScreen #progress { height: 4; }
    LabScreen #outcome { height: 1fr; }
    LabScreen #earlier { height: 8; }
    LabScreen.-narrow #lab { layout: vertical; }
    LabScreen.-narrow #settings { width: 100%; height: 8; }
    LabScreen.-narrow #course { width: 100%; height: 1fr; }
    LabScreen.-narrow #earlier, LabScreen.-narrow.-running #settings { display: none; }
    """

    def __init__(self, lab: Lab) -> None:
        super().__init__()
        self._lab = lab
        self._seen: LabState | None = None

    def compose(self) -> ComposeResult:
        """The panels."""
        yield TitleBar()
        with Horizontal(id="lab"):
            yield LabSettings(id="settings")
            with Vertical(id="course"):
                yield RowsView(id="progress")
                yield RowsView(id="outcome")
                yield RowsView(id="earlier")
        yield Foot()

    def on_mount(self) -> None:
        """Show how the work stands, now and again."""
        self.query_one(TitleBar).show_title("lab")
        self.query_one("#progress").border_title = "Progress"
        self.query_one("#earlier").border_title = "Earlier runs"
        settings = self.query_one(LabSettings)
        if self._lab.state.job is not None:
            settings.job = self._lab.state.job
        settings.focus()
        self._list_earlier()
        self._look()
        self.set_interval(1 / LOOKS, self._look)

    def on_lab_settings_started(self, message: LabSettings.Started) -> None:
        """Begin, unless something is going on."""
        if not self._lab.start(message.job):
            self.notify("One run at a time: x cancels the one that is going on.")
        self._look()

    def action_cancel(self) -> None:
        """End the run."""
        if self._lab.state.running:
            self._lab.cancel()
            self._look()

    def _look(self) -> None:
        state = self._lab.state
        if state is self._seen:
            return
        before, self._seen = self._seen, state
        self._make_room(state.running)
        self.query_one("#progress", RowsView).show(lambda width: progress_rows(state, width))
        self._draw_outcome()
        if before is not None and before.running and not state.running:
            self._list_earlier()

    def on_resize(self) -> None:
        """The curve is as high as there is room."""
        self.call_after_refresh(self._draw_outcome)

    def _draw_outcome(self) -> None:
        state = self._seen or self._lab.state
        outcome = self.query_one("#outcome", RowsView)
        outcome.border_title = "Policies" if _compares(state) else "Learning curve"
        outcome.show(lambda width: self._outcome(state, width))

    def _make_room(self, running: bool) -> None:
        """Where there is little room, the settings leave it to the work while that goes on."""
        if self.has_class("-running") == running:
            return
        self.set_class(running, "-running")
        narrow = self.has_class("-narrow")
        if running and narrow:
            self.query_one("#outcome").focus()
        elif narrow:
            self.query_one(LabSettings).focus()
        self.call_after_refresh(self._draw_outcome)

    def _outcome(self, state: LabState, width: int) -> Sequence[Row]:
        height = self.query_one("#outcome").scrollable_content_region.height
        total = state.job.dialogues if state.job else 1
        rows: list[Row] = []
        if _compares(state):
            rows = table_rows(state.rows, width)
            curves = {name.rpartition(": ")[2]: figures for name, figures in state.curves.items()}
            left = height - len(rows) - 1
            if state.running and left > 5:
                return [*rows, (), *curve_rows(curves, total, width, left)]
            return rows or wrapped(
                [Span("Each policy gets its row when it is done.", "muted")], width
            )
        rows = curve_rows(state.curves, total, width, max(height - 1, 3))
        if state.phase == DONE and state.folder is not None:
            use = f"Teach with it: verbteach teach --weights {state.folder / 'weights.json'}"
            rows.append(clipped([Span(use, "good")], width))
        return rows or wrapped([Span(_ABOUT, "muted")], width)

    def _list_earlier(self) -> None:
        self.run_worker(self._read_earlier, thread=True, exit_on_error=False, group="lab")

    def _read_earlier(self) -> None:
        runs = earlier_runs(self._lab.folder)[:_SHOWN]
        self.app.call_from_thread(self._show_earlier, runs)

    def _show_earlier(self, runs: Sequence[Earlier]) -> None:
        view = self.query_one("#earlier", RowsView)
        view.show(lambda width: [clipped([Span(_told(run))], width) for run in runs] or _NONE)


_ABOUT = (
    "Train: the robot holds dialogues with simulated people about the bundled lessons and learns "
    "which question is worth its price; the mean return of its dialogues is drawn here as it "
    "learns, and its weights are saved for teaching. Compare: policies are taught the same verbs, "
    "each asking in its own way, and are then tested in rooms that they have not seen."
)
_NONE: list[Row] = [(Span("None yet: results are kept in the folder lab.", "muted"),)]


def _compares(state: LabState) -> bool:
    return state.job is not None and state.job.kind == COMPARE


def _told(run: Earlier) -> str:
    """As in: 20300102-030405-abcdefgh  compare  std3  silent .41, manual .55."""
    job = run.job
    if job.kind == TRAIN:
        what = "weights.json" if run.trained else "not finished"
    else:
        what = ", ".join(f"{row['policy']} {row['sji']['mean']:.2f}" for row in run.rows)
    return f"{run.path.name}  {job.kind:7}  {job.noise:7}  {what or 'not finished'}"
