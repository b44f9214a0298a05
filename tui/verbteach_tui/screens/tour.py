"""The tour: what is where in the teaching room, one panel after the other, in a minute or so."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, NamedTuple

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen

from verbteach_tui.messages import TargetPicked
from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.rows_view import RowsView

if TYPE_CHECKING:
    from verbteach_tui.screens.teach import TeachScreen


class Stop(NamedTuple):
    """A stop of the tour: ``panel`` is the id of what it speaks of, "" for nothing there yet."""

    panel: str
    title: str
    text: str


STOPS = (
    Stop(
        "line",
        "You teach a robot what verbs mean",
        "Type a command here, as you would say it: boil the water. Enter sends it. The robot asks "
        "to be shown a verb that it does not know.",
    ),
    Stop(
        "scene",
        "The room",
        "Each box is a piece of furniture with what is in and on it. Signs come with words: "
        "■ shut, ● on. ✱ marks what just changed. Click a thing to point at it. "
        "F7 puts beside it what the robot took the room for.",
    ),
    Stop(
        "",
        "Showing",
        "Type the steps in your own words, or choose from the lists; your steps and what they "
        "changed stand below. They can be inserted, moved, taken away and run. d says that you "
        "are done, and the robot reads back what it will keep: strike what does not matter.",
    ),
    Stop(
        "dialogue",
        "The dialogue",
        "What you and the robot said. Beside a question stand its kind and its price. The robot "
        "asks only where it is not sure; w asks it why.",
    ),
    Stop(
        "mind",
        "The robot's mind",
        "What it takes your words to mean, which goals it sees, the verbs it knows. F5 shows all "
        "that it has learned of a verb.",
    ),
    Stop(
        "keys",
        "Keys",
        "What you can say now, with one key and no Enter. A wrong key is cheap: u takes it back, "
        "F8 goes back further. / or Tab lets you type instead.",
    ),
    Stop(
        "",
        "That is all",
        "F1 explains whatever has the keys. Ctrl+P lists every action, this tour too. All that you "
        "say is kept: leave with F10 at any time and go on later.",
    ),
)
"""What is told, in order."""


class Told(RowsView, can_focus=False):
    """What is told at one stop; it takes as many rows as that needs."""

    def redrawn(self) -> None:
        """As high as its rows."""
        self.styles.height = len(self.rows)


class TourScreen(ModalScreen[None]):
    """A box that speaks of one panel after the other, which stands out meanwhile."""

    AUTO_FOCUS = None
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter,right,space", "go(1)", "Next"),
        Binding("left,backspace", "go(-1)", "Before"),
        Binding("escape", "leave", "Skip"),
    ]

    def __init__(self, room: TeachScreen) -> None:
        super().__init__()
        self._room, self._at = room, 0
        self._left = False

    @property
    def stop(self) -> Stop:
        """Where the tour is."""
        return STOPS[self._at]

    def compose(self) -> ComposeResult:
        """The box."""
        with Vertical(classes="dialog -tour", id="tour"):
            yield Told(id="told")
        yield Foot()

    def on_mount(self) -> None:
        """Begin."""
        self._show()

    def on_key(self, event: events.Key) -> None:
        """Who types instead of reading on is typing a command: it goes into the line."""
        letter = event.character or ""
        if (letter.isalpha() or self._left) and event.is_printable and self._room.type_on(letter):
            event.stop()
            event.prevent_default()
            self.action_leave()

    def action_go(self, by: int) -> None:
        """To another stop; after the last one the tour is over."""
        if self._at + by >= len(STOPS):
            self.action_leave()
            return
        self._at = max(self._at + by, 0)
        self._show()

    def action_leave(self) -> None:
        """Enough."""
        if self._left:
            return
        self._left = True
        self._stand_out("")
        self._room.choose_tab("dialogue")
        self.dismiss()

    def on_target_picked(self, message: TargetPicked) -> None:
        """A key was clicked."""
        message.stop()
        {"next": lambda: self.action_go(1), "skip": self.action_leave}[message.target]()

    def _show(self) -> None:
        stop = self.stop
        if stop.panel in ("dialogue", "scene", "mind"):
            self._room.choose_tab(stop.panel)
        self._stand_out(stop.panel)
        # The box leaves free what it speaks of.
        self.set_class(stop.panel in ("line", "keys"), "-above")
        self.query_one("#tour").border_title = f"Tour {self._at + 1} of {len(STOPS)}: {stop.title}"
        told = self.query_one(Told)
        told.show(lambda width: _rows(stop, self._at == len(STOPS) - 1, width))

    def _stand_out(self, panel: str) -> None:
        for word in {stop.panel for stop in STOPS if stop.panel}:
            self._room.query_one(f"#{word}").set_class(word == panel, "-toured")


def _rows(stop: Stop, last: bool, width: int) -> list[Row]:
    rows = wrapped([Span(stop.text)], width)
    onward = "begin" if last else "next"
    keys = [
        Span(" Enter ", "cursor", "next"), Span(f" {onward}", "text", "next"), Span("   "),
        Span(" Esc ", "cursor", "skip"), Span(" skip the tour", "text", "skip"),
    ]  # fmt: skip
    return [*rows, (), tuple(keys)]
