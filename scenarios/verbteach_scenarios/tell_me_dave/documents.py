"""The corpus's values: documents, their recorded traces and the clauses aligned to them.

They hold what the files say, in the domain's words, and nothing derived from it.
Misra et al. 2014 and 2015 recorded the corpus; She & Chai 2016 cut it into clauses.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from verbteach.world.fluents import State
from verbteach.world.plan import Action


class Step(NamedTuple):
    """A closed-world state as recorded, and the action done in it (None at the trace's end)."""

    state: State
    action: Action | None


@dataclass(frozen=True)
class Clause:
    """A piece of the command, aligned to part of the trace.

    Actions ``start`` to ``end`` (inclusive) carry it out; ``end < start`` is
    no action. ``words`` and ``frame`` are a statistical parser's, mistakes
    included. ``mapping`` gives each grounded noun phrase, in order of first
    mention, with the objects it may mean.
    """

    sentence: str
    start: int
    end: int
    verb: str
    words: tuple[str, ...]
    frame: str
    mapping: tuple[tuple[str, tuple[str, ...]], ...]

    @property
    def length(self) -> int:
        """How many recorded actions carry the clause out."""
        return max(0, self.end - self.start + 1)


@dataclass(frozen=True)
class Document:
    """One recording: a room, a command of one or more clauses, and what was done.

    ``objects`` maps every object's id, the robot's included, to its affordance
    marks. State ``i`` of ``steps`` is the one before action ``i``.
    """

    name: str
    objects: Mapping[str, tuple[str, ...]]
    steps: tuple[Step, ...]
    sentence: str
    clauses: tuple[Clause, ...]

    def actions(self, clause: Clause) -> tuple[Action, ...]:
        """Return the recorded actions of a clause, possibly none."""
        chosen = self.steps[clause.start : clause.end + 1]
        return tuple(step.action for step in chosen if step.action is not None)


class Oddity(NamedTuple):
    """Something odd that could be read all the same: where, and what."""

    path: Path
    line: int
    reason: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.reason}"


@dataclass(frozen=True)
class Corpus:
    """The documents of one folder, by number, and what is odd about their files."""

    folder: Path
    documents: tuple[Document, ...]
    oddities: tuple[Oddity, ...] = ()
