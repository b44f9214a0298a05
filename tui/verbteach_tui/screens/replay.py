"""A recorded session played back in the panels it was taught in: forwards, backwards, to a turn."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.timer import Timer

from verbteach_sessions.transcript import said_in
from verbteach_tui.keys import Key
from verbteach_tui.messages import TargetPicked, WordSaid
from verbteach_tui.observer import Observer
from verbteach_tui.past import Past
from verbteach_tui.screens.panels import TABS, PanelScreen
from verbteach_tui.screens.turns import LOOKING, TurnPicker
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.spoken import in_words
from verbteach_tui.turns import TurnChoice
from verbteach_tui.views.visible import shortened
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.key_bar import KeyBar

SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Turns a second that the keys go through."""

_KEYS = (
    Key("space", "play", "play"),
    Key("→", "forward", "next"),
    Key("←", "back", "before"),
    Key("g", "to", "to a turn"),
)
_MORE = (Key("+", "faster", "faster"), Key("-", "slower", "slower"), Key("e", "last", "the end"))


class ReplayScreen(PanelScreen):
    """Stands at one event of a record, or moves along them."""

    HELP = (
        "A recorded session. Space plays it and stands still, the Right and Left arrows go a turn "
        "forward or back, Home and e go to its beginning and its end, g lets you pick a turn, "
        "+ and - change the speed. Nothing here changes the record."
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("space", "play", "Play or stand still", show=False),
        Binding("right,n", "go(1)", "Next", show=False),
        Binding("left,p", "go(-1)", "Before", show=False),
        Binding("pagedown", "go(10)", "Ten on", show=False),
        Binding("pageup", "go(-10)", "Ten back", show=False),
        Binding("home", "go(-1000000)", "The beginning", show=False),
        Binding("end,e", "go(1000000)", "The end", show=False),
        Binding("plus,equals_sign", "speed(1)", "Faster", show=False),
        Binding("minus", "speed(-1)", "Slower", show=False),
        Binding("g,f8", "turns", "To a turn", show=False, id="turns"),
        Binding("f10,escape,q", "leave", "Back", id="leave"),
    ]

    def __init__(self, past: Past, speed: float = 1.0, at: int = 0, playing: bool = False) -> None:
        super().__init__()
        self._past, self._speed, self._playing = past, speed or SPEEDS[-1], playing
        self._past.go(at)
        self._shown = Observer(past).look()
        self._timer: Timer | None = None

    @property
    def snapshot(self) -> Snapshot:
        """The session as it was."""
        return self._shown

    @property
    def past(self) -> Past:
        """The record."""
        return self._past

    @property
    def playing(self) -> bool:
        """Whether it moves on by itself."""
        return self._playing

    def compose(self) -> ComposeResult:
        """The panels, and how to move."""
        yield from self.panels()
        yield KeyBar(id="keys")
        yield Foot()

    def on_mount(self) -> None:
        """Show where it stands, and begin to play if it should."""
        self.choose_tab("dialogue")
        self._show()
        self._pace()
        if self._past.problem:
            self.notify(self._past.problem, severity="warning", markup=False, timeout=10)

    def _show(self) -> None:
        on_stage = self.show_panels(self._shown, played=False, speed=0.0)
        self.choose_tab("scene" if self._shown.shown else "dialogue", on_stage)
        at, of = self._past.at + 1, len(self._past.stops)
        seconds = f"{self._past.event.at:.0f} s"
        state = "playing" if self._playing else "paused"
        lead = f"Replay {at} of {of}, {seconds}, {state}, {self._speed:g} a second"
        keys = _KEYS if not self._playing else (_KEYS[0]._replace(label="stop"), *_KEYS[1:])
        self.query_one(KeyBar).show_keys(lead, keys, _MORE)

    # ---- moving

    def go_to(self, stop: int) -> None:
        """Stand after the event of a stop."""
        before = self._past.at
        self._past.go(stop)
        if self._past.at == before + 1:
            self._shown = Observer(self._past, self._shown).look()
        else:
            self._shown = Observer(self._past).look()
        self._show()

    def action_go(self, by: int) -> None:
        """So many turns on, standing still."""
        self._playing = False
        self._pace()
        self.go_to(self._past.at + by)

    def action_play(self) -> None:
        """Move on by oneself, or stand still."""
        self._playing = not self._playing
        if self._playing and self._past.at == len(self._past.stops) - 1:
            self.go_to(0)
        self._pace()
        self._show()

    def action_speed(self, by: int) -> None:
        """Faster or slower."""
        nearest = min(range(len(SPEEDS)), key=lambda i: abs(SPEEDS[i] - self._speed))
        self._speed = SPEEDS[min(max(nearest + by, 0), len(SPEEDS) - 1)]
        self._pace()
        self._show()

    def _pace(self) -> None:
        if self._timer is not None:
            self._timer.stop()
        self._timer = self.set_interval(1 / self._speed, self._advance) if self._playing else None

    def _advance(self) -> None:
        if self._past.at == len(self._past.stops) - 1:
            self.action_play()
        else:
            self.go_to(self._past.at + 1)

    def action_turns(self) -> None:
        """Pick a turn to go to, of those that held in the end."""
        here = self._past.at
        self._past.go(len(self._past.stops))
        turns, wording = self._past.turns(), self._shown.wording
        self._past.go(here)
        choices = []
        for index, turn in enumerate(turns):
            line = said_in(turn)
            text = in_words(line.kind, line.text, wording) if line else "the beginning"
            choices.append(TurnChoice(index, shortened(text, 120), self._past.stop_at(turn.seq)))
        standing = max((c for c in choices if c.undone <= here), default=choices[0])
        marked = [c._replace(undone=here - c.undone if c != standing else 0) for c in choices]
        self.app.push_screen(TurnPicker(marked, LOOKING), lambda back: self._jump(here, back))

    def _jump(self, here: int, back: int | None) -> None:
        if back:
            self._playing = False
            self._pace()
            self.go_to(here - back)

    # ---- what the panels say

    def on_word_said(self, message: WordSaid) -> None:
        """A key of the bar was clicked, or a tab."""
        if message.via == "tab":
            self.choose_tab(message.word)
        elif message.word in _WORDS:
            _WORDS[message.word](self)

    def on_target_picked(self, message: TargetPicked) -> None:
        """A verb was clicked."""
        message.stop()
        if message.control.id == "mind" and "/" in message.target:
            self.action_verbs(message.target)

    @property
    def about(self) -> str:
        """What is going on, for the help."""
        return self.HELP

    def single_keys(self) -> Iterable[tuple[str, str]]:
        """The keys that move."""
        return ((key.key, key.label) for key in (*_KEYS, *_MORE))

    def leave(self, then: Callable[[], object] | None) -> bool:
        """There is nothing to record: just go."""
        self._playing = False
        self._pace()
        if then is not None:
            then()
        elif len(self.app.screen_stack) > 2:
            self.dismiss()
        else:
            self.app.exit()
        return True

    def action_leave(self) -> None:
        """Back to where it was opened from."""
        self.leave(None)

    def palette(self) -> Iterable[tuple[str, str, Callable[[], object]]]:
        """Every action of this screen."""
        yield "Play", "Play the record, or stand still", self.action_play
        yield "To a turn", "Pick a turn to go to", self.action_turns
        yield "Verbs", "The verbs the robot had learned", self.action_verbs
        yield "Robot's view", "Beside the scene what the robot took it for", self.action_belief
        for word, _, title in TABS:
            yield title, f"To the panel: {title.lower()}", partial(self.action_tab, word)
        yield "Leave", "Back", self.action_leave


_WORDS: dict[str, Callable[[ReplayScreen], None]] = {
    "play": ReplayScreen.action_play,
    "forward": lambda screen: screen.action_go(1),
    "back": lambda screen: screen.action_go(-1),
    "last": lambda screen: screen.action_go(1_000_000),
    "faster": lambda screen: screen.action_speed(1),
    "slower": lambda screen: screen.action_speed(-1),
    "to": ReplayScreen.action_turns,
}
