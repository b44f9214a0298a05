"""How many commands are read as the people who wrote the frames meant them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from verbteach.language.agreement import view
from verbteach.language.frames import NounPhrase, VerbFrame
from verbteach.language.notation import modifiers, read_frames

SPLIT_SEED = 2017
"""The seed under which a third of a file is held out; never changed."""

Reader = Callable[[str], Sequence[VerbFrame]]


class Command(NamedTuple):
    """A command with the frames that it should be read as."""

    id: str
    level: str
    text: str
    frames: tuple[VerbFrame, ...]


@dataclass(frozen=True)
class FrameScore:
    """Shares of commands read right, each between 0 and 1.

    ``verbs``: every clause's verb. ``heads``: every clause's heads, whatever
    their roles. ``exact``: verbs, roles and heads. ``full``: modifiers and
    attached phrases as well.
    """

    commands: int
    verbs: float
    heads: float
    exact: float
    full: float


def read_commands(lines: Iterable[str]) -> tuple[Command, ...]:
    """Commands from tab-separated lines (id, level, text, frames) below one heading line."""
    rows = [line.rstrip("\n").split("\t") for line in lines if line.strip()]
    return tuple(Command(r[0], r[1], r[2], read_frames(r[3])) for r in rows[1:])


def split(commands: Sequence[Command]) -> tuple[tuple[Command, ...], tuple[Command, ...]]:
    """Two thirds for development and the seeded third that is only ever scored."""
    order = np.random.default_rng(SPLIT_SEED).permutation(len(commands))
    held = set(order[: len(commands) // 3].tolist())
    kept = tuple(c for i, c in enumerate(commands) if i not in held)
    return kept, tuple(c for i, c in enumerate(commands) if i in held)


def score(commands: Sequence[Command], reader: Reader) -> FrameScore:
    """Score ``reader`` on ``commands``; roles count as a multiset, not in order."""
    total = max(len(commands), 1)
    read = [(command.frames, tuple(reader(command.text))) for command in commands]

    def share(seen: Callable[[VerbFrame], object]) -> float:
        right = sum(list(map(seen, gold)) == list(map(seen, got)) for gold, got in read)
        return right / total

    return FrameScore(len(commands), share(_verb), share(_heads), share(view), share(_full))


def _verb(frame: VerbFrame) -> str:
    return frame.verb


def _heads(frame: VerbFrame) -> Counter[str]:
    return Counter(argument.phrase.head for argument in frame.arguments)


def _full(frame: VerbFrame) -> tuple[str, Counter[tuple[str, str]]]:
    return frame.verb, Counter((a.role, _written(a.phrase)) for a in frame.arguments)


def _written(phrase: NounPhrase) -> str:
    return f"{phrase.head}[{','.join(sorted(modifiers(phrase)))}]"
