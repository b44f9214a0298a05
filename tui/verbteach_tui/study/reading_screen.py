"""A text to read and a choice to make: consent, instructions, what comes next, the thanks."""

from __future__ import annotations

from collections.abc import Sequence
from time import monotonic
from typing import ClassVar, NamedTuple

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Center, Horizontal, Vertical
from textual.message import Message
from textual.screen import Screen
from textual.widgets import Button

from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.rows_view import RowsView
from verbteach_tui.widgets.title_bar import TitleBar

TOO_SOON = 0.3
"""Seconds in which nobody can have read anything: keys are left over from what was before."""

_BESIDE = 4
"""Rows of the screen that are not for the text."""


class Choice(NamedTuple):
    """A button: the word it stands for, its key, what it says."""

    word: str
    key: str
    label: str


GO_ON = Choice("next", "enter", "Go on")


class Page(RowsView):
    """Text that takes as many rows as it needs, as far as there are so many."""

    def redrawn(self) -> None:
        """Two more for the frame, and below it the buttons."""
        self.styles.height = min(len(self.rows) + 2, max(self.app.size.height - _BESIDE, 4))
        self._say_whether_more()

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        """Say in the frame whether there is more to read."""
        super().watch_scroll_y(old_value, new_value)
        self._say_whether_more()

    def on_resize(self, event: events.Resize) -> None:
        """Another height leaves another part of the text in view."""
        room = max(self.app.size.height - _BESIDE, 4)
        self.styles.height = min(len(self.rows) + 2, room)
        self.call_after_refresh(self._say_whether_more)

    def _say_whether_more(self) -> None:
        below = len(self.rows) - self.scroll_offset.y - self.scrollable_content_region.height
        self.border_subtitle = "more below: ↓" if below > 0 and self.is_attached else ""


class ReadingScreen(Screen[None]):
    """Paragraphs in the middle of the screen, buttons below them; each has a key."""

    HELP = "Read the text; the arrow keys scroll it. Then choose with a key or a button."
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("tab", "app.focus_next", "Next", show=False),
    ]

    class Chosen(Message):
        """The participant chose."""

        def __init__(self, word: str) -> None:
            super().__init__()
            self.word = word

    def __init__(
        self, title: str, heading: str, text: str, choices: Sequence[Choice] = (GO_ON,)
    ) -> None:
        super().__init__()
        self._title, self._heading, self._text = title, heading, text
        self._choices = tuple(choices)
        self._shown = float("inf")
        for choice in choices:
            self._bindings.bind(choice.key, f"choose('{choice.word}')", choice.label)

    def compose(self) -> ComposeResult:
        """The text and the buttons."""
        yield TitleBar()
        with Center(id="page"), Vertical(id="sheet"):
            yield Page(id="text")
            with Horizontal(id="choices"):
                for choice in self._choices:
                    yield Button(choice.label, id=choice.word, compact=True)
        yield Foot()

    def on_mount(self) -> None:
        """Show the text; it has the keys, so that it can be scrolled."""
        self.query_one(TitleBar).show_title(visible(self._title))
        text = self.query_one("#text", Page)
        text.border_title = visible(self._heading)
        text.show(self._drawn)
        text.focus()
        self.call_after_refresh(self._come_into_view)

    def _come_into_view(self) -> None:
        self._shown = monotonic()

    @property
    def keys(self) -> frozenset[str]:
        """The keys that choose."""
        return frozenset(choice.key for choice in self._choices)

    def _drawn(self, width: int) -> list[Row]:
        rows: list[Row] = []
        for line in self._text.splitlines():
            rows += wrapped([Span(visible(line))], width) if line.strip() else [()]
        return rows

    def on_button_pressed(self, event: Button.Pressed) -> None:
        """A button."""
        event.stop()
        self.action_choose(event.button.id or "")

    @property
    def is_readable(self) -> bool:
        """Whether it has been in view for long enough to choose."""
        return monotonic() - self._shown >= TOO_SOON

    def action_choose(self, word: str) -> None:
        """Say what was chosen, once, and not before it can be seen."""
        if not self.is_readable:
            return
        for button in self.query(Button):
            if button.disabled:
                return
            button.disabled = True
        self.post_message(self.Chosen(word))

    def again(self) -> None:
        """What was chosen came to nothing; choose anew."""
        for button in self.query(Button):
            button.disabled = False
