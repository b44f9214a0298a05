"""The scene: furniture, what is in and on it and how it is, with what just changed marked."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from textual import events

from verbteach_tui.views.cards import Arrangement, Emphasis, arrange, beside, half, picture_rows
from verbteach_tui.views.rows import Row, Span, plain
from verbteach_tui.widgets.rows_view import RowsView

if TYPE_CHECKING:
    from verbteach_tui.views.picture import Picture


class SceneView(RowsView):
    """A picture drawn in cards; clicking an object picks it."""

    HELP = (
        "The scene as it is. Each box is a piece of furniture with what is in and on it. ✱ marks "
        "what the last step changed, [1] or ? what a question is about. Click an object to point "
        "at it; hold the mouse over it to read its name in the record. F7 puts beside it what the "
        "robot saw when it got the command: 'open? 62%' is what it is not sure of."
    )
    BORDER_TITLE = "Scene"

    def __init__(self, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._picture: Picture | None = None
        self._believed: Picture | None = None
        self._emphasis = Emphasis()
        self._arrangements: dict[tuple[str, int], Arrangement] = {}

    def show_picture(
        self,
        picture: Picture,
        emphasis: Emphasis | None = None,
        news: Sequence[str] = (),
        believed: Picture | None = None,
    ) -> None:
        """Show ``picture``; ``news`` says in words what just changed.

        ``believed`` is what the robot takes the scene for, shown beside it.
        """
        self._picture, self._believed = picture, believed
        self.heading = 0 if believed is None else 1  # the two titles stay in view
        self._emphasis = emphasis or Emphasis()
        self.border_title = picture.title
        self.border_subtitle = f"✱ {'; '.join(news)}" if news else ""
        self.show(self._drawn)
        self._reveal_change()

    def on_resize(self, event: events.Resize) -> None:
        """What changed, and what a question is about, comes into view at every size."""
        self._reveal_change()

    def _drawn(self, width: int) -> Sequence[Row]:
        if self._picture is None:
            return ()
        if self._believed is None:
            return self._depicted(self._picture, width)
        truth, belief = (self._depicted(p, half(width)) for p in (self._picture, self._believed))
        return beside(truth, belief, width, ("As it is", "As the robot saw it"))

    def _depicted(self, picture: Picture, width: int) -> Sequence[Row]:
        key = (picture.title, width)
        if key not in self._arrangements:
            self._arrangements[key] = arrange(picture, width)
        return picture_rows(picture, width, self._arrangements[key], self._emphasis)

    def _reveal_change(self) -> None:
        """Bring into view what is asked about, else what changed, else where the robot stands."""
        asked = self._rows_with(lambda span: span.style == "asked")
        marked = self._rows_with(lambda span: span.style == "new")
        wanted = asked or marked or self._rows_with(lambda span: "◂" in span.text)
        if wanted and self.size.height:
            self.reveal(wanted[0], min(wanted[-1], wanted[0] + self.size.height - 1))

    def _rows_with(self, meant: Callable[[Span], bool]) -> list[int]:
        return [number for number, row in enumerate(self.rows) if any(map(meant, row))]

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Name the object under the mouse as the record names it."""
        self.tooltip = self.target_at(event) or None

    @property
    def text(self) -> str:
        """What is shown, without styles."""
        return "\n".join(plain(row) for row in self.rows)
