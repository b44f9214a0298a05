"""ParlAI's conversations: one session a line as pairs of turns, with metadata beside the file."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, TextIO

from verbteach_sessions.exports.alternating import alternating
from verbteach_sessions.exports.dialogue import ROBOT, TEACHER, Dialogue, Turn

# ParlAI's names of the splits, which its teachers look for at the end of a file's name.
_SPLITS = {"train": "train", "validation": "valid", "test": "test"}
VERSION = "0.1"


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``verbteach_SPLIT.jsonl`` and ``verbteach_SPLIT.metadata`` for each split there is."""
    files: dict[str, TextIO] = {}
    try:
        for dialogue in dialogues:
            name = f"verbteach_{_SPLITS[dialogue.split]}"
            if name not in files:
                files[name] = (folder / f"{name}.jsonl").open("w", encoding="ascii")
                metadata = json.dumps(_metadata(), indent=2)
                (folder / f"{name}.metadata").write_text(metadata, encoding="ascii")
            files[name].write(json.dumps(_line(dialogue, name), allow_nan=False) + "\n")
    finally:
        for file in files.values():
            file.close()


def _metadata() -> dict[str, Any]:
    return {
        "date": "not told",  # the format wants one; an export holds no time of day
        "opt": {"task": "verbteach"},
        "self_chat": False,
        "speakers": [TEACHER, ROBOT],
        "version": VERSION,
    }


def _line(dialogue: Dialogue, name: str) -> dict[str, Any]:
    turns = [_turn(turn) for turn in alternating(dialogue)]
    # Pairs begin with the teacher: what the robot opens with is context.
    opening = 1 if turns and turns[0]["id"] == ROBOT else 0
    return {
        "session": dialogue.id,
        "participant": dialogue.participant,
        "scene": dialogue.scene,
        "policy": dialogue.policy,
        "context": turns[:opening],
        "dialog": list(_pairs(turns[opening:])),
        "metadata_path": f"{name}.metadata",
    }


def _pairs(turns: list[dict[str, Any]]) -> Iterator[list[dict[str, Any]]]:
    for start in range(0, len(turns), 2):
        yield turns[start : start + 2]


def _turn(turn: Turn) -> dict[str, Any]:
    return {
        "id": turn.speaker,
        "text": turn.text,
        "acts": [dict(act) for act in turn.acts],
        "at": turn.at,
        "phase": turn.phase,
        "reward": turn.reward,
    }
