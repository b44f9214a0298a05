"""What the person is asked for at the moment, in a few words, for the bar and the input."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from verbteach.dialogue.moves import Phase
from verbteach_tui.keys import ANSWERS, ANYTIME, Key
from verbteach_tui.snapshot import Snapshot


class Prompt(NamedTuple):
    """``lead`` opens the bar of keys, ``placeholder`` stands in the empty input."""

    lead: str
    placeholder: str


PROMPTS: Mapping[Phase, Prompt] = {
    Phase.COMMAND: Prompt("Say what to do", 'Say what the robot should do, as in "boil the water"'),
    Phase.EXECUTION: Prompt("Answer", "Answer in words, as in: no, the red one"),
    Phase.LEARNING: Prompt("Answer", "Answer in words, as in: no, the red one"),
    Phase.JUDGEMENT: Prompt("Was it right?", "Judge in words, as in: no, the other pot"),
    Phase.DEMONSTRATION: Prompt("Show it", "Type a step, as in: go to the sink"),
    Phase.READ_BACK: Prompt("Is that the goal?", "Say right or wrong"),
}


class Bar(NamedTuple):
    """What the bar of keys says: the keys that answer, and those that always work."""

    lead: str
    keys: tuple[Key, ...]
    extra: tuple[Key, ...] = ()


WATCHING = Bar(
    "Watch",
    (
        Key("x", "stop", "stop the robot here"),
        Key("space", "pause", "pause"),
        Key("e", "to_end", "to the end"),
    ),
    (
        Key("+", "faster", "faster"),
        Key("-", "slower", "slower"),
        Key("→", "forward", "step"),
        Key("←", "back", "step back"),
    ),
)
"""While an execution is being watched; the words are those of the execution's view."""


def bar_of(snapshot: Snapshot, typing: bool, watching: bool = False) -> Bar:
    """The keys that do something now."""
    if watching and not typing:
        return WATCHING
    lead = PROMPTS[snapshot.phase].lead
    if typing:
        return Bar(f"{lead}: type and press Enter", _while_typing(snapshot))
    keys = list(ANSWERS[snapshot.phase])
    if snapshot.choices:
        keys.insert(0, Key(f"1-{len(snapshot.choices)}", "", "that one"))
    return Bar(lead, tuple(keys), tuple(_always(snapshot)))


def _while_typing(snapshot: Snapshot) -> tuple[Key, ...]:
    """Leaving the line, where single keys would answer."""
    return () if snapshot.phase is Phase.COMMAND else (Key("Tab", "leave", "single keys"),)


def _always(snapshot: Snapshot) -> list[Key]:
    """The keys that work whatever the robot waits for, without those that could do nothing."""
    idle = {"undo": not snapshot.can_undo, "redo": not snapshot.can_redo}
    if snapshot.phase is Phase.DEMONSTRATION:
        idle["why"] = True
    return [key for key in ANYTIME if not idle.get(key.word, False)]
