"""The line the person types in: a history of what was said, and completion where there is any."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.suggester import Suggester
from textual.widgets import Input

from verbteach_tui.messages import LineTyped


class CommandInput(Input):
    """An input that keeps what was said before; Up and Down go through it.

    Where it ``stays``, Escape does not leave it: a command is typed nowhere else,
    and its first letters would be taken for keys.
    """

    HELP = (
        "Type here and press Enter. Up and Down bring back what you said before; the Right arrow "
        "takes the completion shown in grey. Tab leaves the line, and single keys answer then; so "
        "does Escape where the robot has asked something."
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "earlier", "Earlier", show=False),
        Binding("down", "later", "Later", show=False),
        Binding("escape", "leave", "Leave the line", show=False),
    ]

    def __init__(self, *, id: str | None = None) -> None:
        self._completion = _Completion()
        super().__init__(id=id, suggester=self._completion, select_on_focus=False)
        self._said: list[str] = []
        self._back = 0
        self._wanted = self._example = ""
        self.stays = False
        self.elsewhere: Callable[[events.Key], bool] = lambda event: False

    def expect(self, wanted: str, example: str, complete: Callable[[str], str | None]) -> None:
        """Say what is wanted, with an ``example`` for who is elsewhere; and how it is completed."""
        self._wanted, self._example = wanted, example
        self._completion.complete = complete
        self.say_what_is_wanted()

    def say_what_is_wanted(self) -> None:
        """What to type, or how to come here; for subclasses too."""
        away = f"Tab or / to type, as in: {self._example}"
        self.placeholder = self._wanted if self.has_focus else away

    def watch_has_focus(self, has_focus: bool) -> None:
        """Say what to type, or how to come back."""
        super().watch_has_focus(has_focus)
        self.say_what_is_wanted()

    def on_key(self, event: events.Key) -> None:
        """No line begins with the key that leads to this one: pressed once more it does nothing.

        Nor does one begin with the rest of a word whose first letter has answered.
        """
        if (event.character == "/" and not self.value) or self.elsewhere(event):
            event.prevent_default()
            event.stop()

    def on_paste(self, event: events.Paste) -> None:
        """All of what is pasted goes in."""
        event.stop()
        event.prevent_default()
        self.take_in(event.text)

    def take_in(self, text: str) -> None:
        """Put text in at the cursor, its lines one after the other in this one.

        Without what no key could type: a terminal would take it for orders.
        """
        lines = ("".join(filter(str.isprintable, line)).strip() for line in text.splitlines())
        self.replace(", ".join(filter(None, lines)), *self.selection)

    def on_input_submitted(self, message: Input.Submitted) -> None:
        """Hand the line on. It stays until it is sent, so that nothing typed is lost."""
        message.stop()
        if message.value.strip():
            self.post_message(LineTyped(message.value))

    def sent(self) -> None:
        """The line is on its way: remember it and make room for the next one."""
        if not self._said or self._said[-1] != self.value:
            self._said.append(self.value)
        self._back = 0
        self.clear()

    def give_back(self, text: str) -> None:
        """The line was refused: put it back to be changed.

        Where something else was begun, Up brings it back.
        """
        if self.value:
            self._said.append(text)
        else:
            self.value = text
            self.cursor_position = len(text)

    def begin_with(self, text: str) -> None:
        """Put what was typed before this line was there in front of what is."""
        self.value = text + self.value
        self.cursor_position = len(self.value)

    def action_earlier(self) -> None:
        """Bring back what was said before."""
        self._recall(self._back + 1)

    def action_later(self) -> None:
        """Go forward again."""
        self._recall(self._back - 1)

    def action_leave(self) -> None:
        """Leave the line as it is, so that single keys answer; unless it is to stay."""
        if not self.stays:
            self.screen.set_focus(None)

    def _recall(self, back: int) -> None:
        if 0 < back <= len(self._said):
            self._back = back
            self.value = self._said[-back]
            self.cursor_position = len(self.value)
        elif back <= 0 and self._back:
            self._back = 0
            self.clear()


class _Completion(Suggester):
    """Asks whatever completes at the moment."""

    def __init__(self) -> None:
        super().__init__(use_cache=False, case_sensitive=True)
        self.complete: Callable[[str], str | None] = lambda text: None

    async def get_suggestion(self, value: str) -> str | None:
        return self.complete(value)
