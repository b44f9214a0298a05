"""The teaching room: the dialogue, the scene, the robot's mind and the line to type in."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal
from textual.widgets import Static

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach_sessions.script import ScriptAct, render
from verbteach_sessions.session_acts import Quit, Redo, Undo
from verbteach_tui.keys import MEANS, answers, anytime, told
from verbteach_tui.messages import (
    LineTyped,
    Refused,
    SessionLeft,
    StepLooked,
    StepShown,
    TargetPicked,
    TurnTaken,
    WordSaid,
    WorkFailed,
)
from verbteach_tui.prompts import ABOUT, TYPING, bar_of, prompt_of
from verbteach_tui.screens.answering import AnsweringScreen
from verbteach_tui.screens.failure import FailureScreen
from verbteach_tui.screens.panels import TABS
from verbteach_tui.screens.scenes import ScenePicker
from verbteach_tui.screens.turns import TurnPicker
from verbteach_tui.screens.verbs import Revising, VerbsScreen
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.teaching import Teaching
from verbteach_tui.turns import turns_of
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.command_input import CommandInput
from verbteach_tui.widgets.execution_view import STEERING
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.key_bar import KeyBar
from verbteach_tui.widgets.scene_chooser import LoadScene
from verbteach_tui.widgets.stage import Stage
from verbteach_tui.widgets.steps_view import EDITING

_DROPPED = "What you showed is dropped. Ctrl+Z brings it back."
_LEFT_SO = "That you left could not be written down. Everything before it is kept."
_WITHOUT_IT = (Phase.COMMAND, Phase.EXECUTION, Phase.JUDGEMENT)
"""Where a demonstration leads that nothing was learned from."""


class TeachScreen(AnsweringScreen):
    """One session being taught in."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("f6", "scenes", "Other scene", id="scenes"),
        Binding("ctrl+z", "word('undo')", "Undo", priority=True, id="line-undo"),
        Binding("ctrl+y", "word('redo')", "Redo", show=False, priority=True, id="line-redo"),
        Binding("slash", "type", "Type", show=False, id="type"),
        Binding("tab", "switch", "Type, or answer with keys", show=False),
        Binding("f8", "turns", "Earlier turns", id="turns"),
        Binding("f9", "steps", "The steps shown", show=False, id="steps"),
        Binding("f10", "leave", "Leave", id="leave"),
    ]

    def __init__(
        self, teaching: Teaching, speed: float, scenes: tuple[str, ...], load: LoadScene
    ) -> None:
        super().__init__(teaching)
        self._speed, self._scenes, self._load = speed, scenes, load
        self._after_leaving: Callable[[], object] | None = None
        self._phase = Phase.COMMAND
        self._steps = 0

    def compose(self) -> ComposeResult:
        """Four panels, and below them what can be said."""
        yield from self.panels()
        yield KeyBar(id="keys")
        with Horizontal(id="entry"):
            yield Static("You ›", id="sign")
            yield CommandInput(id="line")
        yield Foot()

    def on_mount(self) -> None:
        """Show the session as it is opened."""
        self.choose_tab("dialogue")
        self.query_one(CommandInput).elsewhere = self.belongs_elsewhere
        self._show(self.snapshot, played=False)
        for notice in self.teaching.notices:
            self.notify(visible(notice), title="The record was repaired", markup=False, timeout=12)

    def take_early(self, typed: str) -> None:
        """What was typed before the room was there, where a command is waited for."""
        if self.snapshot.phase is Phase.COMMAND:
            self.query_one(CommandInput).begin_with(typed.lstrip("/ "))

    def begin_by_saying(self, command: str) -> None:
        """Send a first command that was given before the room was there."""
        self.query_one(CommandInput).begin_with(command)
        self.on_line_typed(LineTyped(command))

    def type_on(self, character: str) -> bool:
        """Go on in the line with what was typed in front of this screen; whether that fits now."""
        if self.snapshot.phase is not Phase.COMMAND:
            return False
        line = self.query_one(CommandInput)
        self.set_focus(line)
        line.insert_text_at_cursor(character)
        return True

    # ---- showing

    def _show(self, snapshot: Snapshot, played: bool) -> None:
        on_stage = self.show_panels(snapshot, played, self._speed)
        self._expect(snapshot)
        self.refresh_bindings()
        looking = played or snapshot.phase is Phase.DEMONSTRATION
        self.choose_tab("scene" if looking else "dialogue", on_stage)
        self.look_anew()
        self.teaching.shown()

    @property
    def idle_actions(self) -> frozenset[str]:
        """What would do nothing now: the robot's view or another scene, undo at the beginning."""
        idle = {"belief" if self.snapshot.phase is Phase.COMMAND else "scenes"}
        if not self.snapshot.can_undo:
            idle |= {"word('undo')", "turns"}
        return frozenset(idle)

    def _expect(self, snapshot: Snapshot) -> None:
        """Put the keys where this kind of turn is answered."""
        line = self.query_one(CommandInput)
        prompt = prompt_of(snapshot)
        line.expect(prompt.placeholder, prompt.example, self._completion)
        line.stays = snapshot.phase is Phase.COMMAND
        went_on = self._went_on_typing(snapshot)
        if snapshot.phase is Phase.COMMAND or self.keeps_line:
            line.focus()
        elif not (went_on and (line.has_focus or self.query_one(Stage).builder.editing)):
            self._answer_with_keys()
        self._steps = len(snapshot.shown)
        self._show_keys()

    def _answer_with_keys(self) -> None:
        self.set_focus(None)
        self.query_one(Stage).take_focus()

    def _went_on_typing(self, snapshot: Snapshot) -> bool:
        """Whether one step of a demonstration follows another."""
        was, self._phase = self._phase, snapshot.phase
        return was is snapshot.phase is Phase.DEMONSTRATION

    def _completion(self, text: str) -> str | None:
        snapshot = self.snapshot
        return snapshot.menu.complete(text) if snapshot.phase is Phase.DEMONSTRATION else None

    def _show_keys(self) -> None:
        watching = self.query_one(Stage).execution.running
        editing = self.query_one(Stage).builder.editing
        self.query_one(KeyBar).show_keys(*bar_of(self.snapshot, self.typing, watching, editing))

    # ---- saying

    def on_word_said(self, message: WordSaid) -> None:
        """A word was chosen by a key of a widget, or by a click."""
        if message.via == "tab":
            self.choose_tab(message.word)
        elif message.word in STEERING:
            self.query_one(Stage).execution.steer(message.word)
        elif message.word in EDITING:
            self.query_one(Stage).builder.steps.steer(message.word)
        elif message.word == "leave":
            self._answer_with_keys()
        elif message.word == TYPING.word:
            self.action_type()
        else:
            self.say_word(message.word, message.word, message.via)

    def on_target_picked(self, message: TargetPicked) -> None:
        """An object was clicked in the scene or the mind, or a verb."""
        message.stop()
        if message.control.id == "mind" and "/" in message.target:
            self.action_verbs(message.target)
        elif self.snapshot.phase is Phase.DEMONSTRATION:
            self.query_one(Stage).builder.offer(message.target)
        elif isinstance(self.snapshot.waiting, acts.NpGrdWhq | acts.NpGrdYnq):
            self.say(acts.Point(message.target), message.target, "mouse")

    def meant(self, act: ScriptAct) -> ScriptAct:
        """A step comes where the person has said that the next one comes."""
        at = self.query_one(Stage).builder.steps.at
        if isinstance(act, acts.Do) and at is not None:
            return acts.Insert(at, act.action)
        return act

    # ---- hearing

    def on_turn_taken(self, message: TurnTaken) -> None:
        """The robot has answered."""
        if message.snapshot.ended:  # nothing can be said any more, so it is never settled
            self.post_message(SessionLeft(self.teaching, self._after_leaving))
            return
        self.settled()
        before, steps = self._phase, self._steps
        self._show(message.snapshot, message.played)
        self.dropped = bool(
            steps and before is Phase.DEMONSTRATION and message.snapshot.phase in _WITHOUT_IT
        )
        if self.dropped and self._due is None:
            self.notify(_DROPPED, timeout=8)
        self.say_what_was_typed_ahead(before)
        self.take_back()
        for screen in self.app.screen_stack:
            if isinstance(screen, VerbsScreen):
                screen.show_snapshot(message.snapshot)

    def on_refused(self, message: Refused) -> None:
        """What was said does not fit; nothing has changed."""
        self.settled()
        self.nothing_said()
        self.give_back(message.raw)
        self._show_keys()
        self.notify(visible(message.reason), severity="warning", markup=False, timeout=6)

    def on_work_failed(self, message: WorkFailed) -> None:
        """Something broke; say so and go on. Nobody is kept here because the disk is full."""
        self.settled()
        if message.leaving:  # the record is then like one that was cut off: it can be gone on with
            self.app.notify(_LEFT_SO, severity="warning", timeout=8)
            self.post_message(SessionLeft(self.teaching, self._after_leaving))
            return
        self.nothing_said()
        self.give_back(message.raw)
        self._show_keys()
        self.app.push_screen(FailureScreen(message.doing, message.error))

    def waiting(self) -> None:
        """Say that the robot is thinking."""
        self.query_one(KeyBar).show_keys("… the robot is thinking", ())

    def on_step_shown(self, message: StepShown) -> None:
        """The execution being watched is one step on: the scene follows."""
        moments = self.snapshot.moments
        if self.snapshot.steps and message.at < len(moments):
            self.show_moment(moments[message.at])
        self._speed = self.query_one(Stage).execution.playback.speed
        self._show_keys()

    def on_step_looked(self, message: StepLooked) -> None:
        """A step of the demonstration is looked at: the scene shows the world after it."""
        moments = self.snapshot.shown_moments
        if message.after < len(moments):
            self.show_moment(moments[message.after])

    def on_descendant_focus(self) -> None:
        """Other keys count now."""
        self._show_keys()

    def on_descendant_blur(self) -> None:
        """Other keys count now."""
        self._show_keys()

    # ---- going about

    def action_word(self, word: str) -> None:
        """Say a word of the script."""
        self.say_word(word, word, "key")

    def action_type(self) -> None:
        """Type an answer."""
        self.query_one(CommandInput).focus()

    def action_switch(self) -> None:
        """From the line to where keys answer, or back to the line."""
        if self.typing:
            self._answer_with_keys()
        else:
            self.action_type()

    def reviser(self) -> Callable[[Revising], None]:
        """Corrections are said to the robot, between two commands."""
        return self._revise

    def _revise(self, act: Revising) -> None:
        if self.snapshot.phase is Phase.COMMAND:
            self.say(act, render(act), "picked")
        else:
            self.notify("Finish this command first, or skip it; then correct what was learned.")

    def action_tour(self) -> None:
        """Show what is where."""
        from verbteach_tui.screens.tour import TourScreen

        self.app.push_screen(TourScreen(self))

    def action_turns(self) -> None:
        """Go back to an earlier turn, or forward again to one that was taken back."""
        if not self.thinking:
            turns = turns_of(self.teaching.session, self.snapshot)
            self.app.push_screen(TurnPicker(turns), self._go_to_turn)

    def _go_to_turn(self, turns: int | None) -> None:
        if turns:
            act = Undo(turns) if turns > 0 else Redo(-turns)
            self.say(act, render(act), "picked")

    def action_steps(self) -> None:
        """To the steps of the demonstration, to edit them."""
        if self.snapshot.phase is Phase.DEMONSTRATION:
            self.query_one(Stage).builder.steps.focus()
        else:
            self.notify("There are steps to edit while you show the robot something.")

    def action_scenes(self) -> None:
        """Go to another scene."""
        if self.snapshot.phase is not Phase.COMMAND:
            self.notify("Finish this command first, or skip it; then choose another scene.")
            return
        self.app.push_screen(
            ScenePicker(self._scenes, self._load, self.snapshot.scene), self._go_to
        )

    def _go_to(self, scene: str | None) -> None:
        if scene:
            self.say(acts.GoToScene(scene), f"scene: {scene}", "picked")

    def action_leave(self) -> None:
        """Leave the session; it can be gone on with at any time."""
        self.leave(None)

    def leave(self, then: Callable[[], object] | None) -> bool:
        """Record that the person leaves, and do ``then``; False where the robot is thinking."""
        if self.thinking:
            return False
        self._after_leaving = then
        self.say(Quit(), "quit", "key")
        return True

    @property
    def about(self) -> str:
        """What is going on, for the help."""
        return ABOUT[self.snapshot.phase]

    def single_keys(self) -> Iterable[tuple[str, str]]:
        """The keys that answer now, each with what it says."""
        for key in (*answers(self.snapshot.phase), *anytime()):
            yield key.key, told(key)

    def palette(self) -> Iterable[tuple[str, str, Callable[[], object]]]:
        """Every action of this screen with what it does, for the palette."""
        for key in (*answers(self.snapshot.phase), *anytime()):
            about = MEANS.get(key.word, f"Say '{key.word}'").capitalize()
            yield key.label.capitalize(), about, partial(self.action_word, key.word)
        yield "Undo to an earlier turn", "Pick the turn; redo as well", self.action_turns
        yield "Verbs", "The verbs the robot has learned", self.action_verbs
        yield "Robot's view", "Beside the scene what the robot took it for", self.action_belief
        yield "Other scene", "Go to another scene", self.action_scenes
        for word, _, title in TABS:
            yield title, f"To the panel: {title.lower()}", partial(self.action_tab, word)
        if self.snapshot.phase is Phase.DEMONSTRATION:
            yield "Edit the steps", "Take away, move, insert, run", self.action_steps
        yield "Tour", "What is where, in a minute", self.action_tour
        yield "Leave", "Leave the session, to go on later", self.action_leave
