"""The lab's settings: a column of choices, gone through with the arrow keys or the mouse."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.message import Message

from verbteach_tui.eyes import NOISES
from verbteach_tui.lab.about import SETTINGS
from verbteach_tui.lab.jobs import (
    COMPARE,
    DIALOGUES,
    KINDS,
    POLICIES,
    ROOMS,
    SEEDS,
    TRAIN,
    Job,
)
from verbteach_tui.messages import TargetPicked
from verbteach_tui.views.rows import Row, Span, clipped, padded, wrapped
from verbteach_tui.widgets.rows_view import RowsView

START = "start"


@dataclass(frozen=True)
class _Setting:
    """One row: its name, and the values there are with the job that each makes."""

    name: str
    values: tuple[str, ...]
    at: int


def settings_of(job: Job) -> list[_Setting]:
    """The rows for a job."""
    rows = [
        _Setting("Do", KINDS, KINDS.index(job.kind)),
        _Setting("Noise", NOISES, NOISES.index(job.noise)),
        _Setting("Dialogues", tuple(map(str, DIALOGUES)), DIALOGUES.index(job.dialogues)),
        _Setting("Seed", tuple(map(str, SEEDS)), SEEDS.index(job.seed)),
    ]
    if job.kind == COMPARE:
        rooms = list(ROOMS.values()).index(job.held_out)
        rows.append(_Setting("Tested in", tuple(ROOMS), rooms))
        rows += [
            _Setting(policy, ("no", "yes"), int(policy in job.policies)) for policy in POLICIES
        ]
    return rows


def changed(job: Job, row: int, step: int) -> Job:
    """The job with the setting of a row moved on by ``step``."""
    setting = settings_of(job)[row]
    value = setting.values[(setting.at + step) % len(setting.values)]
    match setting.name:
        case "Do":
            return replace(job, kind=value)
        case "Noise":
            return replace(job, noise=value)
        case "Dialogues":
            return replace(job, dialogues=int(value))
        case "Seed":
            return replace(job, seed=int(value))
        case "Tested in":
            return replace(job, held_out=ROOMS[value])
    wanted = {*job.policies, setting.name} if value == "yes" else {*job.policies} - {setting.name}
    return replace(job, policies=tuple(policy for policy in POLICIES if policy in wanted))


class Meanings(RowsView, can_focus=False):
    """What the settings mean, the one that the person stands on in view."""

    BORDER_TITLE = "What it means"

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._names: tuple[str, ...] = ()
        self._here, self._first = "", 0

    def explain(self, names: Sequence[str], here: str) -> None:
        """Say what the settings with ``names`` mean, above all the one called ``here``."""
        self._names, self._here = tuple(names), here
        self.show_once((self._names, here), self._drawn)

    def redrawn(self) -> None:
        """What is meant comes into view."""
        self.reveal(self._first, min(self._first + 4, len(self.rows) - 1))

    def _drawn(self, width: int) -> Sequence[Row]:
        rows: list[Row] = []
        for name in self._names:
            here = name == self._here
            if here:
                self._first = len(rows)
            spans = [Span(f"{name}: ", "accent" if here else "muted")]
            rows += wrapped([*spans, Span(SETTINGS[name], "text" if here else "muted")], width, 2)
        return rows


class LabSettings(RowsView):
    """Up and Down choose a row, Left and Right change it, Enter starts."""

    HELP = (
        "What the lab is to do. Train: the robot learns what to ask, on the bundled lessons, and "
        "its weights are saved. Compare: each policy is taught the same lessons and tested in "
        "rooms that it has not seen. Up and Down choose a row, Left, Right and Space change it, "
        "Enter starts."
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "row(-1)", "Setting before", show=False),
        Binding("down", "row(1)", "Next setting", show=False),
        Binding("left", "change(-1)", "Other value", show=False),
        Binding("right,space", "change(1)", "Change", show=False),
        Binding("enter", "start", "Start"),
    ]

    class Reached(Message):
        """The person stands on the setting with this name, among those of ``job``."""

        def __init__(self, setting: str, job: Job) -> None:
            super().__init__()
            self.setting, self.job = setting, job

    class Started(Message):
        """The person wants this done."""

        def __init__(self, job: Job) -> None:
            super().__init__()
            self.job = job

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self.job = Job()
        self._row = 0

    def on_mount(self) -> None:
        """Draw them."""
        self.border_title = "What to do"
        self._redraw_all()

    @property
    def setting(self) -> str:
        """The name of the setting that the person stands on."""
        return settings_of(self.job)[self._row].name

    def action_row(self, step: int) -> None:
        """Another row."""
        self._row = (self._row + step) % len(settings_of(self.job))
        self._redraw_all()

    def action_change(self, step: int) -> None:
        """Another value in this row."""
        self.job = changed(self.job, self._row, step)
        self._redraw_all()

    def take(self, job: Job) -> None:
        """Show the settings of ``job``."""
        self.job, self._row = job, 0
        self._redraw_all()

    def action_start(self) -> None:
        """Go."""
        if self.job.kind == TRAIN or self.job.policies:
            self.post_message(self.Started(self.job))
        else:
            self.notify("Choose at least one policy to compare.", severity="warning")

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click changes a row, or starts."""
        message.stop()
        self.focus()
        if message.target == START:
            self.action_start()
            return
        self._row = int(message.target)
        self.action_change(1)

    def _redraw_all(self) -> None:
        self.show(self._drawn)
        self.reveal(self._row)
        self.post_message(self.Reached(self.setting, self.job))

    def redrawn(self) -> None:
        """As high as its rows, and two for the frame; a style may bound it."""
        self.styles.height = len(self.rows) + 2

    def _drawn(self, width: int) -> Sequence[Row]:
        rows = [self._setting(n, one, width) for n, one in enumerate(settings_of(self.job))]
        return [*rows, (), clipped([Span(" Enter ", "cursor", START), Span(" start")], width)]

    def _setting(self, number: int, setting: _Setting, width: int) -> Row:
        here = number == self._row
        value = f"◂ {setting.values[setting.at]} ▸" if here else f"  {setting.values[setting.at]}"
        lead = "› " if here else "  "
        spans = [
            Span(f"{lead}{setting.name:11}", "strong" if here else "muted", str(number)),
            Span(value, "accent" if here else "text", str(number)),
        ]
        return padded(clipped(spans, width), width)
