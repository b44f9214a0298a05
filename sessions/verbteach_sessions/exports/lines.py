"""A dialogue as lines for people to read: who speaks, in text that can act on nothing.

The Markdown, asciicast and SVG exports, and whatever else shows plain words, draw these.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from verbteach_sessions import events as kinds
from verbteach_sessions.exports.dialogue import ROBOT, TEACHER, Dialogue, Turn
from verbteach_sessions.visible import visible

NOTE = "note"
_ASIDE = (kinds.NOTE, kinds.FLAGGED)


class SpokenLine(NamedTuple):
    """One sentence or act: ``speaker`` is ``robot``, ``teacher`` or ``note``; text is visible."""

    speaker: str
    text: str
    turn: Turn


def spoken_lines(dialogue: Dialogue) -> Iterator[SpokenLine]:
    """What held, and the notes beside it, in order. Every line is printable text in one row."""
    for turn in dialogue.turns:
        if turn.holds and turn.kind not in (kinds.UNDO, kinds.REDO):
            speaker = NOTE if turn.kind in _ASIDE else turn.speaker
            for text in turn.texts:
                if text or speaker == TEACHER:
                    yield SpokenLine(speaker, visible(text), turn)


def title(dialogue: Dialogue) -> str:
    """What an export of one session is headed with."""
    verbs = ", ".join(dialogue.verbs_learned)
    about = f"verbs learned: {verbs}" if verbs else "no verb learned"
    return visible(f"Session {dialogue.id}, {about}")


def summary(dialogue: Dialogue) -> tuple[tuple[str, str], ...]:
    """Facts of a session by name, as visible text."""
    minutes, seconds = divmod(round(dialogue.seconds), 60)
    asked = sum(turn.question is not None for turn in dialogue.held)
    facts = (
        ("taught by", dialogue.teacher),
        ("participant", dialogue.participant or "none"),
        ("began in", dialogue.scene),
        ("question policy", dialogue.policy),
        ("length", f"{minutes} min {seconds} s"),
        ("turns", str(len(dialogue.held))),
        ("questions", str(asked)),
    )
    return tuple((name, visible(value)) for name, value in facts)


__all__ = ["NOTE", "ROBOT", "TEACHER", "SpokenLine", "spoken_lines", "summary", "title"]
