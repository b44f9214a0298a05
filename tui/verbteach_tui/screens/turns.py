"""Picking a turn to go back to, or forward again to one that was taken back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import OptionList, Static
from textual.widgets.option_list import Option

from verbteach_tui.turns import TurnChoice
from verbteach_tui.widgets.foot import Foot

UNDOING = (
    "Enter goes there: what came after it is taken back, and ↷ can be done again. Nothing is lost "
    "from the record."
)
LOOKING = "Enter goes there."


class TurnPicker(ModalScreen[int | None]):
    """Answers with the number of acts to undo (below 0: to redo), or ``None`` to stay."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,f8", "stay", "Stay here")]
    HELP = (
        "What you said, in order. Choose where to go back to: all that you said after it is taken "
        "back, and can be done again from here until you say something else."
    )

    def __init__(self, turns: Sequence[TurnChoice], advice: str = UNDOING) -> None:
        super().__init__()
        self._turns, self._advice = tuple(turns), advice

    def compose(self) -> ComposeResult:
        """The turns and what choosing one does."""
        with Vertical(classes="dialog -large") as dialog:
            dialog.border_title = "Go to right after …"
            yield OptionList(*map(_option, self._turns), id="turns", compact=True)
            yield Static(self._advice, classes="quiet")
        yield Foot()

    def on_mount(self) -> None:
        """Begin at the turn on the screen."""
        turns = self.query_one("#turns", OptionList)
        here = next(i for i, turn in enumerate(self._turns) if turn.undone == 0)
        turns.highlighted = here
        turns.focus()

    def on_resize(self) -> None:
        """The turn under the cursor is in view at every size."""
        self.call_after_refresh(self.query_one("#turns", OptionList).scroll_to_highlight)

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """Go there."""
        self.dismiss(self._turns[message.option_index].undone)

    def action_stay(self) -> None:
        """Stay."""
        self.dismiss(None)


def _option(turn: TurnChoice) -> Option:
    sign = "▸" if turn.undone == 0 else "↷" if turn.undone < 0 else " "
    return Option(Content(f"{sign} {turn.number:3}  {turn.text}"), id=str(turn.number))
