"""The home screen: start in a scene, go on with a session, or quit."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.message import Message
from textual.screen import Screen
from textual.widgets import OptionList, Static
from textual.widgets.option_list import Option

from verbteach_tui.options import OpenNew, OpenSession
from verbteach_tui.recent import SessionRow, ago, recent_sessions
from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.scene_chooser import LoadScene, SceneChooser

_WELCOME = "Teach a robot what verbs mean. Choose a room to begin, or go on with a session."


class HomeScreen(Screen[None]):
    """Scenes with a preview, and the sessions there are."""

    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 (the base class declares its type)
        (0, "-narrow"),
        (76, "-normal"),
        (110, "-wide"),
    ]
    HELP = (
        "The home screen. At the top the scenes a new session can begin in, below them the "
        "sessions that can be gone on with. Tab goes from one to the other, Enter starts."
    )
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("q", "app.quit", "Quit"),
        Binding("n", "scenes", "New session"),
        Binding("c", "sessions", "Continue one"),
    ]

    class Wanted(Message):
        """The person wants to teach: in a new session, or going on with one."""

        def __init__(self, opening: OpenNew | OpenSession) -> None:
            super().__init__()
            self.opening = opening

    def __init__(
        self, scenes: Callable[[], tuple[str, ...]], load: LoadScene, sessions: Path
    ) -> None:
        super().__init__()
        self._scenes, self._load, self._sessions = scenes, load, sessions

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
        yield Foot()

    def on_mount(self) -> None:
        """The scenes have the keys."""
        self.query_one(SceneChooser).take_focus()

    def on_screen_resume(self) -> None:
        """Sessions may have come or grown since."""
        self.run_worker(self._list_sessions, thread=True, exit_on_error=False, group="list")

    def _list_sessions(self) -> None:
        rows = recent_sessions(self._sessions)
        self.app.call_from_thread(self._show_sessions, rows)

    def _show_sessions(self, rows: tuple[SessionRow, ...]) -> None:
        sessions = self.query_one("#sessions", OptionList)
        if rows:
            now = time.time()
            sessions.set_options(
                Option(Content(f"{row.name}   {row.scene}   {ago(now - row.changed)}"),
                       id=str(row.path)) for row in rows
            )  # fmt: skip
        else:
            sessions.set_options([Option("None yet", disabled=True)])

    def on_scene_chooser_chosen(self, message: SceneChooser.Chosen) -> None:
        """Begin in a scene."""
        self.post_message(self.Wanted(OpenNew(message.scene)))

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """Go on with a session."""
        if message.option_id is not None:
            self.post_message(self.Wanted(OpenSession(Path(message.option_id))))

    def action_scenes(self) -> None:
        """To the scenes."""
        self.query_one(SceneChooser).take_focus()

    def action_sessions(self) -> None:
        """To the sessions."""
        self.query_one("#sessions").focus()
