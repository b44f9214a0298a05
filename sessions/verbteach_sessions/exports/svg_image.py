"""SVG, one picture a session: the dialogue in speech bubbles, on a light or a dark ground."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby
from pathlib import Path
from xml.sax.saxutils import escape

from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.folder import write_text
from verbteach_sessions.exports.lines import NOTE, TEACHER, SpokenLine, spoken_lines, title
from verbteach_sessions.exports.wrapping import cells, wrapped

WIDTH = 880  # pixels
_CELL, _ROW, _PAD, _GAP, _EDGE = 8.4, 20, 12, 10, 24
_COLUMNS = 72
_FONT = "ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, monospace"
# No variables: not every viewer knows them.
_STYLE = f"""
    svg {{ font: 14px {_FONT}; }}
    text {{ fill: #1b1f24; white-space: pre; }} .head {{ font-weight: bold; }}
    .who {{ fill: #57606a; font-size: 12px; }} .ground {{ fill: #ffffff; }}
    .robot {{ fill: #ddeefb; }} .teacher {{ fill: #fff0cc; }} .note {{ fill: #eceff2; }}
    @media (prefers-color-scheme: dark) {{
      text {{ fill: #e8ebef; }} .who {{ fill: #a3adb8; }} .ground {{ fill: #14181d; }}
      .robot {{ fill: #173a56; }} .teacher {{ fill: #4f3c0c; }} .note {{ fill: #2a3038; }} }}
"""
_WHO = {"robot": "Robot", "teacher": "Teacher", "note": "Note"}


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``SESSION.svg`` for each session."""
    for dialogue in dialogues:
        write_text(folder / f"{dialogue.id}.svg", picture(dialogue))


def picture(dialogue: Dialogue) -> str:
    """The whole dialogue as one SVG document, with no script and nothing from elsewhere."""
    y = 2.0 * _EDGE + _ROW
    parts = []
    for _, said in groupby(spoken_lines(dialogue), key=lambda line: line.turn.number):
        bubble = _Bubble(list(said), y)
        parts.append("\n".join(bubble.drawn()))
        y = bubble.bottom + _GAP
    height = round(y + _EDGE)
    head = escape(title(dialogue))
    opening = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}"'
        f' viewBox="0 0 {WIDTH} {height}" role="img" aria-labelledby="title">'
    )
    lines = [
        opening,
        f'<title id="title">{head}</title>',
        f"<style>{_STYLE}</style>",
        f'<rect class="ground" width="{WIDTH}" height="{height}"/>',
        f'<text class="head" x="{_EDGE}" y="{_EDGE + 14}">{head}</text>',
        *parts,
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


class _Bubble:
    """One turn: the teacher's to the right, all else to the left."""

    def __init__(self, lines: list[SpokenLine], top: float) -> None:
        self._speaker = lines[0].speaker
        self._rows = [row for line in lines for row in wrapped(line.text, _COLUMNS)]
        self._number = lines[0].turn.number
        self._top = top
        self._width = max(map(cells, self._rows)) * _CELL + 2 * _PAD
        self._height = len(self._rows) * _ROW + 2 * _PAD - 4
        self._left = WIDTH - _EDGE - self._width if self._speaker == TEACHER else _EDGE
        if self._speaker == NOTE:
            self._left = (WIDTH - self._width) / 2

    @property
    def bottom(self) -> float:
        """Where the bubble ends."""
        return self._top + 16 + self._height

    def drawn(self) -> Iterator[str]:
        """The SVG elements."""
        left, top = f"{self._left:.1f}", self._top + 16
        right = self._left + self._width
        anchored = (
            f'x="{right:.1f}" text-anchor="end"' if self._speaker == TEACHER else f'x="{left}"'
        )
        who = f"{_WHO[self._speaker]} {self._number}"
        yield f'<text class="who" {anchored} y="{self._top + 10:.0f}">{who}</text>'
        yield (
            f'<rect class="{self._speaker}" x="{left}" y="{top:.0f}" rx="10"'
            f' width="{self._width:.1f}" height="{self._height}"/>'
        )
        for index, row in enumerate(self._rows):
            y = top + _PAD + 12 + index * _ROW
            yield f'<text x="{self._left + _PAD:.1f}" y="{y:.0f}">{escape(row)}</text>'
