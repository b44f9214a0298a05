"""asciicast v2, one file a session: the dialogue as it went by, with a marker at every turn."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from pathlib import Path
from typing import Any

from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.folder import write_text
from verbteach_sessions.exports.lines import NOTE, ROBOT, TEACHER, SpokenLine, spoken_lines, title
from verbteach_sessions.exports.wrapping import wrapped

WIDTH, HEIGHT = 100, 30
IDLE = 3.0  # seconds: players cut longer pauses down to this
_STEP = 0.05  # seconds between lines that were said at once, so that each can be seen to come

# Styles of the basic sixteen colours, so that the player's theme decides.
_NAMES: Mapping[str, tuple[str, str]] = {
    ROBOT: ("Robot: ", "\x1b[36m"),
    TEACHER: ("You:   ", "\x1b[1;33m"),
    NOTE: ("Note:  ", "\x1b[2m"),
}
_PLAIN = "\x1b[0m"


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``SESSION.cast`` for each session."""
    for dialogue in dialogues:
        rows = [_header(dialogue), *_events(dialogue)]
        text = "".join(json.dumps(row, allow_nan=False) + "\n" for row in rows)
        write_text(folder / f"{dialogue.id}.cast", text)


def _header(dialogue: Dialogue) -> dict[str, Any]:
    return {
        "version": 2,
        "width": WIDTH,
        "height": HEIGHT,
        "idle_time_limit": IDLE,
        "title": title(dialogue),
    }


def _events(dialogue: Dialogue) -> Iterator[list[Any]]:
    now = 0.0
    for number, said in groupby(spoken_lines(dialogue), key=lambda line: line.turn.number):
        lines = list(said)
        now = max(now, lines[0].turn.at)
        yield [round(now, 4), "m", _label(number, lines[0])]
        for line in lines:
            yield [round(now, 4), "o", _shown(line)]
            now += _STEP


def _label(number: int, line: SpokenLine) -> str:
    """Markers are listed in players: the turn's number and how it begins."""
    text = line.text if len(line.text) <= 40 else f"{line.text[:39]}…"
    return f"{number} {line.speaker}: {text}"


def _shown(line: SpokenLine) -> str:
    name, style = _NAMES[line.speaker]
    first, *more = wrapped(line.text, WIDTH - len(name))
    indented = "".join(f"\r\n{' ' * len(name)}{row}" for row in more)
    return f"{style}{name}{first}{indented}{_PLAIN}\r\n"
