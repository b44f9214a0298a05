"""The ``.clauses`` files: a command cut into clauses, aligned to the trace and grounded."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from verbteach_scenarios.tell_me_dave.documents import Clause, Oddity
from verbteach_scenarios.tell_me_dave.lines import Lines

SUFFIX = ".clauses"

# A noun phrase may hold a parenthesis of its own, as in "(the mug (left),Mug_1)".
_PAIR = re.compile(r"\(((?:[^()]|\([^()]*\))*),\s*(\w+)\s*\)")
_FRAME = re.compile(r"(?P<verb>[^\[]*)\[(?P<phrases>.*?)\|?\s*relation:.*\]", re.DOTALL)


class Command(NamedTuple):
    """What a ``.clauses`` file says."""

    sentence: str
    clauses: tuple[Clause, ...]
    oddities: tuple[Oddity, ...]


def read_command(path: Path, length: int, objects: Mapping[str, object]) -> Command:
    """Read the clauses of a trace of ``length`` actions about ``objects``.

    Raise ``CorpusError`` with the line where the file does not fit.
    """
    lines = Lines.of(path)
    sentence = lines.take_until("entire sentence:", "<start clause>")
    clauses = []
    while not lines.finished:
        clauses.append(_clause(lines, length, objects))
        lines.blank()
    return Command(sentence, tuple(clauses), tuple(lines.oddities))


def noun_phrases(frame: str) -> tuple[str, ...]:
    """Return the noun phrases of a clause's frame, grounded or not, in order."""
    match = _FRAME.match(frame)
    parts = match["phrases"].split("|") if match else []
    return tuple(part.strip() for part in parts if part.strip())


def _clause(lines: Lines, length: int, objects: Mapping[str, object]) -> Clause:
    lines.take("<start clause>")
    start = lines.integer("start env:")
    end = lines.integer("end env:")
    _check_span(lines, start, end, length)
    sentence = lines.take_until("sent:", "clause dscr:")
    frame = lines.take("clause dscr:")
    words = lines.take("words:").split()
    verb = lines.take("verb:")
    if not verb:
        lines.fail("the clause has no verb")
    mapping = _mapping(lines, lines.take("arg mapping:"), objects)
    lines.take("<end clause>")
    return Clause(sentence, start, end, verb, tuple(words), frame, mapping)


def _check_span(lines: Lines, start: int, end: int, length: int) -> None:
    if start < 0:
        lines.fail(f"the clause starts at action {start}")
    if end >= start and end >= length:
        lines.fail(f"the clause ends at action {end}, the trace's last is {length - 1}")
    if end < start - 1:
        lines.note(f"the clause ends at {end} before it starts at {start}: read as no action")


def _mapping(
    lines: Lines, text: str, objects: Mapping[str, object]
) -> tuple[tuple[str, tuple[str, ...]], ...]:
    if rest := _PAIR.sub("", text).strip():
        lines.fail(f"{rest[:40]!r} is no pair of noun phrase and object: (phrase,object)")
    found: dict[str, dict[str, None]] = {}
    for phrase, name in _PAIR.findall(text):
        if name not in objects:
            lines.note(f"{phrase.strip()!r} is mapped to {name}, which the object list lacks")
            continue
        found.setdefault(phrase.strip(), {})[name] = None
    return tuple((phrase, tuple(names)) for phrase, names in found.items())
