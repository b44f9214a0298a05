"""Going to another scene in the middle of a session."""

from __future__ import annotations

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen
from textual.widgets import Static

from verbteach_tui.widgets.foot import Foot
from verbteach_tui.widgets.scene_chooser import LoadScene, SceneChooser


class ScenePicker(ModalScreen[str | None]):
    """Answers with the scene to go to, or ``None`` to stay."""

    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 (the base class declares its type)
        (0, "-narrow"),
        (76, "-wide"),
    ]
    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,f6", "stay", "Stay here")]

    def __init__(self, scenes: tuple[str, ...], load: LoadScene, current: str) -> None:
        super().__init__()
        self._scenes, self._load, self._current = scenes, load, current

    def compose(self) -> ComposeResult:
        """The chooser and what it does."""
        with Vertical(classes="dialog -large") as dialog:
            dialog.border_title = "Go to another scene"
            yield SceneChooser(self._scenes, self._load, self._current, typed=True, id="chooser")
            yield Static(
                "Type a name to find it; Enter goes there. The robot takes along what it has "
                "learned, and finds the scene as it starts.",
                classes="quiet",
            )
        yield Foot()

    def on_mount(self) -> None:
        """The list has the keys."""
        self.query_one(SceneChooser).take_focus()

    def on_scene_chooser_chosen(self, message: SceneChooser.Chosen) -> None:
        """Go."""
        self.dismiss(message.scene)

    def action_stay(self) -> None:
        """Stay."""
        self.dismiss(None)
