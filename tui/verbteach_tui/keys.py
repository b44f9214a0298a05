"""One key, no Enter: which key says which word, by what the robot waits for.

A word is one of the teacher's script, so that a key, a typed word, a button and
a script come to the same act. This table is the only place that knows the keys;
the app's bar, the plain mode's short words and the help are made from it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from verbteach.dialogue.moves import Phase


class Key(NamedTuple):
    """A key as the teacher presses it, the word it says, and how the bar names it."""

    key: str
    word: str
    label: str


YES = Key("y", "yes", "yes")
NO = Key("n", "no", "no")
UNSURE = Key("?", "unsure", "don't know")
SKIP = Key("s", "skip", "skip")
SHOW = Key("t", "show", "let me show you")

_QUESTION = (YES, NO, UNSURE, SKIP, SHOW)

ANSWERS: Mapping[Phase, tuple[Key, ...]] = {
    Phase.COMMAND: (),
    Phase.EXECUTION: _QUESTION,
    Phase.LEARNING: _QUESTION,
    Phase.JUDGEMENT: (
        Key("g", "good", "good"),
        Key("b", "bad", "wrong"),
        SHOW,
        Key("s", "skip", "no verdict"),
    ),
    Phase.DEMONSTRATION: (Key("d", "done", "done"), Key("s", "skip", "don't show it")),
    Phase.READ_BACK: (
        Key("y", "good", "right"),
        Key("n", "bad", "wrong"),
        Key("t", "show", "show again"),
        Key("s", "skip", "keep nothing"),
    ),
}
"""What answers the robot, by phase, in the order of the bar."""

ALSO: Mapping[Phase, tuple[Key, ...]] = {
    Phase.JUDGEMENT: (Key("y", "good", "good"), Key("n", "bad", "wrong")),
    Phase.READ_BACK: (Key("g", "good", "right"), Key("b", "bad", "wrong")),
}
"""Keys that mean the same as one of ``ANSWERS`` and need no place in the bar."""

ANYTIME: tuple[Key, ...] = (
    Key("w", "why", "why?"),
    Key("r", "repeat", "repeat"),
    Key("u", "undo", "undo"),
    Key("U", "redo", "redo"),
    Key("f", "flag", "flag"),
    Key("m", "note", "note"),
)
"""What can be said whatever the robot waits for."""

MEANS: Mapping[str, str] = {
    "why": "why the robot asks or does what it does",
    "repeat": "what the robot said last, again",
    "undo": "takes back what you said last",
    "redo": "says again what you took back",
    "flag": "marks the turn as odd",
    "note": "keeps a note of yours beside the turn",
}
"""What a word comes to, where the bar's short label would say too little."""


def told(key: Key) -> str:
    """What a key says, for the help: never the same word twice."""
    if key.word in MEANS:
        return f"{key.word}: {MEANS[key.word]}"
    return key.label if key.label == key.word else f"{key.label} (in words: {key.word})"


DIGITS = "123456789"


SAID: Mapping[str, str] = {
    **{"yes": "y", "no": "n", "unsure": "?", "skip": "s", "show": "t"},
    **{"good": "g", "bad": "b", "done": "d", "why": "w", "repeat": "r"},
    **{"undo": "u", "redo": "U", "flag": "f", "note": "m"},
}
"""The single keys by the names under which a person may choose others."""

_chosen: dict[str, str] = {}


def choose_keys(keys: Mapping[str, str]) -> None:
    """From now on the names of ``SAID`` that ``keys`` has are said with those keys."""
    _chosen.clear()
    _chosen.update({SAID[name]: key for name, key in keys.items()})


def answers(phase: Phase) -> tuple[Key, ...]:
    """What answers the robot in ``phase``, as in ``ANSWERS`` but with the person's own keys."""
    return _own(ANSWERS[phase])


def anytime() -> tuple[Key, ...]:
    """What can be said at any time, with the person's own keys."""
    return _own(ANYTIME)


def _own(keys: tuple[Key, ...]) -> tuple[Key, ...]:
    return tuple(key._replace(key=_chosen.get(key.key, key.key)) for key in keys)


def answer_keys(phase: Phase) -> tuple[Key, ...]:
    """Every key that answers in ``phase``, those without a place in the bar last."""
    return (*answers(phase), *_own(ALSO.get(phase, ())))


def word_of(key: str, phase: Phase) -> str | None:
    """The word that ``key`` says while the robot waits for ``phase``; ``None`` if none."""
    for entry in (*answer_keys(phase), *anytime()):
        if entry.key == key:
            return entry.word
    return None
