"""Frames as one line of text, and as plain data for JSON.

``bring(obj=mug[red,on:counter]; to=me) && turn_on(obj=tv)``: spaces in verbs,
roles and modifiers become underscores, clauses join with ``&&``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TypedDict

from verbteach.language.frames import Argument, NounPhrase, VerbFrame


class ArgumentData(TypedDict):
    """An argument as the ``parse`` command prints it."""

    role: str
    head: str
    modifiers: list[str]
    text: str


class FrameData(TypedDict):
    """A frame as the ``parse`` command prints it."""

    verb: str
    arguments: list[ArgumentData]


class NotationError(ValueError):
    """A text is not a frame in this notation."""


def write_frames(frames: Iterable[VerbFrame]) -> str:
    """The frames on one line; no frame gives an empty text."""
    return " && ".join(
        f"{_close(frame.verb)}({'; '.join(_argument(a) for a in frame.arguments)})"
        for frame in frames
    )


def _argument(argument: Argument) -> str:
    return f"{_close(argument.role)}={_phrase(argument.phrase)}"


def _phrase(phrase: NounPhrase) -> str:
    inner = modifiers(phrase)
    return phrase.head + (f"[{','.join(inner)}]" if inner else "")


def modifiers(phrase: NounPhrase) -> list[str]:
    """The phrase's modifiers and its relations, each written as ``on:table``."""
    said = [_close(modifier) for modifier in phrase.modifiers]
    return said + [f"{_close(name)}:{_phrase(inner)}" for name, inner in phrase.relations]


def _close(text: str) -> str:
    return text.replace(" ", "_")


def as_data(frames: Iterable[VerbFrame]) -> list[FrameData]:
    """The frames as the ``parse`` command prints them: verb, arguments, role, head, modifiers."""
    return [
        {
            "verb": frame.verb,
            "arguments": [
                {
                    "role": argument.role,
                    "head": argument.phrase.head,
                    "modifiers": modifiers(argument.phrase),
                    "text": argument.phrase.text,
                }
                for argument in frame.arguments
            ],
        }
        for frame in frames
    ]


def read_frames(text: str) -> tuple[VerbFrame, ...]:
    """Read the line that ``write_frames`` writes; ``NotationError`` where it is none."""
    return tuple(_frame(part.strip()) for part in text.split("&&") if part.strip())


def _frame(text: str) -> VerbFrame:
    verb, bracket, rest = text.partition("(")
    if not bracket or not rest.endswith(")") or not verb.strip():
        raise NotationError(f"not a frame: {text!r}; write verb(role=head; ...)")
    return VerbFrame(_open(verb), tuple(map(_read_argument, _split(rest[:-1], ";"))))


def _read_argument(text: str) -> Argument:
    role, sign, phrase = text.partition("=")
    if not sign or not role.strip():
        raise NotationError(f"not an argument: {text!r}; write role=head[modifiers]")
    return Argument(_open(role), _read_phrase(phrase))


def _read_phrase(text: str) -> NounPhrase:
    head, bracket, inner = text.strip().partition("[")
    if not head or (bracket and not inner.endswith("]")):
        raise NotationError(f"not a noun phrase: {text!r}; write head[modifiers]")
    parts = list(_split(inner[:-1], ",")) if bracket else []
    said = tuple(_open(part) for part in parts if not _is_relation(part))
    relations = tuple(_read_relation(part) for part in parts if _is_relation(part))
    return NounPhrase(" ".join((*said, head)), head, said, relations=relations)


def _is_relation(text: str) -> bool:
    return ":" in text.partition("[")[0]


def _read_relation(text: str) -> tuple[str, NounPhrase]:
    name, _, phrase = text.partition(":")
    return _open(name), _read_phrase(phrase)


def _open(text: str) -> str:
    return text.strip().replace("_", " ")


def _split(text: str, separator: str) -> Iterator[str]:
    """Parts of ``text`` at the separators that stand outside all brackets."""
    depth, start = 0, 0
    for index, letter in enumerate(text):
        depth += (letter == "[") - (letter == "]")
        if letter == separator and depth == 0:
            yield text[start:index].strip()
            start = index + 1
    if text[start:].strip():
        yield text[start:].strip()
