"""The lab: train the robot's asking, or compare policies, and watch it learn.

The work is done in another process; the screen looks now and then how it
stands. Leaving the screen leaves the work going on.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.screen import Screen

from verbteach_tui.lab.about import LAB, SETTINGS
from verbteach_tui.lab.drawing import bar_rows, curve_rows, progress_rows, table_rows
from verbteach_tui.lab.jobs import COMPARE, KINDS, Job
from verbteach_tui.lab.lab import DONE, IDLE, Lab, LabState
from verbteach_tui.lab.results import Earlier, curves_of, earlier_runs
from verbteach_tui.screens.lab_runs import EarlierRuns
from verbteach_tui.screens.lab_settings import LabSettings, Meanings, settings_of
from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.rows_view import RowsView
from verbteach_tui.widgets.title_bar import TitleBar

LOOKS = 5.0
"""Looks a second at how the work stands."""

_SHOWN = 60


class LabScreen(Screen[None]):
    """Settings, progress, what comes of it, and what came of earlier runs."""

    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 (the base class declares its type)
        (0, "-narrow"),
        (100, "-wide"),
        (170, "-very-wide"),
    ]
    HELP = "The lab. Tab goes from panel to panel, x cancels what is going on, Escape goes back."
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "dismiss", "Back"),
        Binding("x", "cancel", "Cancel the run"),
        Binding("tab", "app.focus_next", "Next panel"),
    ]
    DEFAULT_CSS = """
    LabScreen #lab { height: 1fr; }
    LabScreen RowsView { border: round $rule; border-title-color: $quiet; }
    LabScreen RowsView:focus { border: round $primary; border-title-color: $primary; }
    LabScreen TitleBar, LabScreen Foot { border: none; }
    LabScreen #side { width: 36; height: 1fr; }
    LabScreen.-very-wide #side { width: 60; }
    LabScreen #settings { height: auto; max-height: 70%; }
    LabScreen #about { height: 1fr; }
    LabScreen #course { width: 1fr; }
    LabScreen #progress { height: 4; }
    LabScreen #outcome { height: 3fr; }
    LabScreen #earlier { height: 1fr; min-height: 5; }
    LabScreen.-narrow #lab { layout: vertical; }
    /* Where there is little room, the panel that has the keys has most of it. */
    LabScreen.-narrow #side { width: 100%; height: 3; }
    LabScreen.-narrow #side:focus-within { height: auto; max-height: 60%; }
    LabScreen.-narrow #settings { max-height: 100%; }
    LabScreen.-narrow.-ran #side:focus-within { max-height: 8; }
    LabScreen.-narrow #course { width: 100%; height: 1fr; }
    LabScreen.-narrow #outcome { height: 1fr; }
    LabScreen.-narrow #earlier { height: 3; min-height: 3; }
    LabScreen.-narrow #earlier:focus { height: 5; }
    LabScreen.-narrow #about, LabScreen.-narrow.-idle #progress,
    LabScreen.-narrow.-first #earlier, LabScreen.-narrow.-running #earlier,
    LabScreen.-narrow.-running #side { display: none; }
    """

    def __init__(self, lab: Lab) -> None:
        super().__init__()
        self._lab = lab
        self._seen: LabState | None = None
        self._looked: tuple[Earlier, dict[str, tuple[float, ...]]] | None = None

    def compose(self) -> ComposeResult:
        """The panels."""
        yield TitleBar()
        with Horizontal(id="lab"):
            with Vertical(id="side"):
                yield LabSettings(id="settings")
                yield Meanings(id="about")
            with Vertical(id="course"):
                yield RowsView(id="progress")
                yield RowsView(id="outcome")
                yield EarlierRuns(id="earlier")
        yield Foot()

    def on_mount(self) -> None:
        """Show how the work stands, now and again."""
        self.query_one(TitleBar).show_title("lab")
        self.query_one("#progress").border_title = "Progress"
        settings = self.query_one(LabSettings)
        self.query_one("#progress").can_focus = False
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

    def on_lab_settings_reached(self, message: LabSettings.Reached) -> None:
        """Say what the setting means."""
        names = [setting.name for setting in settings_of(message.job)]
        self.query_one(Meanings).explain(names, message.setting)
        if (self._seen or self._lab.state).job is None:
            self._draw_outcome()  # which says the same where there is no room for more panels

    def action_cancel(self) -> None:
        """End the run."""
        if self._lab.state.running:
            self._lab.cancel()
            self._look()

    @property
    def idle_actions(self) -> frozenset[str]:
        """Where nothing is going on there is nothing to cancel."""
        return frozenset() if self._lab.state.running else frozenset({"cancel"})

    # ---- how the work stands

    def _look(self) -> None:
        state = self._lab.state
        if state is self._seen:
            return
        before, self._seen = self._seen, state
        self._looked = None
        self._make_room(state)
        self.query_one("#progress", RowsView).show(lambda width: progress_rows(state, width))
        self._draw_outcome()
        if before is None or before.running != state.running:
            self.refresh_bindings()
        if before is not None and before.running and not state.running:
            self._list_earlier()

    def on_resize(self) -> None:
        """The curve is as high as there is room."""
        self.call_after_refresh(self._draw_outcome)

    def _make_room(self, state: LabState) -> None:
        """Where there is little room, the settings leave it to the work while that goes on."""
        was = self.has_class("-running")
        classes = {"-idle": state.phase == IDLE, "-running": state.running}
        self.update_classes({**classes, "-ran": state.phase != IDLE})
        if was == state.running:
            return
        if self.has_class("-narrow"):
            # When it is done as well: what came of it is what everybody looks for.
            wanted = "#outcome" if state.running or state.phase == DONE else "#settings"
            self.call_after_refresh(self.query_one(wanted).focus)
        self.call_after_refresh(self._draw_outcome)

    def _draw_outcome(self) -> None:
        outcome = self.query_one("#outcome", RowsView)
        if self._looked is not None:
            run, curves = self._looked
            outcome.border_title = f"{_title(run.job)} of {run.path.name}"
            outcome.show(partial(self._of_earlier, run, curves))
            return
        state = self._seen or self._lab.state
        outcome.border_title = _title(state.job) if state.job else "The lab"
        outcome.show(partial(self._of_now, state))

    @property
    def _height(self) -> int:
        return self.query_one("#outcome").scrollable_content_region.height

    def _of_now(self, state: LabState, width: int) -> Sequence[Row]:
        if state.job is None:
            return _paragraphs(self._introduction, width)
        if state.job.kind == COMPARE:
            return self._comparison(state, width)
        use: list[Row] = []
        if state.phase == DONE and state.folder is not None:
            words = f"Teach with it: verbteach teach --weights {state.folder / 'weights.json'}"
            use = wrapped([Span(words, "good")], width)
        height = max(self._height - max(len(use), 1), 3)
        rows = [*curve_rows(state.curves, state.job.dialogues, width, height), *use]
        return rows or wrapped([Span("The curve begins with the first dialogues.", "muted")], width)

    @property
    def _introduction(self) -> Sequence[str]:
        """What can be done here; where there is no other room for it, what the settings mean."""
        settings = self.query_one(LabSettings)
        if not self.has_class("-narrow"):
            return LAB
        meaning = f"{settings.setting}: {SETTINGS[settings.setting]}"
        return (meaning, LAB[KINDS.index(settings.job.kind)])

    def _comparison(self, state: LabState, width: int) -> Sequence[Row]:
        rows = table_rows(state.rows, width)
        curves = {name.rpartition(": ")[2]: figures for name, figures in state.curves.items()}
        left = self._height - len(rows) - 1
        if state.running and state.job is not None and left > 5:
            curve = curve_rows(curves, state.job.dialogues, width, left)
            rows = [*rows, *([()] if rows and curve else []), *curve]
        elif rows and left > len(state.rows) + 1:
            rows = [*rows, (), *bar_rows(state.rows, width)]
        return rows or wrapped([Span("Each policy gets its row when it is done.", "muted")], width)

    # ---- earlier runs

    def on_earlier_runs_looked(self, message: EarlierRuns.Looked) -> None:
        """Show what came of it."""
        self._looked = (message.run, curves_of(message.run))
        self._draw_outcome()

    def on_earlier_runs_taken(self, message: EarlierRuns.Taken) -> None:
        """Its settings, to run it again or to change them."""
        settings = self.query_one(LabSettings)
        settings.take(message.run.job)
        settings.focus()

    def _of_earlier(
        self, run: Earlier, curves: dict[str, tuple[float, ...]], width: int
    ) -> Sequence[Row]:
        if run.job.kind == COMPARE:
            rows = [*table_rows(run.rows, width), (), *bar_rows(run.rows, width)]
        else:
            rows = curve_rows(curves, run.job.dialogues, width, max(self._height - 1, 3))
        finished = run.rows or curves
        return rows if finished else wrapped([Span("Not finished: nothing was kept.")], width)

    def _list_earlier(self) -> None:
        self.run_worker(self._read_earlier, thread=True, exit_on_error=False, group="lab")

    def _read_earlier(self) -> None:
        runs = earlier_runs(self._lab.folder)[:_SHOWN]
        self.app.call_from_thread(self._show_earlier, runs)

    def _show_earlier(self, runs: Sequence[Earlier]) -> None:
        self.set_class(not runs, "-first")
        self.query_one(EarlierRuns).show_runs(runs)


def _title(job: Job) -> str:
    return "Policies" if job.kind == COMPARE else "Learning curve"


def _paragraphs(texts: Sequence[str], width: int) -> list[Row]:
    rows: list[Row] = []
    for text in texts:
        rows += [*([()] if rows else []), *wrapped([Span(text, "muted")], width)]
    return rows
