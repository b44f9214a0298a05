"""The panels of a session, taught in or played back: dialogue, scene, mind and what goes on."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Container
from textual.widgets import Input

from verbteach_tui.screens.room import RoomScreen
from verbteach_tui.snapshot import Moment, Snapshot
from verbteach_tui.widgets.dialogue_view import DialogueView
from verbteach_tui.widgets.latest_words import LatestWords
from verbteach_tui.widgets.mind_view import MindView
from verbteach_tui.widgets.scene_view import SceneView
from verbteach_tui.widgets.stage import Stage
from verbteach_tui.widgets.tab_strip import TabStrip
from verbteach_tui.widgets.title_bar import TitleBar

if TYPE_CHECKING:
    from verbteach_tui.screens.verbs import Revising

ALL_FROM = 110
"""Columns from which on all panels are in view at once."""

TABS = (("dialogue", "F2", "Dialogue"), ("scene", "F3", "Scene"), ("mind", "F4", "Mind"))


class PanelScreen(RoomScreen):
    """Four panels where there is room, tabs where there is not."""

    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 (the base class declares its type)
        (0, "-narrow"),
        (76, "-normal"),
        (ALL_FROM, "-wide"),
        (170, "-very-wide"),
    ]
    AUTO_FOCUS = None
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("f2", "tab('dialogue')", "Dialogue", show=False, id="dialogue"),
        Binding("f3", "tab('scene')", "Scene", show=False, id="scene"),
        Binding("f4", "tab('mind')", "Mind", show=False, id="mind"),
        Binding("f5", "verbs", "Verbs", id="verbs"),
        Binding("f7", "belief", "Robot's view", id="belief"),
    ]

    def __init__(self) -> None:
        super().__init__()
        self._believing = False
        self._moment: Moment | None = None
        self._tab = "dialogue"
        self._seen: frozenset[str] = frozenset()

    @property
    @abstractmethod
    def snapshot(self) -> Snapshot:
        """What is shown."""

    def panels(self) -> ComposeResult:
        """A title, the tabs, the panels, and what was said last where no dialogue is in view."""
        yield TitleBar(id="title")
        yield TabStrip(id="tabs")
        with Container(id="panels"):
            yield DialogueView(id="dialogue")
            yield SceneView(id="scene")
            yield Stage(id="stage")
            yield MindView(id="mind")
        yield LatestWords(id="latest")

    def show_panels(self, snapshot: Snapshot, played: bool, speed: float) -> bool:
        """Show ``snapshot``; whether something goes on that has a panel of its own."""
        self.query_one(DialogueView).show_lines(snapshot.lines)
        # What is said of a step that was seen stands among the steps, too.
        self.query_one(LatestWords).show_lines(snapshot.lines, 1 if snapshot.shown else 2)
        self.query_one(MindView).show_mind(snapshot.mind)
        self.query_one(TitleBar).show_title(snapshot.scene, self._figures(snapshot))
        on_stage = self.query_one(Stage).show_snapshot(snapshot, played, speed)
        if not played:
            self.show_moment(snapshot.moment)
        return on_stage

    def _figures(self, snapshot: Snapshot) -> tuple[str, ...]:
        """What the session has come to, after what the robot promises; that is of its mind."""
        promised = snapshot.mind.promised if "mind" not in self.hidden else ""
        return (*([promised] if promised else []), *snapshot.figures.texts)

    # ---- what is in view, which the record keeps

    @property
    def hidden(self) -> frozenset[str]:
        """The panels that are not to be seen here."""
        return frozenset()

    @property
    def seen(self) -> frozenset[str]:
        """The panels in view since the last turn was shown, some of them perhaps only for a time.

        What was learned and what the robot took the scene for count as well,
        as ``verbs`` and ``belief``.
        """
        return self._seen

    def look_anew(self) -> None:
        """Another turn is shown: only what is in view now has been seen of it."""
        self._seen = frozenset()
        self._look()

    def _look(self) -> None:
        self._seen |= self._in_view()

    def _in_view(self) -> frozenset[str]:
        # By the size: when the first turn is shown, the screen has no classes yet.
        tabbed = self.app.size.width < ALL_FROM
        panels = {self._tab} if tabbed else {word for word, _, _ in TABS}
        if "scene" in panels and self._believing and self.snapshot.belief is not None:
            panels.add("belief")
        if self.app.screen_stack[-1].has_class("-of-verbs"):
            panels.add("verbs")
        return frozenset(panels) - self.hidden

    def on_resize(self) -> None:
        """More panels may be in view, or fewer."""
        self._look()

    def show_moment(self, moment: Moment) -> None:
        """Show the scene at one moment."""
        snapshot, self._moment = self.snapshot, moment
        picture = snapshot.depictor.picture(moment.state, moment.before)
        believed = snapshot.believed if self._believing else None
        self.query_one(SceneView).show_picture(picture, snapshot.emphasis, moment.news, believed)

    def choose_tab(self, name: str, on_stage: bool | None = None) -> None:
        """Bring a panel into view where there is room for one only."""
        # By the panels: every change of the screen's own classes restyles whatever is on it.
        for word, _, _ in TABS:
            self.query_one(f"#{word}").set_class(word == name, "-chosen")
        self.query_one(LatestWords).set_class(name != "dialogue", "-chosen")
        if on_stage is not None:
            self.query_one(DialogueView).set_class(on_stage, "-staged")
            self.query_one(Stage).display = on_stage
        self.query_one(TabStrip).show_tabs(TABS, name)
        self._tab = name
        self._look()

    def action_tab(self, name: str) -> None:
        """Bring a panel into view and give it the keys; who is typing keeps them the first time."""
        looking = self.app.size.width < ALL_FROM and name != self._tab
        self.choose_tab(name)
        if not (looking and isinstance(self.focused, Input)):
            self.query_one(f"#{name}").focus()

    def action_belief(self) -> None:
        """Show beside the scene what the robot took it for, or no longer."""
        self._believing = not self._believing
        self.choose_tab("scene")
        self.show_moment(self._moment or self.snapshot.moment)
        self._look()
        if self._believing and self.snapshot.belief is None:
            self.notify("The robot looks around when it gets a command; it is shown then.")

    def action_verbs(self, frame: str = "") -> None:
        """Look at the verbs the robot has learned."""
        from verbteach_tui.screens.verbs import VerbsScreen

        self.app.push_screen(VerbsScreen(self.snapshot, frame, self.reviser()))
        self._look()

    def reviser(self) -> Callable[[Revising], None] | None:
        """Takes corrections of what was learned; ``None`` where there are none to make."""
        return None
