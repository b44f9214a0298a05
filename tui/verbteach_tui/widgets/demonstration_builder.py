"""Showing the robot what to do: pick an action, then only objects that fit, one after the other.

Beside the lists stand the steps so far, which can be edited, and what they have changed.
"""

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
from verbteach_tui.messages import InsertionMoved, StepChosen
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.views.recorder import change_rows
from verbteach_tui.views.rows import Row, Span, clipped, wrapped
from verbteach_tui.views.steps import Choice, StepMenu
from verbteach_tui.widgets.rows_view import RowsView
from verbteach_tui.widgets.steps_view import StepsView

_NOT_YET = "not possible yet"


class DemonstrationBuilder(Vertical):
    """Two lists, the steps so far, and what they have changed."""

    HELP = (
        "Show the robot what to do. Choose an action with the arrow keys and Enter, then the "
        "objects it is about: only those that fit are listed. What cannot be done now stands at "
        "the end, with the reason. Left goes back, and from the actions to the steps so far, where "
        "they are edited; / lets you type instead, u takes back what you did last, d ends the "
        "demonstration."
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
        & #so-chosen {
            height: auto; max-height: 3; overflow-y: hidden; scrollbar-gutter: auto;
        }
        & #record { height: 45%; border-top: solid $rule; }
        & #steps { width: 1fr; height: 1fr; }
        & #changed { width: 1fr; height: 1fr; border-left: vkey $rule; }
    }
    """

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._snapshot: Snapshot | None = None
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
        with Horizontal(id="record"):
            yield StepsView(id="steps")
            yield RowsView(id="changed")

    def show_snapshot(self, snapshot: Snapshot, speed: float) -> None:
        """Offer what can be done now; tell the steps so far and what they have changed."""
        self._snapshot = snapshot
        self.steps.speed = speed
        self.steps.show_steps(snapshot.shown)
        changes, problem, count = snapshot.change, snapshot.problem, len(snapshot.shown)
        self.query_one("#changed", RowsView).show(
            lambda width: change_rows(changes, problem, count, width)
        )
        self.on_insertion_moved()

    def on_insertion_moved(self, message: InsertionMoved | None = None) -> None:
        """Offer what can be done where the next step comes."""
        if message is not None:
            message.stop()
        if self._snapshot is None:
            return
        at, moments = self.steps.at, self._snapshot.shown_moments
        menu = self._snapshot.menu
        self._menu = menu if at is None else menu.after(moments[at - 1].state)
        with self.prevent(OptionList.OptionHighlighted):  # what fits it is offered below
            _fill(self.query_one("#actions", OptionList), self._menu.names)
        self._restart()
        if at is not None and message is not None:
            self.take_focus()

    @property
    def steps(self) -> StepsView:
        """The steps so far."""
        return self.query_one(StepsView)

    @property
    def editing(self) -> bool:
        """Whether the keys edit the steps."""
        return self.steps.has_focus

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
        """Show what fits the action under the cursor before it is chosen, or why it cannot be."""
        message.stop()
        if message.option_list.id == "actions" and message.option_id and not self._chosen:
            self._action = message.option_id
            self._offer_objects()
        elif message.option_list.id == "objects" and message.option_list.has_focus:
            self._tell(message.option_id)

    def action_back(self) -> None:
        """One choice back."""
        if self._chosen:
            self._chosen = self._chosen[:-1]
            self._offer_objects()
        elif self.query_one("#actions").has_focus:
            self.steps.focus()
        else:
            self.query_one("#actions").focus()

    def action_forward(self) -> None:
        """Choose what is under the cursor, or go from the steps to the lists."""
        focused = self.screen.focused
        if isinstance(focused, OptionList):
            focused.action_select()
        elif self.editing:
            self.take_focus()

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
        with self.prevent(OptionList.OptionHighlighted):  # it is told about right here
            _fill(objects, self._menu.objects(self._action, self._chosen))
        highlighted = objects.highlighted_option
        self._tell(highlighted.id if highlighted else None)

    def _tell(self, object_id: str | None) -> None:
        """Say what is being put together, and why it cannot be done with ``object_id``."""
        if self._menu is None:
            return
        prompt = self._menu.prompt(self._action, self._chosen)
        whole = (*self._chosen, object_id) if object_id else self._chosen
        why = self._menu.why_not(self._action, whole) if self.has_focus_within else ""
        self.query_one("#so-chosen", RowsView).show(lambda width: _told(prompt, why, width))


def _told(prompt: str, why: str, width: int) -> list[Row]:
    rows = [clipped([Span(prompt, "accent")], width)]
    return rows + (
        wrapped([Span(f"{_NOT_YET}: {why}")], width, 2, [Span("✗ ", "bad")]) if why else []
    )


def _fill(options: OptionList, choices: Sequence[Choice]) -> None:
    """List the choices, the possible ones first, with a line before those that are not."""
    highlighted = options.highlighted_option
    wanted = highlighted.id if highlighted else None
    rows: list[Option | None] = []
    for choice in choices:
        if not choice.possible and not any(o and o.prompt == _NOT_YET for o in rows):
            rows.append(Option(_NOT_YET, disabled=True))
        glyph = "" if choice.possible else "· "
        rows.append(Option(Content(glyph + choice.label), id=choice.id))
    options.set_options(rows)
    ids = [option.id if option else None for option in rows]
    first = next((i for i, option in enumerate(rows) if option and not option.disabled), None)
    options.highlighted = ids.index(wanted) if wanted in ids and wanted else first
