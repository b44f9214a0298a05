"""The teacher's script: what a person at the keyboard can say, one act a line.

Only the words are known here, not when they fit. ``render`` writes the line
that ``parse_line`` reads as the same act.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import TypeAlias, TypeVar

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


def _number(text: str, of: str = "steps", least: int = 0) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 10) or int(text) < least:
        raise ValueError(f"a number of {of} is needed")
    return int(text)


def _turns(text: str) -> int:
    return _number(text, "turns", 1)


def _place(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 10):
        raise ValueError("a step's number is needed")
    return int(text)


def _insert(text: str) -> acts.Insert:
    at, _, action = text.partition(" ")
    return acts.Insert(_place(at), Action.parse(action))


def _remove(text: str) -> acts.Remove:
    first, dash, last = (part.strip() for part in text.partition("-"))
    return acts.Remove(_place(first), _place(last) if dash else _place(first))


def _move(text: str) -> acts.Move:
    at, _, to = text.partition(" ")
    return acts.Move(_place(at), _place(to.strip()))


_Learned = TypeVar("_Learned", acts.RuleOut, acts.Confirm)


def _learned(kind: type[_Learned], text: str) -> _Learned:
    """As in: boil/1 (on <cookware>0 <burner>0) of (hot ?0) (on <cookware>0 <burner>0)."""
    frame, _, rest = text.partition(" ")
    literal, of, hypothesis = rest.partition(" of ")
    if not of:
        raise ValueError("a frame, a fluent and its hypothesis are needed")
    return kind(frame, frozenset(literals(hypothesis)), Literal.parse(literal))


def literals(text: str) -> list[Literal]:
    """Read literals that stand side by side, each in its parentheses."""
    found, depth, start = [], 0, 0
    for index, character in enumerate(text):
        if character == "(":
            start = index if depth == 0 else start
            depth += 1
        elif character == ")":
            depth -= 1
            if depth == 0:
                found.append(Literal.parse(text[start : index + 1]))
        elif depth == 0 and not character.isspace():
            raise ValueError("each fluent needs its parentheses")
    if depth or not found:
        raise ValueError("each fluent needs its parentheses")
    return found


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
    acts.Stop.name: lambda text: acts.Stop(_number(text)),
    acts.Insert.name: _insert,
    acts.Remove.name: _remove,
    acts.Move.name: _move,
    acts.RuleOut.name: lambda text: _learned(acts.RuleOut, text),
    acts.Confirm.name: lambda text: _learned(acts.Confirm, text),
    session_acts.Undo.name: lambda text: session_acts.Undo(_turns(text)),
    session_acts.Redo.name: lambda text: session_acts.Redo(_turns(text)),
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
        case acts.Stop(step=0) | session_acts.Undo(turns=1) | session_acts.Redo(turns=1):
            return (act.name,)
    terms = _terms(act)
    return (": ".join([act.name, *([" ".join(terms)] if terms else [])]),)


def _terms(act: ScriptAct) -> list[str]:
    """What stands after the act's name, word by word."""
    match act:
        case acts.Remove(first=first, last=last) if first != last:
            return [f"{first}-{last}"]
        case acts.Remove(first=first):
            return [str(first)]
        case acts.RuleOut(frame=frame) | acts.Confirm(frame=frame):
            hypothesis = sorted(str(literal) for literal in act.hypothesis)
            return [frame, str(act.literal), "of", *hypothesis]
    return [str(getattr(act, field.name)) for field in fields(act)]
