"""The line on the home screen: what is typed in it is the first thing said in a room."""

from __future__ import annotations

from verbteach_tui.widgets.command_input import CommandInput


class FirstLine(CommandInput):
    """A line to begin with."""

    HELP = (
        "Type what the robot should do, as in: boil the water. Enter begins with that in the scene "
        "that is chosen above. The name of a scene begins there; lab, study, help and quit do what "
        "they say. Escape or Tab leaves the line."
    )

    def on_mount(self) -> None:
        """Say from the beginning what may be typed."""
        self.say_what_is_wanted()

    def say_what_is_wanted(self) -> None:
        """The same from everywhere: any letter leads here."""
        self.placeholder = "or type what it should do: boil the water"

    def action_leave(self) -> None:
        """Back to the scenes; what was begun is dropped, or its letters would be lost to keys."""
        self.clear()
        self.screen.query_one("#scene-list").focus()
