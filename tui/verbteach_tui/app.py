"""The full-screen app: starts it, opens sessions, and holds what all its screens share."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any, ClassVar

from textual.app import App, SystemCommand
from textual.binding import Binding, BindingType
from textual.command import CommandPalette
from textual.messages import ExitApp
from textual.screen import Screen

from verbteach_tui.help_text import help_about, keys_of
from verbteach_tui.keys import choose_keys
from verbteach_tui.messages import RecordOpened, SessionLeft, SessionNotOpened, SessionOpened
from verbteach_tui.options import AppOptions, OpenHome, OpenNew, OpenRecord, OpenSession
from verbteach_tui.screens.failure import NOT_OPENED, FailureScreen
from verbteach_tui.screens.help import HelpScreen
from verbteach_tui.screens.home import HomeScreen
from verbteach_tui.screens.opening import OpeningScreen
from verbteach_tui.screens.room import RoomScreen
from verbteach_tui.terminal import in_browser
from verbteach_tui.themes import DEFAULT, THEMES, VARIABLES

if TYPE_CHECKING:
    from verbteach.world.scene import Scene
    from verbteach_tui.lab.lab import Lab
    from verbteach_tui.screens.studies import Chosen
    from verbteach_tui.screens.teach import TeachScreen
    from verbteach_tui.teaching import Teaching

WARMING = 0.5
"""Seconds after which the home screen begins to load what teaching needs, behind the scenes."""

ALONE = 2.0
"""Seconds between two looks whether the server that shows this app in a browser is still there."""


def run_app(options: AppOptions) -> int:
    """Run the app until the person leaves it; answers the exit status.

    Sessions that it opened are closed when it returns. Needs a terminal: the
    caller has made sure that standard input and output are one. Where the
    session that it should start with cannot be opened, it raises what
    ``create`` or ``resume`` raised.
    """
    app = VerbteachApp(options)
    try:
        app.run()
    finally:
        app.close_sessions()
    if app.failure is not None:
        raise app.failure
    if app.afterwards is not None:
        return app.afterwards()
    return app.return_code or 0


class VerbteachApp(App[None]):
    """The teaching room and its way in."""

    TITLE = "verbteach"
    QUITTING = "{key} quits. All that you taught is kept."
    CSS_PATH = "app.tcss"
    COMMAND_PALETTE_BINDING = "ctrl+p"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("f1", "help", "Help", priority=True, id="help"),
        Binding("ctrl+p", "command_palette", "Palette", priority=True, id="palette"),
        Binding("ctrl+q", "quit", "Quit", show=False, priority=True, id="quit"),
    ]

    def __init__(self, options: AppOptions) -> None:
        super().__init__()
        self.options = options
        self.failure: Exception | None = None
        self._open: list[Teaching] = []
        self._lab: Lab | None = None
        self.afterwards: Callable[[], int] | None = None
        if "SSH_CONNECTION" in os.environ and "TEXTUAL_ANIMATIONS" not in os.environ:
            self.animation_level = "none"  # every frame would go over the wire
        stock = list(self.available_themes)
        for theme in THEMES:
            self.register_theme(theme)
        self.theme = options.theme if options.theme in self.available_themes else DEFAULT
        for name in stock:
            if name not in {theme.name for theme in THEMES}:
                self.unregister_theme(name)

    def action_help_quit(self) -> None:
        """Ctrl+C is for copying: say what quits, and that nothing is lost by it."""
        for key, active in self.active_bindings.items():
            if active.binding.action in ("quit", "app.quit"):
                pressed = self.get_key_display(active.binding.with_key(key))
                said = self.QUITTING.format(key=pressed)
                self.notify(said, title="Do you want to quit?", markup=False)
                return

    def get_theme_variable_defaults(self) -> dict[str, str]:
        """The app's own colours, for a theme that does not name them."""
        return VARIABLES

    def on_mount(self) -> None:
        """The first screen. In a browser, also watch for the server's end: nobody else tells."""
        if in_browser():
            self.set_interval(ALONE, partial(self._leave_without, os.getppid()))
        self.begin()

    def _leave_without(self, server: int) -> None:
        """Leave, and let go of the record, once the process that started this one is gone."""
        if os.getppid() != server:
            self.post_message(ExitApp())

    def begin(self) -> None:
        """Home, or straight into a session."""
        keymap = self.options.keymap
        choose_keys(keymap.said if keymap else {})
        if keymap is not None:
            self.set_keymap(dict(keymap.bound))
        opening = self.options.opening
        if isinstance(opening, OpenHome):
            self.push_screen(HomeScreen(self.options.scenes, self.load, self.options.sessions))
            self.set_timer(WARMING, self._warm_up)
        else:
            self.open_session(opening)

    def _warm_up(self) -> None:
        """Load what the teaching room needs while the person still chooses one."""
        room = "verbteach_tui.screens.teach"
        self.run_worker(partial(import_module, room), thread=True, exit_on_error=False)

    def load(self, scene: str) -> Scene:
        """A scene to look at. Runs in a worker thread, and may raise."""
        if self.options.load is not None:
            return self.options.load(scene)
        return self.options.settings(scene).scene

    # ---- sessions

    def on_home_screen_wanted(self, message: HomeScreen.Wanted) -> None:
        """A session was chosen on the home screen."""
        self.open_session(message.opening)

    def open_session(self, opening: OpenNew | OpenSession | OpenRecord) -> None:
        """Open a session in a worker, and enter it when it is open."""
        if isinstance(opening, OpenNew):
            self.push_screen(OpeningScreen(opening.scene, opening.command))
        else:
            self.push_screen(OpeningScreen(opening.path.name))
        if isinstance(opening, OpenRecord):
            work = partial(self._recalled, opening)
            self.run_worker(work, thread=True, exit_on_error=False, group="open")
        else:
            self.open_in_worker(opening)

    def open_in_worker(self, opening: OpenNew | OpenSession) -> None:
        """Open a session in a worker; ``SessionOpened`` or ``SessionNotOpened`` follows."""
        self.run_worker(
            partial(self._opened, opening), thread=True, exit_on_error=False, group="open"
        )

    def _recalled(self, opening: OpenRecord) -> None:
        try:
            from verbteach_tui.past import Past

            past = Past.open(opening.path, self.options.settings)
        except Exception as error:
            self.post_message(SessionNotOpened(error))
        else:
            self.post_message(RecordOpened(past, opening))

    def on_record_opened(self, message: RecordOpened) -> None:
        """Play a record back."""
        from verbteach_tui.screens.replay import ReplayScreen

        past, opening = message.past, message.opening
        at = past.stop_at(opening.at)
        self.switch_screen(ReplayScreen(past, opening.speed or 1.0, at, opening.speed > 0))

    def _opened(self, opening: OpenNew | OpenSession) -> None:
        try:
            if isinstance(opening, OpenNew):
                session = self.options.create(opening.scene)
            else:
                session = self.options.resume(opening.path)
            from verbteach_tui.teaching import Teaching

            teaching = Teaching(session)
        except Exception as error:
            self.post_message(SessionNotOpened(error))
        else:
            self._open.append(teaching)
            self.post_message(SessionOpened(teaching))

    def on_session_opened(self, message: SessionOpened) -> None:
        """Enter the teaching room."""
        from verbteach_tui.screens.teach import TeachScreen

        room = TeachScreen(message.teaching, self.options.speed, self.options.scenes(), self.load)
        if not self.enter(room) and self._is_first_time():
            room.call_after_refresh(room.action_tour)

    def enter(self, room: TeachScreen) -> bool:
        """Into a room; what was typed while it was opened stands in its line.

        Whether a command was given before, which is then said there.
        """
        before = self.screen
        self.switch_screen(room)
        if not isinstance(before, OpeningScreen):
            return False
        if before.command:
            room.call_after_refresh(room.begin_by_saying, before.command)
        if before.typed:
            room.call_after_refresh(room.take_early, before.typed)
        return bool(before.command)

    def _is_first_time(self) -> bool:
        """Whether the tour was never offered here; from now on it was."""
        toured = self.options.toured
        if toured is None or toured.exists():
            return False
        with suppress(OSError):  # a folder that cannot be written to only means another tour
            toured.parent.mkdir(parents=True, exist_ok=True)
            toured.touch()
        return True

    def on_session_not_opened(self, message: SessionNotOpened) -> None:
        """No session was opened: say why, on the home screen or to whoever started the app."""
        if isinstance(self.options.opening, OpenHome):
            self.switch_screen(FailureScreen("opening the session", message.error, NOT_OPENED))
        else:
            self.failure = message.error
            self.exit()

    def on_session_left(self, message: SessionLeft) -> None:
        """The person has left a session: on once it is let go, so that home finds it free."""
        self.run_worker(partial(self._let_go, message), thread=True, exit_on_error=False)

    def _let_go(self, message: SessionLeft) -> None:
        try:
            message.teaching.close()
        finally:
            self.call_from_thread(self._go_on, message)

    def _go_on(self, message: SessionLeft) -> None:
        """Home, or out where there is no home screen."""
        if message.then is not None:
            message.then()
        elif isinstance(self.options.opening, OpenHome):
            self.pop_screen()
        else:
            self.exit()

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """There is no study to choose where the app itself is served to somebody."""
        if action == "study" and self.options.take_part is None:
            return False
        return super().check_action(action, parameters)

    def action_study(self) -> None:
        """Choose a study to take part in."""
        from verbteach_tui.screens.studies import StudyChooser

        self.push_screen(StudyChooser(self.options.scenes, self.options.kinds), self._take_part)

    def _take_part(self, chosen: Chosen | None) -> None:
        if chosen is not None and self.options.take_part is not None:
            self.afterwards = partial(self.options.take_part, chosen.file, chosen.code)
            self.exit()

    def action_lab(self) -> None:
        """Into the lab; what goes on there goes on when it is left."""
        from verbteach_tui.lab.lab import Lab
        from verbteach_tui.lab.results import lab_folder
        from verbteach_tui.screens.lab import LabScreen

        if self._lab is None:
            self._lab = Lab(lab_folder(self.options.sessions))
        self.push_screen(LabScreen(self._lab))

    def close_sessions(self) -> None:
        """Let go of every session that was opened, and of the lab."""
        if self._lab is not None:
            self._lab.close()
        for teaching in self._open:
            teaching.close()

    async def action_quit(self) -> None:
        """Leave the app; a session that is open records that the person left."""
        for screen in self.screen_stack:
            if isinstance(screen, RoomScreen) and screen.leave(self.exit):
                return
        self.exit()

    # ---- help and palette

    def action_help(self) -> None:
        """Help about what has the focus."""
        if isinstance(self.screen, HelpScreen):
            self.screen.dismiss()
        elif not any(isinstance(screen, CommandPalette) for screen in self.screen_stack):
            self.push_screen(
                HelpScreen(help_about(self.focused or self.screen), keys_of(self.screen))
            )

    def get_system_commands(self, screen: Screen[Any]) -> Iterable[SystemCommand]:
        """Every action there is at the moment, for the palette."""
        if isinstance(screen, RoomScreen):
            for title, about, action in screen.palette():
                yield SystemCommand(title, about, action)
        yield SystemCommand("Theme", "Other colours", self.action_change_theme)
        yield SystemCommand("Help", "What has the keys, and which keys work", self.action_help)
        yield SystemCommand("Quit", "Leave; a session can be gone on with", self.action_quit)
