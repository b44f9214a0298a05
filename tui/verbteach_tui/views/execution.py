"""An execution being watched: which step it is at, and how that reads."""

from __future__ import annotations

from dataclasses import dataclass, replace

from verbteach_tui.views.rows import Row, Span, clipped, wrapped

SPEEDS = (0.5, 1.0, 2.0, 4.0, 8.0, 0.0)
"""Steps per second that the keys go through; 0 is all at once."""


@dataclass(frozen=True)
class Playback:
    """A plan's steps in words and how far it has been watched; ``at`` steps have been shown.

    ``failed`` is what could not be done and why, after the last step that could.
    """

    steps: tuple[str, ...]
    at: int = 0
    playing: bool = True
    speed: float = 2.0
    failed: str = ""

    @property
    def over(self) -> bool:
        """Whether every step that was done has been shown."""
        return self.at >= len(self.steps)

    def forward(self) -> Playback:
        """One step on."""
        return replace(self, at=min(self.at + 1, len(self.steps)))

    def back(self) -> Playback:
        """One step back, and standing still."""
        return replace(self, at=max(self.at - 1, 0), playing=False)

    def to_end(self) -> Playback:
        """After the last step."""
        return replace(self, at=len(self.steps), playing=False)

    def faster(self, by: int) -> Playback:
        """The next speed up (``by`` 1) or down (-1)."""
        nearest = SPEEDS.index(self.speed) if self.speed in SPEEDS else 2
        return replace(self, speed=SPEEDS[min(max(nearest + by, 0), len(SPEEDS) - 1)])


def speed_text(speed: float) -> str:
    """As in: 2 steps a second."""
    if speed == 0:
        return "all at once"
    if speed < 1:
        return f"a step in {1 / speed:g} s"
    return f"{speed:g} step{'s' * (speed != 1)} a second"


def playback_rows(playback: Playback, width: int) -> list[Row]:
    """A heading with where it is, then the steps: done, being shown, still to come."""
    rows = [_heading(playback, width)]
    for index, step in enumerate(playback.steps):
        rows += wrapped([Span(step, _style(playback, index), str(index + 1))], width, 6,
                        _prefix(playback, index))  # fmt: skip
    if playback.failed and playback.over:
        rows += wrapped([Span(playback.failed, "bad")], width, 6, [Span("    ✗ ", "bad")])
    return rows


def _heading(playback: Playback, width: int) -> Row:
    state = "all shown" if playback.over else "running" if playback.playing else "paused"
    glyph = "■" if playback.over else "►" if playback.playing else "‖"
    text = f" step {playback.at} of {len(playback.steps)}, {speed_text(playback.speed)}"
    return clipped([Span(f"{glyph} {state}", "accent"), Span(text, "muted")], width)


def _prefix(playback: Playback, index: int) -> list[Span]:
    glyph = "►" if index == playback.at - 1 else "✓" if index < playback.at else "·"
    style = "accent" if index == playback.at - 1 else "good" if index < playback.at else "muted"
    return [Span(f"{index + 1:3} ", "muted"), Span(f"{glyph} ", style)]


def _style(playback: Playback, index: int) -> str:
    return "strong" if index == playback.at - 1 else "text" if index < playback.at else "muted"
