"""The teacher's script: what a person at the keyboard can say, one act a line.

Only the words are known here, not when they fit. ``render`` writes the line
that ``parse_line`` reads as the same act.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import TypeAlias

from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.world.fluents import Literal
from verbteach.world.plan import Action
from verbteach_sessions import session_acts
from verbteach_sessions.session_acts import SessionAct

ScriptAct: TypeAlias = TeacherAct | SessionAct


class LineSyntaxError(ValueError):
    """A line names an act and is none all the same; the message says why."""


WORDS: Mapping[str, ScriptAct] = {
    act.name: act
    for act in (
        acts.Yes(),
        acts.No(),
        acts.Unsure(),
        acts.Skip(),
        acts.Done(),
        acts.Good(),
        acts.Bad(),
        acts.Stop(),
        acts.Show(),
        session_acts.Why(),
        session_acts.Repeat(),
        session_acts.Undo(),
        session_acts.Redo(),
        session_acts.Flag(),
        session_acts.Quit(),
    )
}


def _name(text: str) -> str:
    if len(text.split()) != 1:
        raise ValueError("one name is needed")
    return text


def _steps(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 10):
        raise ValueError("a number of steps is needed")
    return int(text)


# What follows "word: " is read by these; the first group is prose and kept to the letter.
_PROSE: Mapping[str, Callable[[str], ScriptAct]] = {
    acts.Command.name: acts.Command,
    session_acts.Note.name: session_acts.Note,
    acts.Say.name: acts.Say,
}
_TERMS: Mapping[str, Callable[[str], ScriptAct]] = {
    acts.Point.name: lambda text: acts.Point(_name(text)),
    acts.GoToScene.name: lambda text: acts.GoToScene(_name(text)),
    acts.Do.name: lambda text: acts.Do(Action.parse(text)),
    acts.Strike.name: lambda text: acts.Strike(Literal.parse(text)),
    acts.Keep.name: lambda text: acts.Keep(Literal.parse(text)),
    acts.Stop.name: lambda text: acts.Stop(_steps(text)),
}
PREFIXES = (*_PROSE, *_TERMS)


def parse_line(line: str) -> ScriptAct | None:
    """The act of one line, ``None`` for a blank line or a comment.

    What is no word of the script is free text, an answer. After a word or a
    term a remark may follow, from a ``#`` with a space before it; prose keeps
    its ``#``. Raises :class:`LineSyntaxError`.
    """
    text = line.strip()
    if not text or text.startswith("#"):
        return None
    bare = _without_remark(text)
    if bare in WORDS:
        return WORDS[bare]
    prefix, colon, rest = (part.strip() for part in text.partition(":"))
    if colon and prefix in _PROSE:
        return _PROSE[prefix](rest)
    if colon and prefix in _TERMS:
        return _term(prefix, _without_remark(rest))
    return acts.Say(text)


def render(act: ScriptAct) -> str:
    """The line of an act. Raises ``ValueError`` for a text that no line can hold."""
    line = next((c for c in _candidates(act) if _says(c, act)), None)
    if line is None:
        raise ValueError(f"no line of a script can hold this: {act}")
    return line


def spoken(act: ScriptAct) -> str:
    """The act as the teacher said it, for people to read: a render without the prefix."""
    match act:
        case acts.Command(text=text) | acts.Say(text=text) | session_acts.Note(text=text):
            return text
    return _candidates(act)[-1].removeprefix(f"{act.name}: ")


def _term(prefix: str, text: str) -> ScriptAct:
    try:
        return _TERMS[prefix](text)
    except ValueError as error:
        raise LineSyntaxError(f"'{prefix}: {text}' cannot be read, {error}") from error


def _without_remark(text: str) -> str:
    for mark in (" #", "\t#"):
        text = text.partition(mark)[0].rstrip()
    return "" if text.startswith("#") else text


def _says(line: str, act: ScriptAct) -> bool:
    try:
        return len(line.splitlines()) == 1 and parse_line(line) == act
    except LineSyntaxError:
        return False


def _candidates(act: ScriptAct) -> tuple[str, ...]:
    """Lines that may say the act, the best first."""
    match act:
        case acts.Say(text=text):
            return text, f"say: {text}"
        case acts.Stop(step=0):
            return (act.name,)
    terms = [str(getattr(act, field.name)) for field in fields(act)]
    return (": ".join([act.name, *terms]),)
