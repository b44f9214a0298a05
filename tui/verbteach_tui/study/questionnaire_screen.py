"""The closing questionnaire: scales to mark, questions to answer freely, and one button."""

from __future__ import annotations

from time import monotonic
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import VerticalScroll
from textual.message import Message
from textual.screen import Screen
from textual.widgets import Button, Static, TextArea

from verbteach_sessions.study.questionnaire import Questionnaire
from verbteach_tui.study import words
from verbteach_tui.study.rating_bar import RatingBar
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.title_bar import TitleBar


class QuestionnaireScreen(Screen[None]):
    """Everything on one page, in the order in which it is asked; nothing must be answered."""

    HELP = (
        "A questionnaire. Tab goes from one question to the next; leave out what you like. "
        "The button at the end, or F9, sends it off."
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("tab", "app.focus_next", "Next question"),
        Binding("f9", "send", "Send"),
    ]

    class Sent(Message):
        """The participant is done; ``seconds`` is how long it took."""

        def __init__(self, answers: dict[str, int | str | None], seconds: float) -> None:
            super().__init__()
            self.answers, self.seconds = answers, seconds

    def __init__(self, title: str, asked: Questionnaire) -> None:
        super().__init__()
        self._title, self._asked = title, asked
        self._shown_at = 0.0
        self._sent = False

    def compose(self) -> ComposeResult:
        """The page."""
        yield TitleBar()
        with VerticalScroll(id="questions", can_focus=False):
            yield Static(words.TLX, id="lead", markup=False)
            for scale in self._asked.scales:
                yield RatingBar(scale)
            for question in self._asked.questions:
                area = TextArea(id=question.id, show_line_numbers=False, tab_behavior="focus")
                area.border_title = visible(question.text)
                yield area
            yield Button("Send", id="send", variant="primary", compact=True)
        yield Foot()

    def on_mount(self) -> None:
        """The first question has the keys, as the base class sees to."""
        self._shown_at = monotonic()
        self.query_one(TitleBar).show_title(visible(self._title))

    def on_resize(self) -> None:
        """The question with the keys stays in view, and what stands above the first one with it."""
        page = self.query_one("#questions", VerticalScroll)
        if self.focused is None:
            return
        if self.focused in page.children[:2]:
            self.call_after_refresh(page.scroll_home, animate=False)
        else:
            self.call_after_refresh(self.focused.scroll_visible, animate=False)

    def on_button_pressed(self, event: Button.Pressed) -> None:
        """Done."""
        event.stop()
        self.action_send()

    def action_send(self) -> None:
        """Hand the answers over, once."""
        if self._sent:
            return
        self._sent = True
        answers: dict[str, int | str | None] = {}
        for bar in self.query(RatingBar):
            answers[bar.scale.id] = bar.value
        for area in self.query(TextArea):
            answers[area.id or ""] = area.text
        self.post_message(self.Sent(answers, monotonic() - self._shown_at))

    def again(self) -> None:
        """They could not be kept; they can be sent anew."""
        self._sent = False
