"""Markdown in the layout of Table 1 of She & Chai (2017): execution beside learning.

H is the human, R the robot, numbered through the session; what was done rather
than said stands in brackets and italics.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import groupby
from pathlib import Path

from verbteach_sessions.exports.dialogue import TEACHER, Dialogue, Turn
from verbteach_sessions.exports.folder import write_text
from verbteach_sessions.exports.lines import summary, title
from verbteach_sessions.visible import visible

# Whatever Markdown or HTML could take for a sign of its own within a line, bare links included.
_SIGNS = re.compile(r"[\\`*_\[\]#|~<>&@{}$]|:(?=//)|(?<=www)\.", re.IGNORECASE)
_DEEDS = frozenset(
    {
        *("do", "done", "insert", "remove", "move", "object", "strike", "keep"),
        *("rule_out", "confirm", "stop", "scene", "show", "skip"),
    }
)
_LEARNING = frozenset({"demonstration", "learning", "read_back"})


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``SESSION.md`` for each session."""
    for dialogue in dialogues:
        write_text(folder / f"{dialogue.id}.md", "\n".join(page(dialogue)) + "\n")


def page(dialogue: Dialogue) -> Iterator[str]:
    """The lines of a session's page: a table row a command."""
    yield from (f"# {escaped(title(dialogue))}", "")
    yield from (f"- {name}: {escaped(value)}" for name, value in summary(dialogue))
    yield from ("", "| Execution | Learning |", "|---|---|")
    turns = _numbered(dialogue)
    for command, group in groupby(turns, key=lambda pair: pair[1].command):
        if command is not None:
            cells = _row(list(group))
            yield f"| {cells[0]} | {cells[1]} |"


def escaped(text: str) -> str:
    """Text that Markdown and HTML show as it is, in one line."""
    return _SIGNS.sub(_entity, visible(text))


def _entity(sign: re.Match[str]) -> str:
    # A backslash would do for Markdown; readers that also run HTML need the reference.
    return f"\\{sign[0]}" if sign[0] in "*_[]" else f"&#{ord(sign[0])};"


def _numbered(dialogue: Dialogue) -> Iterator[tuple[str, Turn]]:
    """The turns that hold with their labels, H1, R1, H2, as in the paper's table."""
    count = {"H": 0, "R": 0}
    for turn in dialogue.held:
        letter = "H" if turn.speaker == TEACHER else "R"
        if turn.command is not None:
            count[letter] += 1
        yield f"{letter}{count[letter]}", turn


def _row(turns: list[tuple[str, Turn]]) -> tuple[str, str]:
    """Learning begins where the robot first asks to be shown; what leads up to it is execution."""
    begin = next(
        (index for index, (_, turn) in enumerate(turns) if turn.phase in _LEARNING), len(turns)
    )
    return _cell(turns[:begin]), _cell(turns[begin:])


def _cell(turns: list[tuple[str, Turn]]) -> str:
    return "<br>".join(f"{label}: {_said(turn)}" for label, turn in turns)


def _said(turn: Turn) -> str:
    text = escaped(turn.text)
    return f"*({text})*" if turn.act_names[0] in _DEEDS and text else text
