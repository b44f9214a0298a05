"""The robot's mind: what it takes words to mean, the goals it sees, the verbs it knows."""

from __future__ import annotations

from verbteach_tui.views.mind import Mind, mind_rows
from verbteach_tui.widgets.rows_view import RowsView


class MindView(RowsView):
    """A mind drawn in sections; clicking a verb picks it."""

    HELP = (
        "The robot's mind. Which objects it takes your words to mean and how sure it is, which "
        "goals it thinks the command has, and the verbs it knows. Click a verb, or press F5, to "
        "see its hypotheses from specific to general."
    )
    BORDER_TITLE = "Robot's mind"

    def show_mind(self, mind: Mind) -> None:
        """Show ``mind``."""
        self.show_once(mind, lambda width: mind_rows(mind, width))
