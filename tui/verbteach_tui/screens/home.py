"""The home screen: start in a scene, go on with a session, or quit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.message import Message
from textual.screen import Screen
from textual.timer import Timer
from textual.widget import Widget
from textual.widgets import OptionList, Static
from textual.widgets.option_list import Option

from verbteach_tui.first_words import Go, first_words
from verbteach_tui.messages import LineTyped
from verbteach_tui.options import OpenNew, OpenRecord, OpenSession
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.first_line import FirstLine
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.scene_chooser import LoadScene, SceneChooser

if TYPE_CHECKING:
    from verbteach_sessions.catalogue import Entry

MOST = 60
PAUSE = 0.5
"""Seconds that a letter stands alone before it counts as a key, and begins no line."""
_WELCOME = "Teach a robot what verbs mean. Choose a room."


class HomeScreen(Screen[None]):
    """Scenes with a preview, and the sessions there are."""

    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 (the base class declares its type)
        (0, "-narrow"),
        (76, "-normal"),
        (110, "-wide"),
    ]
    HELP = (
        "The home screen. At the top the scenes a new session can begin in, below them the "
        "sessions that can be gone on with. Tab goes from one to the other, Enter starts; p plays "
        "the chosen session back, s leads into a study, l into the lab. Or just type what the "
        "robot should do, as in: boil the water. Enter then begins in the chosen scene with that."
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("q", "app.quit", "Quit"),
        Binding("p", "play_back", "Play back"),
        Binding("l", "app.lab", "Lab"),
        Binding("s", "app.study", "Study"),
        Binding("n", "scenes", "New"),
        Binding("c", "sessions", "Continue"),
        Binding("slash", "type", "Type", show=False),
    ]

    class Wanted(Message):
        """The person wants to teach, in a new session or going on with one, or to look back."""

        def __init__(self, opening: OpenNew | OpenSession | OpenRecord) -> None:
            super().__init__()
            self.opening = opening

    def __init__(
        self, scenes: Callable[[], tuple[str, ...]], load: LoadScene, sessions: Path
    ) -> None:
        super().__init__()
        self._scenes, self._load, self._sessions = scenes, load, sessions
        self._entries: Sequence[Entry] = ()
        self.pause = PAUSE
        self._alone: Timer | None = None

    def compose(self) -> ComposeResult:
        """A greeting, the scenes, the sessions."""
        with Horizontal(id="greeting"):
            yield Static("verbteach", id="name")
            yield Static(_WELCOME, id="welcome")
        with Vertical(id="home"):
            yield SceneChooser(self._scenes(), self._load, id="chooser")
            sessions = OptionList(id="sessions", compact=True)
            sessions.border_title = "Go on with a session"
            yield sessions
        with Horizontal(id="entry"):
            yield Static("You ›", id="sign")
            yield FirstLine(id="line")
        yield Foot()

    def on_mount(self) -> None:
        """The scenes have the keys."""
        chooser = self.query_one(SceneChooser)
        chooser.entering = "Enter begins"
        chooser.take_focus()

    @property
    def idle_actions(self) -> frozenset[str]:
        """What would do nothing now: there may be no session yet."""
        return frozenset() if self._entries else frozenset({"play_back", "sessions"})

    def on_screen_resume(self) -> None:
        """Sessions may have come or grown since."""
        self.run_worker(self._list_sessions, thread=True, exit_on_error=False, group="list")

    def _list_sessions(self) -> None:
        from verbteach_sessions.catalogue import list_sessions

        entries = list_sessions(self._sessions)[:MOST]
        self.app.call_from_thread(self._show_sessions, entries)

    def _show_sessions(self, entries: Sequence[Entry]) -> None:
        sessions, self._entries = self.query_one("#sessions", OptionList), entries
        sessions.border_subtitle = "Enter goes on, p plays it back" if entries else ""
        self.refresh_bindings()
        if entries:
            sessions.set_options(Option(_label(one), id=str(one.path)) for one in entries)
            sessions.highlighted = 0
        else:
            sessions.set_options([Option("None yet: what you teach is kept here.", disabled=True)])

    def on_scene_chooser_chosen(self, message: SceneChooser.Chosen) -> None:
        """Begin in a scene."""
        self.post_message(self.Wanted(OpenNew(message.scene)))

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """Go on with a session."""
        if message.option_id is not None:
            self.post_message(self.Wanted(OpenSession(Path(message.option_id))))

    # ---- typing

    def on_key(self, event: events.Key) -> None:
        """A letter is a key only where nothing more is typed; else a line begins with it."""
        character, line = event.character, self.query_one(FirstLine)
        if character is None or not event.is_printable or (character in "/ " and not line.value):
            return
        key = self.active_bindings.get(event.key)
        before, alone = self.focused, self.focused is not line and not line.value
        if key is not None and alone and not self.pause:
            return
        event.stop()
        event.prevent_default()
        line.focus()
        line.insert_text_at_cursor(character)
        if key is not None and alone:
            press = partial(self._press, character, key.binding.action, before)
            self._alone = self.set_timer(self.pause, press)

    async def _press(self, character: str, action: str, before: Widget | None) -> None:
        """Nothing came after the letter: do what its key does."""
        line = self.query_one(FirstLine)
        if line.value == character and line.has_focus:
            line.clear()
            self.set_focus(before)
            await self.app.run_action(action, self)

    def on_paste(self, event: events.Paste) -> None:
        """What is pasted is meant for the line."""
        event.stop()
        line = self.query_one(FirstLine)
        line.focus()
        line.take_in(event.text)

    async def on_line_typed(self, message: LineTyped) -> None:
        """Begin with what was typed, or do what it means here."""
        if self._alone is not None:
            self._alone.stop()
        self.query_one(FirstLine).sent()
        chooser = self.query_one(SceneChooser)
        meant = first_words(message.text, self._scenes())
        if isinstance(meant, Go):
            self.set_focus(self.query_one("#scene-list"))  # at once: help speaks of what has it
            await self.app.run_action(meant.action, self)
        elif scene := meant.scene or chooser.highlighted:
            self.post_message(self.Wanted(OpenNew(scene, meant.command)))

    def action_type(self) -> None:
        """To the line."""
        self.query_one(FirstLine).focus()

    # ---- going about

    def action_scenes(self) -> None:
        """To the scenes."""
        self.query_one(SceneChooser).take_focus()

    def action_sessions(self) -> None:
        """To the sessions."""
        self.query_one("#sessions").focus()

    def action_play_back(self) -> None:
        """Play back the session under the cursor; first of all, go there."""
        sessions = self.query_one("#sessions", OptionList)
        chosen = sessions.highlighted_option
        if not sessions.has_focus:
            sessions.focus()
        elif chosen is not None and chosen.id is not None:
            self.post_message(self.Wanted(OpenRecord(Path(chosen.id))))


def _label(entry: Entry) -> Content:
    """As in: 22 Nov 03:12  kitchen-1  3 commands  boil, fill; its name where it says no more."""
    when = _local_time(entry.created, datetime.now().astimezone().year)
    if not entry.scene:
        return Content(f"✗ {visible(entry.id)}  {visible(entry.problem)}")
    commands = f"{entry.episodes} command{'s' * (entry.episodes != 1)}"
    verbs = visible(", ".join(entry.verbs_learned)) or "no verb yet"
    but = f"  ✗ {visible(entry.problem)}" if entry.problem else ""
    return Content(f"{when}  {visible(entry.scene):13}  {commands:11}  {verbs}{but}")


def _local_time(created: str, this_year: int) -> str:
    """Day and time in this year, day and year in others: always as wide."""
    try:
        when = datetime.fromisoformat(created).astimezone()
    except ValueError:
        return f"{visible(created[:12]):12}"
    return f"{when:%d %b %H:%M}" if when.year == this_year else f"{when:%d %b  %Y}"
