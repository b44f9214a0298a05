"""The ``.instenv`` files: a room's objects, and the recorded states and instructions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from verbteach.world.fluents import Fluent, State
from verbteach_scenarios.tell_me_dave.documents import Oddity, Step
from verbteach_scenarios.tell_me_dave.instructions import Instructions
from verbteach_scenarios.tell_me_dave.lines import Lines

SUFFIX = ".instenv"

_GROUP = re.compile(r"\(([^()]*)\)")
_BETWEEN = re.compile(r"[\s,]*")
_OBJECT = re.compile(r"(\w+):\s*(\w+(?:\s*,\s*\w+)*)?")


class Trace(NamedTuple):
    """What a ``.instenv`` file says."""

    objects: Mapping[str, tuple[str, ...]]
    steps: tuple[Step, ...]
    oddities: tuple[Oddity, ...]


class LineSyntaxError(ValueError):
    """A line of parenthesised items is torn or holds something else."""


def read_trace(path: Path) -> Trace:
    """Read a trace; raise ``CorpusError`` with the line where it does not fit."""
    lines = Lines.of(path)
    objects = _objects(lines)
    instructions = Instructions.among(objects)
    steps: list[Step] = []
    instruction_line = 0
    lines.blank()
    while not lines.finished:
        if steps and steps[-1].action is None:
            reason = f"step {len(steps) - 1} has no instruction though a step follows it"
            lines.fail(reason, instruction_line)
        steps.append(_step(lines, len(steps), instructions))
        instruction_line = lines.number - 1
        lines.blank()
    if not steps:
        lines.fail("the file ends before the first step")
    if steps[-1].action is not None:
        lines.fail("the file ends with an instruction whose outcome is missing")
    _note_unlisted(lines, objects, steps)
    return Trace(objects, tuple(steps), tuple(lines.oddities))


def _objects(lines: Lines) -> dict[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for text in _items(lines, lines.take("Obj list:")):
        match = _OBJECT.fullmatch(text.strip())
        if match is None:
            lines.fail(f"({text}) is not an object with its marks: (name:mark,mark)")
        name, marks = match.groups()
        if name in found:
            lines.fail(f"object {name} is listed twice")
        found[name] = (
            tuple(dict.fromkeys((marks or "").replace(" ", "").split(","))) if marks else ()
        )
    if not found:
        lines.fail("no object is listed")
    return found


def _step(lines: Lines, number: int, instructions: Instructions) -> Step:
    if (found := lines.integer("<start step >")) != number:
        lines.fail(f"step {found} stands where step {number} should follow")
    state = _state(lines, lines.take("Env:"))
    words = lines.take("Instruction:").split()
    if (found := lines.integer("<end step >")) != number:
        lines.fail(f"step {number} ends as step {found}")
    return Step(state, instructions.action(words) if words else None)


def _items(lines: Lines, text: str) -> list[str]:
    try:
        return split_items(text)
    except LineSyntaxError as problem:
        lines.fail(str(problem))


def _state(lines: Lines, text: str) -> State:
    try:
        return parse_state(text)
    except LineSyntaxError as problem:
        lines.fail(str(problem))


def split_items(text: str) -> list[str]:
    """Split ``(a b),(c d) (e)`` at its parentheses: the separators in between vary."""
    if _BETWEEN.fullmatch(rest := _GROUP.sub("", text)) is None:
        raise LineSyntaxError(f"{rest.strip(', ')[:40]!r} stands outside the parentheses")
    return _GROUP.findall(text)


@lru_cache(maxsize=8192)
def _fluent(text: str) -> Fluent:
    predicate, *args = text.split() or ("",)
    if not predicate or not args:
        raise LineSyntaxError(f"({text}) is not a fluent: (predicate object ...)")
    return Fluent(predicate, tuple(args))


def parse_state(text: str) -> State:
    """Read an ``Env`` line's content; raise ``LineSyntaxError`` where it is torn."""
    return frozenset(map(_fluent, split_items(text)))


def print_state(state: Iterable[Fluent]) -> str:
    """Write a state as an ``Env`` line's content, sorted; ``parse_state`` reads it back."""
    return ",".join(str(fluent) for fluent in sorted(state))


def _note_unlisted(lines: Lines, objects: Mapping[str, object], steps: Iterable[Step]) -> None:
    """Objects that the trace speaks of though the list lacks them."""
    known = set(objects)
    for number, step in enumerate(steps):
        spoken = {o for f in step.state for o in (f.args[:1] if f.predicate == "state" else f.args)}
        spoken |= set(step.action.args) if step.action else set()
        for name in sorted(spoken - known):
            known.add(name)
            lines.note(f"step {number} speaks of {name}, which the object list lacks")
