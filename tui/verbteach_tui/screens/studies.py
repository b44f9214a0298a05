"""Choosing a study to take part in: one of the files nearby, or another by its path."""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import partial
from pathlib import Path
from typing import ClassVar, NamedTuple

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from verbteach_tui.views.visible import visible
from verbteach_tui.widgets.foot import Foot

_EXAMPLE = "example"
_PATTERNS = ("*.toml", "*/study.toml")
_MOST = 40


class Chosen(NamedTuple):
    """A study's file that fits, and the code of a participant who comes back."""

    file: Path
    code: str | None


class StudyChooser(ModalScreen[Chosen | None]):
    """The studies in the folder that the app was started in, and the one that comes along."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "dismiss", "Back")]
    DEFAULT_CSS = """
    StudyChooser #studies { height: auto; max-height: 8; }
    StudyChooser Input { margin: 0; }
    StudyChooser #problem { color: $text-error; height: auto; max-height: 4; }
    """

    def __init__(
        self,
        scenes: Callable[[], tuple[str, ...]],
        kinds: Callable[[], Collection[str]] | None = None,
    ) -> None:
        super().__init__()
        self._scenes, self._kinds = scenes, kinds
        self._files: dict[str, Path] = {}

    def compose(self) -> ComposeResult:
        """A list, a line for another file, a line for the code."""
        with Vertical(classes="dialog") as dialog:
            dialog.border_title = "Take part in a study"
            dialog.border_subtitle = "Enter begins, Tab goes to the lines"
            yield OptionList(id="studies", compact=True)
            yield Static("Or another file, and Enter:", classes="quiet")
            yield Input(placeholder="my-study/study.toml", id="file", compact=True)
            yield Static("Your code, if you have begun before:", classes="quiet")
            yield Input(placeholder="none: you begin now", id="code", compact=True)
            yield Static("", id="problem", markup=False)
        yield Foot()

    def on_mount(self) -> None:
        """Look for studies, away from the event loop."""
        self.query_one("#studies").focus()
        self._in_a_thread(self._find)

    def _find(self) -> None:
        from verbteach_sessions.study.bundled import EXAMPLE

        here = Path.cwd()
        near = sorted(path for pattern in _PATTERNS for path in here.glob(pattern))
        found = {str(path.relative_to(here)): path for path in near if _is_study(path)}
        found = dict(list(found.items())[:_MOST])
        self.app.call_from_thread(self._list, {**found, _EXAMPLE: EXAMPLE})

    def _list(self, files: dict[str, Path]) -> None:
        self._files = files
        studies = self.query_one("#studies", OptionList)
        studies.set_options(
            Option(Content(_label(name)), id=str(number)) for number, name in enumerate(files)
        )
        studies.highlighted = 0

    def on_option_list_option_selected(self, message: OptionList.OptionSelected) -> None:
        """One of the list."""
        self._choose(list(self._files.values())[message.option_index])

    def on_input_submitted(self, message: Input.Submitted) -> None:
        """Another one, or the code for the one that is highlighted."""
        message.stop()
        named = self.query_one("#file", Input).value.strip()
        highlighted = self.query_one("#studies", OptionList).highlighted
        if named:
            self._choose(Path(named).expanduser())
        elif highlighted is not None:
            self._choose(list(self._files.values())[highlighted])

    def _choose(self, file: Path) -> None:
        code = self.query_one("#code", Input).value.strip() or None
        self._in_a_thread(partial(self._check, file, code))

    def _check(self, file: Path, code: str | None) -> None:
        """In a thread: whether the study can be begun."""
        from verbteach_sessions.names import safe_name
        from verbteach_sessions.study.study_file import read_study
        from verbteach_tui.conclusion import complaint

        try:
            read_study(file, self._scenes(), kinds=self._kinds)
            if code is not None:
                safe_name(code, "participant code")
        except Exception as error:
            said = complaint(error) or f"{type(error).__name__}: {error}"
            self.app.call_from_thread(self.query_one("#problem", Static).update, visible(said))
        else:
            self.app.call_from_thread(self.dismiss, Chosen(file, code))

    def _in_a_thread(self, work: Callable[[], None]) -> None:
        self.run_worker(work, thread=True, exit_on_error=False, group="studies")


def _is_study(path: Path) -> bool:
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            return "[study]" in file.read(100_000)
    except OSError:
        return False


def _label(name: str) -> str:
    return "The example that comes along" if name == _EXAMPLE else visible(name)
