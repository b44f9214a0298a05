"""Choosing a scene: a list, and a look at the one under the cursor before it is entered."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, TypeAlias

from textual import events
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.content import Content
from textual.message import Message
from textual.widgets import OptionList
from textual.widgets.option_list import Option
from textual.worker import get_current_worker

from verbteach_tui.typed_name import TypedName
from verbteach_tui.views.rows import Span, wrapped
from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.scene_view import SceneView

if TYPE_CHECKING:
    from verbteach.world.scene import Scene
    from verbteach_tui.views.picture import Picture

PAUSE = 0.08
"""Seconds a scene stays under the cursor before it is opened to look at."""

LoadScene: TypeAlias = "Callable[[str], Scene]"
"""Opens a scene; may raise, and runs in a worker thread."""


class SceneChooser(Horizontal):
    """Scenes and a preview."""

    HELP = (
        "Choose a scene with the arrow keys; how it looks is shown beside it. Enter, or a click "
        "on the scene that is already chosen, starts."
    )

    class Chosen(Message):
        """A scene was chosen to be entered."""

        def __init__(self, scene: str) -> None:
            super().__init__()
            self.scene = scene

    class Looked(Message):
        """A worker has opened a scene to look at, or could not (``problem`` says why)."""

        def __init__(self, scene: str, picture: Picture | None, problem: str = "") -> None:
            super().__init__()
            self.scene = scene
            self.picture = picture
            self.problem = problem

    def __init__(
        self,
        scenes: tuple[str, ...],
        load: LoadScene,
        current: str = "",
        *,
        typed: bool = False,
        id: str | None = None,
    ) -> None:
        """``typed``: letters jump to the scene whose name is typed; else they are left alone."""
        super().__init__(id=id)
        self._scenes, self._load, self._current = scenes, load, current
        self._typed = TypedName(scenes) if typed else None
        self._pictures: dict[str, Picture] = {}

    def compose(self) -> ComposeResult:
        """The list and the preview."""
        options = OptionList(*(Option(Content(s), id=s) for s in self._scenes), compact=True)
        options.id = "scene-list"
        options.border_title = "Scenes"
        yield options
        yield SceneView(id="preview")

    def on_mount(self) -> None:
        """Begin where the person is."""
        options = self.query_one("#scene-list", OptionList)
        if self._scenes:
            options.highlighted = (
                self._scenes.index(self._current) if self._current in self._scenes else 0
            )

    def on_key(self, event: events.Key) -> None:
        """Jump to the scene whose name is typed."""
        if self._typed is None:
            return
        if event.key == "backspace":
            found = self._typed.back(event.time)
        elif event.character and event.is_printable and not event.character.isspace():
            found = self._typed.type(event.character, event.time, self.highlighted or "")
        else:
            return
        event.stop()
        event.prevent_default()
        options = self.query_one("#scene-list", OptionList)
        options.border_subtitle = Content(self._typed.text)
        if found is not None:
            options.highlighted = self._scenes.index(found)

    @property
    def entering(self) -> str:
        """How a scene is entered, in words below the list."""
        return str(self.query_one("#scene-list").border_subtitle)

    @entering.setter
    def entering(self, words: str) -> None:
        self.query_one("#scene-list").border_subtitle = words

    def take_focus(self) -> None:
        """Put the keys into the list."""
        self.query_one("#scene-list").focus()

    def on_option_list_option_highlighted(self, message: OptionList.OptionHighlighted) -> None:
        """Look at a scene."""
        message.stop()
        scene = message.option_id
        if scene is None:
            return
        if scene in self._pictures:
            self._show(scene)
        else:
            self.set_timer(PAUSE, partial(self._look_at, scene))

    def _look_at(self, scene: str) -> None:
        """Open a scene, unless the person has gone on meanwhile."""
        if scene == self.highlighted and scene not in self._pictures:
            self.run_worker(
                partial(self._look, scene),
                thread=True,
                exclusive=True,
                group="look",
                exit_on_error=False,
            )

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """Enter a scene."""
        message.stop()
        if message.option_id is not None:
            self.post_message(self.Chosen(message.option_id))

    def on_scene_chooser_looked(self, message: Looked) -> None:
        """A scene was opened to look at."""
        message.stop()
        if message.picture is not None:
            self._pictures[message.scene] = message.picture
        if self.highlighted == message.scene:
            self._show(message.scene, message.problem)

    @property
    def highlighted(self) -> str | None:
        """The scene under the cursor."""
        option = self.query_one("#scene-list", OptionList).highlighted_option
        return option.id if option else None

    def _look(self, scene: str) -> None:
        from verbteach_tui.views.picture import Depictor

        try:
            opened = self._load(scene)
            picture = Depictor(opened).picture(opened.initial)
        except Exception as error:
            looked = self.Looked(scene, None, visible(str(error)))
        else:
            looked = self.Looked(scene, picture)
        if not get_current_worker().is_cancelled:
            self.post_message(looked)

    def _show(self, scene: str, problem: str = "") -> None:
        preview = self.query_one(SceneView)
        picture = self._pictures.get(scene)
        if picture is not None:
            preview.show_picture(picture)
        else:
            preview.border_title = scene
            preview.show(lambda width: wrapped([Span("✗ ", "bad"), Span(problem)], width, 2))
