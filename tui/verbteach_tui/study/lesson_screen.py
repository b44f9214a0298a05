"""The teaching room within a study: the task above, hidden panels hidden, and an end to it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType

from verbteach_sessions.script import ScriptAct
from verbteach_sessions.session_acts import Quit
from verbteach_tui.messages import Refused, TurnTaken
from verbteach_tui.screens.panels import TABS
from verbteach_tui.screens.teach import TeachScreen
from verbteach_tui.study.leaving_screen import PAUSE, LeavingScreen
from verbteach_tui.study.lesson_talk import task_text
from verbteach_tui.study.run import VIA, StudyRun
from verbteach_tui.study.words import PRACTICE
from verbteach_tui.teaching import Teaching
from verbteach_tui.views.rows import Row, Span, wrapped
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.rows_view import RowsView
from verbteach_tui.widgets.scene_chooser import LoadScene
from verbteach_tui.widgets.tab_strip import TabStrip

_TITLES = {
    "tour": "Tour",
    "belief": "Robot's view",
    "verbs": "Verbs",
    "scenes": "Other scene",
}
"""How the palette calls the actions that a study may close."""


class TaskBar(RowsView, can_focus=False):
    """What the participant is asked to do, in a row or two."""

    DEFAULT_CSS = """
    TaskBar {
        height: auto; max-height: 3; overflow-y: hidden; scrollbar-gutter: auto;
        background: $surface;
    }
    """

    def show_task(self, lead: str, text: str) -> None:
        """Show a task, or nothing."""
        self.display = bool(lead or text)
        self.show_once((lead, text), lambda width: _task_rows(lead, text, width))

    def redrawn(self) -> None:
        """Take as many rows as the task needs at this width."""
        self.styles.height = max(len(self.rows), 1)


class LessonScreen(TeachScreen):
    """One stretch of teaching; ``why`` says what ended it, ``PAUSE`` and ``STOP`` included."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("f10", "leave", "Pause", id="leave")]

    def __init__(
        self, run: StudyRun, teaching: Teaching, speed: float, load: LoadScene, practice: bool
    ) -> None:
        super().__init__(teaching, speed, run.lessons.scenes, load)
        self._run, self._practice = run, practice
        # The run is already a step on while this screen is being left.
        self._panels, self._given = run.panels, bool(run.lessons.tasks)
        self._hidden = {word for word, _, _ in TABS if word in ("scene", "mind")} - self._panels
        self._act: ScriptAct | None = None
        self.why = ""

    def compose(self) -> ComposeResult:
        """The room, with the task above it."""
        yield TaskBar(id="task")
        yield from super().compose()

    def on_mount(self) -> None:
        """Hide what the condition hides; begin where the task is."""
        self.set_class("mind" in self._hidden, "-without-mind")
        self.set_class("scene" in self._hidden, "-without-scene")
        self.call_later(self._go_on)

    # ---- the study's own doing

    def say(self, act: ScriptAct, raw: str, via: str) -> bool:
        """As ever, unless the study does not allow it."""
        if self.thinking:
            return False
        refusal = self._run.refusal(self.teaching.session, act)
        if refusal:
            self.post_message(Refused(refusal[:1].upper() + refusal[1:] + ".", raw))
            return False
        self._act = act
        return super().say(act, raw, via)

    def on_turn_taken(self, message: TurnTaken) -> None:
        """The robot has answered: is this the end, or is the next task elsewhere?"""
        if not message.snapshot.ended:
            self.call_later(self._go_on)

    def _go_on(self) -> None:
        session = self.teaching.session
        self.why = self._run.over(session)
        move = self._run.moves(session, self._act)
        if self.why:
            super().say(Quit(), "", VIA)
        elif move is not None:
            super().say(move, "", VIA)
        lead = PRACTICE.partition(":")[0] if self._practice else ""
        self.query_one(TaskBar).show_task(lead, task_text(self._run, session))

    # ---- what is shown

    @property
    def hidden(self) -> frozenset[str]:
        """The panels that the condition does not show."""
        return frozenset(self._hidden)

    def choose_tab(self, name: str, on_stage: bool | None = None) -> None:
        """Bring a panel into view, if the condition shows it."""
        """As ever, but for the panels that the condition hides."""
        shown = tuple(tab for tab in TABS if tab[0] not in self._hidden)
        name = "dialogue" if name in self._hidden else name
        super().choose_tab(name, on_stage)
        self.query_one(TabStrip).show_tabs(shown, name)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """What the condition hides cannot be called up either."""
        if action in self._barred or (action == "tab" and parameters[0] in self._hidden):
            return False
        return super().check_action(action, parameters)

    @property
    def _barred(self) -> set[str]:
        """The actions that there are not: the tour, too, speaks of panels that may be hidden."""
        barred = {"tour"}
        if not {"scene", "mind"} <= self._panels:
            barred.add("belief")
        if "verbs" not in self._panels:
            barred.add("verbs")
        if self._given:
            barred.add("scenes")
        return barred

    def action_verbs(self, frame: str = "") -> None:
        """The verbs, where they are shown."""
        if "verbs" not in self._barred:
            super().action_verbs(frame)

    def action_belief(self) -> None:
        """The robot's view, where it is shown."""
        if "belief" not in self._barred:
            super().action_belief()

    def action_scenes(self) -> None:
        """Another scene, where the participant may choose."""
        if "scenes" not in self._barred:
            super().action_scenes()

    def palette(self) -> Iterable[tuple[str, str, Callable[[], object]]]:
        """Every action that there is here."""
        hidden = {title for word, _, title in TABS if word in self._hidden}
        hidden |= {_TITLES[action] for action in self._barred}
        return (entry for entry in super().palette() if entry[0] not in hidden)

    # ---- leaving

    def action_leave(self) -> None:
        """Ask how."""
        if not self.thinking:
            self.app.push_screen(LeavingScreen(self._run.code), self._leave_by)

    def _leave_by(self, how: str | None) -> None:
        if how and not self.thinking:
            self.why = how
            self.say(Quit(), "quit", "key")

    def leave(self, then: Callable[[], object] | None) -> bool:
        """The app is being quit: that is a pause."""
        self.why = self.why or PAUSE
        return super().leave(then)


def _task_rows(lead: str, text: str, width: int) -> list[Row]:
    first = [Span(f"{lead}  ", "warn")] if lead else []
    return wrapped([*first, Span(visible(text), "accent")], width)
