"""The steps shown so far: look at each, take one away, put one elsewhere, insert, run them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.timer import Timer

from verbteach.dialogue import acts
from verbteach_tui.messages import ActPicked, InsertionMoved, StepLooked, TargetPicked
from verbteach_tui.views.recorder import step_rows
from verbteach_tui.views.rows import Row
from verbteach_tui.widgets.rows_view import RowsView


class StepsView(RowsView):
    """A cursor among the steps; the next step comes at the end unless it is put elsewhere."""

    HELP = (
        "The steps you have shown. Up and Down go from step to step, and the scene shows the "
        "world after each. x takes the step away, X that one and all after it, e puts it one "
        "earlier, l one later. i lets the next step come before it; i at the end, or Escape, puts "
        "it back to the end. Space runs the steps from here. Right goes back to the lists."
    )
    BORDER_TITLE = "Steps"
    OWN_KEYS = "xXeli "
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "go(-1)", "Step before", show=False),
        Binding("down", "go(1)", "Next step", show=False),
        Binding("home", "go(-99)", "First step", show=False),
        Binding("end", "go(99)", "The end", show=False),
        Binding("x,delete", "steer('remove_step')", "Take the step away", show=False),
        Binding("X", "steer('remove_rest')", "Take it and all after it away", show=False),
        Binding("e", "steer('earlier')", "One earlier", show=False),
        Binding("l", "steer('later')", "One later", show=False),
        Binding("i", "steer('insert_here')", "Insert before it", show=False),
        Binding("escape", "steer('at_end')", "Go on at the end", show=False),
        Binding("space", "steer('run_steps')", "Run from here", show=False),
    ]

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._steps: tuple[str, ...] = ()
        self._cursor = self._at = 0
        self._follow: int | None = None
        self._starts: list[int] = []
        self._timer: Timer | None = None
        self.speed = 2.0

    @property
    def at(self) -> int | None:
        """The number that the next step gets, from 1; ``None`` where it comes at the end."""
        return self._at + 1 if self._at < len(self._steps) else None

    @property
    def cursor(self) -> int:
        """The step under the cursor, from 0; the number of steps is the end."""
        return self._cursor

    @property
    def running(self) -> bool:
        """Whether the steps are being run."""
        return self._timer is not None

    def show_steps(self, steps: Sequence[str]) -> None:
        """Show the steps as they now are; the cursor follows what was moved or inserted."""
        self._halt()
        before, self._steps = len(self._steps), tuple(steps)
        grown = len(steps) - before
        if grown > 0 and self._at < before:
            self._at += grown
            self._cursor = self._at
        elif grown > 0 or self._at >= before:
            self._at = len(steps)
            self._cursor = len(steps) if grown > 0 else min(self._cursor, len(steps))
        if self._follow is not None and grown == 0:
            self._cursor = self._follow
        self._follow = None
        self._at = min(self._at, len(steps))
        self._cursor = min(self._cursor, len(steps))
        self._draw_steps()

    def steer(self, word: str) -> None:
        """Do what the key or button with one of the ``EDITING`` words does."""
        self._halt()
        _STEER[word](self)

    def action_steer(self, word: str) -> None:
        """Do what a key does."""
        self.steer(word)

    def action_go(self, by: int) -> None:
        """Another step: the scene shows the world after it."""
        self._halt()
        self._look(min(max(self._cursor + by, 0), len(self._steps)))

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a step goes to it."""
        message.stop()
        self._halt()
        self._look(int(message.target))

    def watch_has_focus(self, has_focus: bool) -> None:
        """Show the cursor, or hide it."""
        super().watch_has_focus(has_focus)
        self._draw_steps()

    def _remove_step(self) -> None:
        if self._cursor < len(self._steps):
            self.post_message(ActPicked(acts.Remove(self._cursor + 1, self._cursor + 1)))

    def _remove_rest(self) -> None:
        if self._cursor < len(self._steps):
            self.post_message(ActPicked(acts.Remove(self._cursor + 1, len(self._steps))))

    def _earlier(self) -> None:
        self._move(self._cursor - 1)

    def _later(self) -> None:
        self._move(self._cursor + 1)

    def _move(self, to: int) -> None:
        if self._cursor < len(self._steps) and 0 <= to < len(self._steps):
            self._follow = to
            self.post_message(ActPicked(acts.Move(self._cursor + 1, to + 1)))

    def _insert_here(self) -> None:
        self._at = self._cursor
        self._draw_steps()
        self.post_message(InsertionMoved())

    def _go_on_at_end(self) -> None:
        self._at = len(self._steps)
        self._look(len(self._steps))
        self.post_message(InsertionMoved())

    def _run_steps(self) -> None:
        if not self.speed:
            self._look(len(self._steps))
            return
        self._look(-1 if self._cursor >= len(self._steps) else self._cursor)
        self._timer = self.set_interval(1 / self.speed, self._advance)

    def _advance(self) -> None:
        if self._cursor >= len(self._steps) - 1:
            self._halt()
        self._look(min(self._cursor + 1, len(self._steps)))

    def _halt(self) -> None:
        if self._timer is not None:
            self._timer.stop()
            self._timer = None

    def _look(self, cursor: int) -> None:
        """Go to a step; -1 is before the first one."""
        self._cursor = cursor
        self._draw_steps()
        self.post_message(StepLooked(min(cursor + 1, len(self._steps))))

    def _draw_steps(self) -> None:
        self.show(self._drawn)
        at = max(self._cursor, 0)
        if at < len(self._starts):  # Out of sight nothing is drawn: these are of fewer steps.
            self.reveal(self._starts[at])

    def _drawn(self, width: int) -> Sequence[Row]:
        rows: list[Row] = []
        self._starts = []
        for part in step_rows(self._steps, self._cursor, self._at, width, self.has_focus):
            self._starts.append(len(rows))
            rows += part
        return rows


_STEER: Mapping[str, Callable[[StepsView], None]] = {
    "remove_step": StepsView._remove_step,
    "remove_rest": StepsView._remove_rest,
    "earlier": StepsView._earlier,
    "later": StepsView._later,
    "insert_here": StepsView._insert_here,
    "at_end": StepsView._go_on_at_end,
    "run_steps": StepsView._run_steps,
}

EDITING = tuple(_STEER)
"""The words of buttons that edit a demonstration."""
