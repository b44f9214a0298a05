"""Showing the robot what to do: pick an action, then only objects that fit, one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from verbteach.world.plan import Action
from verbteach_tui.messages import StepChosen
from verbteach_tui.views.rows import Row, Span, clipped, wrapped
from verbteach_tui.views.steps import Choice, StepMenu
from verbteach_tui.widgets.rows_view import RowsView

_NOT_NOW = "not possible now"


class DemonstrationBuilder(Vertical):
    """Two lists, and below them the steps so far and what they have changed."""

    HELP = (
        "Show the robot what to do. Choose an action with the arrow keys and Enter, then the "
        "objects it is about: only those that fit are listed. What cannot be done now stands at "
        "the end; try it, and the robot says why not. Left goes back, / lets you type instead, "
        "u takes the last step back, d ends the demonstration."
    )
    BORDER_TITLE = "Show the robot"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left,backspace", "back", "Back", show=False),
        Binding("right", "forward", "Choose", show=False),
    ]
    DEFAULT_CSS = """
    DemonstrationBuilder {
        & #lists { height: 1fr; }
        & OptionList {
            border: none; background: transparent; padding: 0 1; height: 1fr;
            scrollbar-size-vertical: 1;
        }
        & #actions { width: 2fr; }
        & #filling { width: 3fr; border-left: vkey $rule; }
        & #so-chosen { height: 1; overflow-y: hidden; scrollbar-gutter: auto; }
        & #so-far { height: auto; max-height: 40%; border-top: solid $rule; }
    }
    """

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._menu: StepMenu | None = None
        self._action = ""
        self._chosen: tuple[str, ...] = ()

    def compose(self) -> ComposeResult:
        """The lists and what was shown so far."""
        with Horizontal(id="lists"):
            yield OptionList(id="actions", compact=True)
            with Vertical(id="filling"):
                yield RowsView(id="so-chosen")
                yield OptionList(id="objects", compact=True)
        yield RowsView(id="so-far")

    def show_menu(
        self, menu: StepMenu, steps: Sequence[str], change: Sequence[str], problem: str = ""
    ) -> None:
        """Offer what ``menu`` has; tell the ``steps`` so far and their whole ``change``.

        ``problem`` is why what was tried last cannot be done.
        """
        self._menu = menu
        with self.prevent(OptionList.OptionHighlighted):  # what fits it is offered below
            _fill(self.query_one("#actions", OptionList), menu.names)
        self._restart()
        self.query_one("#so-far", RowsView).show(
            lambda width: _so_far(steps, change, problem, width), at_end=True
        )

    def take_focus(self) -> None:
        """Put the keys where the next step begins."""
        self.query_one("#actions").focus()

    @property
    def has_keys(self) -> bool:
        """Whether one of the lists has the focus."""
        return self.has_focus_within

    def offer(self, object_id: str) -> None:
        """An object was clicked in the scene: take it where it fits the place being filled."""
        if self._menu and self._action:
            choices = self._menu.objects(self._action, self._chosen)
            if any(choice.id == object_id for choice in choices):
                self._choose(object_id)

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """An action or an object was chosen."""
        message.stop()
        chosen = message.option_id
        if chosen is None or self._menu is None:
            return
        if message.option_list.id == "actions":
            self._begin(chosen)
        else:
            self._choose(chosen)

    def on_option_list_option_highlighted(self, message: OptionList.OptionHighlighted) -> None:
        """Show what fits the action under the cursor before it is chosen."""
        message.stop()
        if message.option_list.id == "actions" and message.option_id and not self._chosen:
            self._action = message.option_id
            self._offer_objects()

    def action_back(self) -> None:
        """One choice back."""
        if self._chosen:
            self._chosen = self._chosen[:-1]
            self._offer_objects()
        else:
            self.query_one("#actions").focus()

    def action_forward(self) -> None:
        """Choose what is under the cursor."""
        focused = self.screen.focused
        if isinstance(focused, OptionList):
            focused.action_select()

    def _begin(self, name: str) -> None:
        self._action, self._chosen = name, ()
        if self._menu and not self._menu.objects(name):
            self._finish()
            return
        self._offer_objects()
        self.query_one("#objects").focus()

    def _choose(self, object_id: str) -> None:
        self._chosen = (*self._chosen, object_id)
        if self._menu and self._menu.objects(self._action, self._chosen):
            self._offer_objects()
            self.query_one("#objects").focus()
        else:
            self._finish()

    def _finish(self) -> None:
        action = Action(self._action, self._chosen)
        self._restart()
        if self.has_focus_within:
            self.query_one("#actions").focus()
        self.post_message(StepChosen(action))

    def _restart(self) -> None:
        self._chosen = ()
        highlighted = self.query_one("#actions", OptionList).highlighted_option
        self._action = highlighted.id or "" if highlighted else ""
        self._offer_objects()

    def _offer_objects(self) -> None:
        objects = self.query_one("#objects", OptionList)
        if self._menu is None or not self._action:
            objects.clear_options()
            return
        _fill(objects, self._menu.objects(self._action, self._chosen))
        prompt = self._menu.prompt(self._action, self._chosen)
        self.query_one("#so-chosen", RowsView).show(
            lambda width: [clipped([Span(prompt, "accent")], width)]
        )


def _fill(options: OptionList, choices: Sequence[Choice]) -> None:
    """List the choices, the possible ones first, with a line before those that are not."""
    highlighted = options.highlighted_option
    wanted = highlighted.id if highlighted else None
    rows: list[Option | None] = []
    for choice in choices:
        if not choice.possible and not any(o and o.prompt == _NOT_NOW for o in rows):
            rows.append(Option(_NOT_NOW, disabled=True))
        glyph = "" if choice.possible else "· "
        rows.append(Option(Content(glyph + choice.label), id=choice.id))
    options.set_options(rows)
    ids = [option.id if option else None for option in rows]
    first = next((i for i, option in enumerate(rows) if option and not option.disabled), None)
    options.highlighted = ids.index(wanted) if wanted in ids and wanted else first


def _so_far(steps: Sequence[str], change: Sequence[str], problem: str, width: int) -> list[Row]:
    rows: list[Row] = []
    if not steps:
        rows += wrapped([Span("Nothing shown yet.", "muted")], width)
    else:
        count = f"{len(steps)} step{'s' * (len(steps) != 1)}, last: "
        rows += wrapped([Span(count, "muted"), Span(steps[-1])], width, 2)
        if not change:
            rows += wrapped([Span("Nothing is different so far.", "muted")], width)
    for text in change:
        rows += wrapped([Span(text)], width, 2, [Span("✱ ", "new")])
    if problem:
        rows += wrapped([Span(problem)], width, 2, [Span("✗ ", "bad")])
    return rows
