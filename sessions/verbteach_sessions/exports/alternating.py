"""A dialogue for formats in which two speakers take turns: what held, one after the other."""

from __future__ import annotations

from dataclasses import replace

from verbteach_sessions.exports.dialogue import Dialogue, Turn


def alternating(dialogue: Dialogue) -> tuple[Turn, ...]:
    """The turns that hold; two in a row by one speaker, as when a scene began anew, made one."""
    turns: list[Turn] = []
    for turn in dialogue.held:
        if turns and turns[-1].speaker == turn.speaker:
            turns[-1] = replace(
                turn, texts=turns[-1].texts + turn.texts, acts=turns[-1].acts + turn.acts
            )
        else:
            turns.append(turn)
    return tuple(turns)
