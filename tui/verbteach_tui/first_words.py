"""What a line means that is typed where no robot listens yet: on the home screen.

Most lines are a first command, to begin with in the room that is chosen. A
few words and the names of rooms mean the home screen itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TypeAlias


@dataclass(frozen=True)
class Begin:
    """Begin in ``scene`` ("": the one that is chosen), by saying ``command`` ("": nothing yet)."""

    scene: str = ""
    command: str = ""


@dataclass(frozen=True)
class Go:
    """Do what a key of the home screen does, by its action's name."""

    action: str


FirstWords: TypeAlias = Begin | Go

_PLACES: Mapping[str, tuple[str, ...]] = {
    "app.help": ("help", "help me", "h", "?", "f1"),
    "app.quit": ("q", "quit", "exit", "leave", "bye", "close"),
    "app.lab": ("l", "lab", "train", "compare", "evaluate"),
    "app.study": ("s", "study", "studies", "take part"),
    "sessions": ("c", "continue", "resume", "go on", "sessions"),
    "play_back": ("p", "play", "replay", "play back"),
    "scenes": ("n", "new", "scenes", "rooms"),
}
_WORDS = {word: Go(action) for action, words in _PLACES.items() for word in words}
_BEGINNING = frozenset({"teach", "begin", "start", "go"})
_BEFORE_A_ROOM = ("go to the ", "go to ", "scene: ", "scene ", "open ")
_PROGRAM = "verbteach "
_AROUND = " .,!"


def first_words(line: str, scenes: Iterable[str]) -> FirstWords:
    """What ``line`` means; ``scenes`` are the names of the rooms there are."""
    said = line.strip().lstrip("/ ")
    word = " ".join(said.lower().rstrip(_AROUND).split()).removeprefix(_PROGRAM)
    if word in _WORDS:
        return _WORDS[word]
    if word in _BEGINNING:
        return Begin()
    room = _room(word, scenes)
    return Begin(scene=room) if room else Begin(command=said)


def _room(word: str, scenes: Iterable[str]) -> str:
    """The scene that ``word`` names, as in "kitchen 3" or "go to kitchen-3"; "" for none."""
    for before in _BEFORE_A_ROOM:
        word = word.removeprefix(before)
    named = {scene.lower().replace("-", " "): scene for scene in scenes}
    return named.get(word.replace("-", " "), "")
