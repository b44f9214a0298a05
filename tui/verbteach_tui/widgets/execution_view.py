"""Watching an execution: step by step, at a speed the person sets, with a stop at any step."""

from __future__ import annotations

from dataclasses import replace
from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.timer import Timer

from verbteach_tui.messages import StepShown, TargetPicked, WordSaid
from verbteach_tui.views.execution import Playback, playback_rows
from verbteach_tui.widgets.rows_view import RowsView

STEERING = ("stop", "pause", "to_end", "faster", "slower", "forward", "back")
"""The words of buttons that steer what is watched."""


class ExecutionView(RowsView):
    """Steps with their state; runs by itself until paused, stopped or over."""

    HELP = (
        "The robot at work. Space pauses and goes on, the Right and Left arrows go a step "
        "forward or back, e shows the end, + and - change the speed, x stops the robot after the "
        "step being shown. Click a step to see the scene as it was then."
    )
    BORDER_TITLE = "What the robot does"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("space", "pause", "Pause or go on", show=False),
        Binding("right", "forward", "One step on", show=False),
        Binding("left", "back", "One step back", show=False),
        Binding("e,end", "to_end", "To the end", show=False),
        Binding("plus,equals_sign", "speed(1)", "Faster", show=False),
        Binding("minus", "speed(-1)", "Slower", show=False),
        Binding("x", "stop", "Stop the robot here", show=False),
    ]

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._playback = Playback(())
        self._timer: Timer | None = None
        self._finished = True

    @property
    def playback(self) -> Playback:
        """How far it has come."""
        return self._playback

    @property
    def running(self) -> bool:
        """Whether there are steps that were not shown yet."""
        return not self._finished

    def play(self, playback: Playback) -> None:
        """Show an execution from its beginning; at speed 0, its end at once."""
        self._finished = False
        self._set(playback if playback.speed else playback.to_end())

    def show_over(self, playback: Playback) -> None:
        """Show an execution that was watched before."""
        self._finished = True
        self._set(playback.to_end())

    def steer(self, word: str) -> None:
        """Do what the button with one of the ``STEERING`` words does."""
        if word in ("faster", "slower"):
            self.action_speed(1 if word == "faster" else -1)
        else:
            {
                "stop": self.action_stop,
                "pause": self.action_pause,
                "to_end": self.action_to_end,
                "forward": self.action_forward,
                "back": self.action_back,
            }[word]()

    def action_pause(self) -> None:
        """Stand still, or go on."""
        if not self._playback.over:
            self._set(replace(self._playback, playing=not self._playback.playing))

    def action_forward(self) -> None:
        """One step on, standing still."""
        self._set(replace(self._playback.forward(), playing=False))

    def action_back(self) -> None:
        """One step back, standing still."""
        self._set(self._playback.back())

    def action_to_end(self) -> None:
        """All that is left at once."""
        self._set(self._playback.to_end())

    def action_speed(self, by: int) -> None:
        """Faster or slower."""
        playback = self._playback.faster(by)
        self._set(playback if playback.speed else playback.to_end())

    def action_stop(self) -> None:
        """Stop the robot after the step being shown."""
        if self.running:
            self.post_message(WordSaid(f"stop: {self._playback.at}", "key"))

    def on_target_picked(self, message: TargetPicked) -> None:
        """A click on a step shows the scene after it."""
        message.stop()
        self._set(replace(self._playback, at=int(message.target), playing=False))

    def _set(self, playback: Playback) -> None:
        self._playback = playback
        if self._timer is not None:
            self._timer.stop()
            self._timer = None
        if playback.over:
            self._finished = True
        elif playback.playing and playback.speed:
            self._timer = self.set_timer(1 / playback.speed, self._advance)
        self.show(lambda width: playback_rows(playback, width))
        if playback.at:
            self.reveal(playback.at)
        self.post_message(StepShown(playback.at, self._finished))

    def _advance(self) -> None:
        self._set(self._playback.forward())
