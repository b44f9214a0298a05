"""A line that a person typed, read as an act by what the robot waits for.

The app's input and the plain mode read with the same rules, so that the same
words give the same record: the script's words and prefixes always count, a
short key counts where the bar shows it, and what is left is a command, an
action to demonstrate, or free text for the robot to make sense of.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach_sessions.script import PREFIXES, WORDS, ScriptAct, parse_line
from verbteach_sessions.session_acts import Note
from verbteach_tui.keys import ANYTIME, anytime, word_of
from verbteach_tui.views.steps import StepMenu

_ALWAYS = frozenset(key.word for key in ANYTIME) | {"quit"}
_PLACED = re.compile(r"insert:?\s*(?P<at>\d{1,4})\s*:?\s+(?P<step>.+)")
"""As in: insert 2 go to the sink."""

_AND_DONE = re.compile(
    r"(?P<steps>.*?\w)(?:\s*[,;.]\s*(?:(?:and|then)\s+)*|\s+(?:(?:and|then)\s+)+)"
    r"(?P<done>done|finished|that(?:'s|s| is) (?:it|all)|i(?:'m|m| am) (?:done|finished))[.!]*",
    re.IGNORECASE,
)
"""Steps and the end of the demonstration in one line, as in: open it, done."""

_ROOM = re.compile(
    r"(?:scene\s+(?P<named>\S+)"
    r"|go\s+to\s+(?P<numbered>[a-z]+(?:-[a-z0-9]+)*-\d+)"
    r"|(?:go|move|change|switch)\s+(?:back\s+)?to\s+(?:the\s+)?"
    r"(?P<room>(?:[a-z]+[\s-])?(?:kitchen|room))[\s-]+(?:number\s+)?(?P<number>\d+))[.!]?",
    re.IGNORECASE,
)
"""A scene as a person may name it: scene kitchen-3; go to kitchen-3; go to the living room 2."""

_SESSION: Mapping[str, str] = {
    **dict.fromkeys(
        (
            *("undo that", "undo it", "undo please", "take that back", "take it back"),
            *("please undo", "undo that please", "undo it please", "please undo that", "undo this"),
        ),
        "undo",
    ),
    **dict.fromkeys(
        (
            *("repeat please", "please repeat", "say that again", "say that again please"),
            *("come again", "what did you say", "what was that", "what was the question"),
            *("repeat the question", "pardon", "pardon me"),
        ),
        "repeat",
    ),
    **dict.fromkeys(
        ("why do you ask", "why are you asking", "why do you ask that", "why did you do that"),
        "why",
    ),
    **dict.fromkeys(("redo that", "redo it"), "redo"),
    **dict.fromkeys(("exit", "bye", "goodbye", "good bye", "quit please", "please quit"), "quit"),
}
"""Other ways to say a word of the session."""

_VERDICTS: Mapping[ScriptAct, ScriptAct] = {acts.Yes(): acts.Good(), acts.No(): acts.Bad()}


def lines_of(line: str, phase: Phase) -> tuple[str, ...]:
    """The lines that a typed one stands for: steps and "done" behind them are two."""
    both = _AND_DONE.fullmatch(line.strip()) if phase is Phase.DEMONSTRATION else None
    return (both["steps"], both["done"]) if both else (line,)


def without_slash(line: str) -> str:
    """What was typed, without the slash that words begin with elsewhere, as in: /quit."""
    text = line.strip()
    return text.lstrip("/").lstrip() or text


def _of_the_session(text: str) -> str:
    """The word where the line says no more than it in any letters, as in "Undo that."."""
    bare = " ".join(text.lower().replace(",", " ").rstrip(" .!?").split())
    word = _SESSION.get(bare, bare)
    return word if word in _ALWAYS else text


def _scene(room: re.Match[str]) -> str:
    """The name of the scene, as in kitchen-3."""
    said: str = room["named"] or room["numbered"] or f"{room['room']}-{room['number']}"
    return "-".join(said.lower().split())


@dataclass(frozen=True)
class Reader:
    """Reads lines in one situation.

    ``choices`` are the objects that digits stand for; ``menu`` knows the actions
    while something is demonstrated.
    """

    phase: Phase
    choices: Mapping[str, str] = field(default_factory=dict)
    menu: StepMenu | None = None

    def read(self, line: str) -> ScriptAct | None:
        """The act of ``line``; ``None`` where there is nothing in it.

        Raises ``LineSyntaxError`` where a word of the script is used wrongly.
        """
        text = _of_the_session(without_slash(line))
        if not text:
            return None
        if self.phase is Phase.COMMAND:
            return self._command(text)
        if text in self.choices:
            return acts.Point(self.choices[text])
        act = self._demonstrated(text) or self._word(text) or parse_line(text) or acts.Say(text)
        if act == acts.Stop() and self.phase is not Phase.JUDGEMENT:
            return acts.Say(text)  # nothing is being done that could be stopped: enough of this
        if self.phase in (Phase.JUDGEMENT, Phase.READ_BACK):
            return _VERDICTS.get(act, act)
        return act

    def _command(self, text: str) -> ScriptAct | None:
        """A word of the session, a line with a prefix, a room, else a command to the letter."""
        if any(text == key.key for key in anytime()):
            return self._word(text)
        prefix, colon, _ = text.partition(":")
        if text in _ALWAYS or (colon and prefix.strip() in PREFIXES):
            return parse_line(text)
        room = _ROOM.fullmatch(text)
        if room:
            return acts.GoToScene(_scene(room))
        return acts.Command(text)

    def _word(self, text: str) -> ScriptAct | None:
        word = word_of(text, self.phase)
        if word == Note.name:
            return Note("")
        return WORDS[word] if word else None

    def _demonstrated(self, text: str) -> ScriptAct | None:
        if self.phase is not Phase.DEMONSTRATION or self.menu is None:
            return None
        action = self.menu.find(text)
        if action:
            return acts.Do(action)
        placed = _PLACED.fullmatch(text)
        action = self.menu.find(placed["step"]) if placed else None
        return acts.Insert(int(placed["at"]), action) if placed and action else None
