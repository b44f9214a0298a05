"""What the person is asked for at the moment, in a few words, for the bar and the input."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach_tui.keys import NO, YES, Key, answers, anytime
from verbteach_tui.snapshot import Snapshot


class Prompt(NamedTuple):
    """``lead`` opens the bar of keys, ``placeholder`` stands in the empty input.

    While the input has not got the keys, ``example`` stands there, after how to get into it.
    """

    lead: str
    placeholder: str
    example: str


PROMPTS: Mapping[Phase, Prompt] = {
    Phase.COMMAND: Prompt(
        "Say what to do", 'Say what the robot should do, as in "boil the water"', "boil the water"
    ),
    Phase.EXECUTION: Prompt("Answer", "Answer in words, as in: no, the red one", "no, the red one"),
    Phase.LEARNING: Prompt("Answer", "Answer in words, as in: no, the red one", "no, the red one"),
    Phase.JUDGEMENT: Prompt(
        "Was it right?", "Judge in words, as in: no, the other pot", "no, the other pot"
    ),
    Phase.DEMONSTRATION: Prompt("Show it", "Type a step, as in: go to the sink", "go to the sink"),
    Phase.READ_BACK: Prompt("Is that the goal?", "Say right or wrong", "right"),
}


_COMMANDS = (
    (("kettle", "pot"), "boil the water"),
    (("tv",), "turn on the tv"),
    (("window",), "open the window"),
)
_PLACES = ("sink", "sofa", "couch", "table", "desk", "door")
"""What an example may speak of, where it is there; the first that is."""


def command_example(snapshot: Snapshot) -> str:
    """A command about something that the scene has."""
    there = snapshot.depictor.labels.find
    told = (command for things, command in _COMMANDS if any(map(there, things)))
    return next(told, "open the door")


def step_example(snapshot: Snapshot) -> str:
    """A step about something that the scene has."""
    place = next(filter(snapshot.depictor.labels.find, _PLACES), _PLACES[0])
    return f"go to the {place}"


_MORE_STEPS = 'Type the next step; "that\'s it" ends'


def prompt_of(snapshot: Snapshot) -> Prompt:
    """What is asked for now; once something was shown, how to end as well."""
    prompt = PROMPTS[snapshot.phase]
    if snapshot.phase is Phase.COMMAND:
        prompt = _about(prompt, command_example(snapshot))
    elif snapshot.phase is Phase.DEMONSTRATION:
        prompt = _about(prompt, step_example(snapshot))
    more = snapshot.phase is Phase.DEMONSTRATION and snapshot.shown
    return prompt._replace(placeholder=_MORE_STEPS) if more else prompt


def _about(prompt: Prompt, example: str) -> Prompt:
    placeholder = prompt.placeholder.replace(prompt.example, example)
    return prompt._replace(placeholder=placeholder, example=example)


ABOUT: Mapping[Phase, str] = {
    Phase.COMMAND: (
        "The robot waits for a command. Type what it should do and press Enter. A verb it does not "
        "know it asks you to show; one that it knows it carries out, and you judge the result. "
        "With F6 you go to another scene; the robot takes along what it has learned."
    ),
    Phase.EXECUTION: (
        "The robot asks before it acts. Answer with one key, with a digit or a click for an object "
        "it asks about, or in words. Each question has its price; w says why it asks."
    ),
    Phase.LEARNING: (
        "The robot asks about what you showed. Answer with one key, or in words. Each question has "
        "its price; w says why it asks."
    ),
    Phase.JUDGEMENT: (
        "The robot has carried the command out. Say whether it was right. If not, everything is "
        "put back as it was, and you show it."
    ),
    Phase.DEMONSTRATION: (
        "The robot watches. Show it step by step what the command means, and say done."
    ),
    Phase.READ_BACK: (
        "The robot reads back what it will keep as the verb's meaning: what must hold afterwards. "
        "Strike what does not matter, keep what it left out, and say whether it is right."
    ),
}
"""What is going on in each phase, for the help."""


SUGGESTED = Key("yes", f"{acts.Command.name}: yes", "that; or say it in other words")
"""What takes up a command that the robot offered instead of one it could not read."""


TYPING = Key("Tab", "type", "type a command")
"""Back into the line, where nothing waits to be answered with a key."""


UNDO, REDO = Key("^z", "undo", "undo"), Key("^y", "redo", "redo")
"""While the line has the keys."""


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


EDITING = Bar(
    "Steps",
    (
        Key("x", "remove_step", "take away"),
        Key("e", "earlier", "earlier"),
        Key("l", "later", "later"),
        Key("i", "insert_here", "insert before"),
        Key("space", "run_steps", "run"),
        Key("d", "done", "done"),
    ),
    (Key("X", "remove_rest", "and all after"), Key("u", "undo", "undo")),
)
"""While the steps of a demonstration are edited; the words are those of their view."""


def bar_of(snapshot: Snapshot, typing: bool, watching: bool = False, editing: bool = False) -> Bar:
    """The keys that do something now."""
    if watching and not typing:
        return WATCHING
    if editing and snapshot.phase is Phase.DEMONSTRATION:
        return EDITING
    lead = PROMPTS[snapshot.phase].lead
    if snapshot.suggested:
        return Bar("Is that what you meant?", (SUGGESTED,))
    if typing:
        return Bar(f"{lead}: type and press Enter", _while_typing(snapshot), _taking_back(snapshot))
    if snapshot.phase is Phase.COMMAND:
        return Bar("Single keys", (TYPING,), tuple(_always(snapshot)))
    return Bar(lead, tuple(_answers(snapshot)), tuple(_always(snapshot)))


def _answers(snapshot: Snapshot) -> list[Key]:
    """The digits that pick an object, then the phase's keys; "which?" takes no yes or no."""
    labels = snapshot.depictor.labels
    picks = [
        Key(digit, f"{acts.Point.name}: {thing}", labels[thing])
        for digit, thing in snapshot.choices.items()
    ]
    which = isinstance(snapshot.waiting, acts.NpGrdWhq)
    unfit = {YES.word, NO.word} if which else set()
    return [*picks, *(key for key in answers(snapshot.phase) if key.word not in unfit)]


def _while_typing(snapshot: Snapshot) -> tuple[Key, ...]:
    """Leaving the line, where single keys would answer."""
    return () if snapshot.phase is Phase.COMMAND else (Key("Tab", "leave", "single keys"),)


def _taking_back(snapshot: Snapshot) -> tuple[Key, ...]:
    """In the line letters are typed: there these keys take back, and do again."""
    possible = {"undo": snapshot.can_undo, "redo": snapshot.can_redo}
    return tuple(key for key in (UNDO, REDO) if possible[key.word])


def _always(snapshot: Snapshot) -> list[Key]:
    """The keys that work whatever the robot waits for, without those that could do nothing."""
    idle = {"undo": not snapshot.can_undo, "redo": not snapshot.can_redo}
    if snapshot.phase is Phase.DEMONSTRATION:
        idle["why"] = True
    return [key for key in anytime() if not idle.get(key.word, False)]
