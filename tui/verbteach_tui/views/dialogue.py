"""The dialogue as rows: who spoke, what was said, what kind of act it was and what it cost."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from verbteach_tui.views.rows import Row, Span, clipped, padded, width_of, wrapped
from verbteach_tui.views.visible import shortened

CONSEQUENCE = "consequence"
"""Who says what an answer came to: the robot, to itself."""

SPEAKERS = {"robot": "Robot", "teacher": "You", "note": "Note", CONSEQUENCE: ""}
"""How each speaker is named; the plain mode uses the same words."""

_GUTTER = 7
_STYLES = {"note": "note", CONSEQUENCE: "good"}


class DialogueLine(NamedTuple):
    """One thing said. ``tag`` is the act's name in the field's words, ``price`` as shown."""

    speaker: str
    text: str
    tag: str = ""
    price: str = ""


def dialogue_rows(lines: Iterable[DialogueLine], width: int) -> list[Row]:
    """All lines drawn one after the other; a change of speaker to the teacher opens a gap."""
    rows: list[Row] = []
    speaker = ""
    for line in lines:
        rows.extend(line_rows(line, speaker, width))
        speaker = line.speaker
    return rows


def line_rows(line: DialogueLine, previous: str, width: int) -> list[Row]:
    """One line drawn; ``previous`` is who spoke before it ("" for nobody)."""
    name = SPEAKERS.get(line.speaker, line.speaker) if line.speaker != previous else ""
    gutter = padded([Span(name, line.speaker if name else "text")], _GUTTER)
    style = _STYLES.get(line.speaker, "text")
    lead = [Span("→ ", style)] if line.speaker == CONSEQUENCE else []
    rows = wrapped([*lead, Span(shortened(line.text), style)], width, _GUTTER, gutter)
    tag = _tag(line)
    if tag:
        rows = _tagged(rows, tag, width)
    opening: list[Row] = [()] if previous and line.speaker == "teacher" != previous else []
    return opening + rows


def _tag(line: DialogueLine) -> str:
    return " ".join(part for part in (line.tag, line.price) if part)


def _tagged(rows: list[Row], tag: str, width: int) -> list[Row]:
    """The tag at the right of the last row where there is room, else on a row of its own."""
    label = clipped([Span(f"  {tag}", "tag")], width)
    room = width - width_of(rows[-1]) - width_of(label)
    if room >= 0:
        return [*rows[:-1], (*rows[-1], Span(" " * room), *label)]
    free = max(width - width_of(label), 0)
    return [*rows, (Span(" " * free), *label)]


def common(old: Sequence[DialogueLine], new: Sequence[DialogueLine]) -> int:
    """How many lines at the beginning are the same."""
    for index, (one, other) in enumerate(zip(old, new, strict=False)):
        if one != other:
            return index
    return min(len(old), len(new))
