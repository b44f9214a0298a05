"""How a command would go, by how sure the robot has to be before it acts.

A robot held to a promise asks on where another would act, so one command has a
course of its own for every cut: carried out rightly, wrongly, or shown, after so
many questions. They are worked out together, branching only where the cut makes
a difference. Knows no statistics and no robot.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any, NamedTuple, Protocol

from verbteach.dialogue.acts import RobotAct


class Outcome(Enum):
    """What became of a command; ``SHOWN``: the robot did not act, it asked to be shown."""

    RIGHT = "right"
    WRONG = "wrong"
    SHOWN = "shown"


class Piece(NamedTuple):
    """What comes of cuts up to and including ``upto``, down to the piece before."""

    upto: float
    outcome: Outcome
    questions: int


class Moment(Protocol):
    """Where a policy chooses in the execution phase, not having chosen yet."""

    @property
    def sure(self) -> float:
        """How sure the robot is; where it has nothing to carry out it does not matter."""
        ...

    def choice(self, *, sure: bool) -> RobotAct:
        """The act that is chosen where that is sure enough, and where it is not."""
        ...

    def after(self, *, sure: bool) -> Moment | Outcome:
        """What the choice leads to once it is answered, carried out or shown."""
        ...


@dataclass(frozen=True)
class Course:
    """One command's pieces, ``upto`` rising; the last one reaches to 1 or beyond."""

    pieces: tuple[Piece, ...]

    def __post_init__(self) -> None:
        bounds = [piece.upto for piece in self.pieces]
        if not bounds or bounds != sorted(set(bounds)) or bounds[-1] < 1.0:
            raise ValueError("a course has pieces in rising order, up to 1")

    @classmethod
    def of(cls, moment: Moment) -> Course:
        """Every cut's course from here on."""
        return cls(_merged(_pieces(moment, -math.inf, math.inf, 0)))

    def at(self, cut: float) -> Piece:
        """What comes of acting at ``cut`` (0 to 1) or surer."""
        return next(piece for piece in self.pieces if cut <= piece.upto)

    @property
    def worst(self) -> float:
        """The highest cut at which it is carried out wrongly; minus infinity where none is."""
        wrong = [piece.upto for piece in self.pieces if piece.outcome is Outcome.WRONG]
        return max(wrong, default=-math.inf)

    def to_json(self) -> list[list[Any]]:
        """A row a piece: ``upto`` (null for the last), outcome, questions."""
        return [
            [None if math.isinf(upto) else upto, outcome.value, questions]
            for upto, outcome, questions in self.pieces
        ]

    @classmethod
    def from_json(cls, rows: Sequence[Sequence[Any]]) -> Course:
        """Read what :meth:`to_json` wrote. Raises ``ValueError``."""
        try:
            return cls(
                tuple(
                    Piece(math.inf if upto is None else float(upto), Outcome(name), int(questions))
                    for upto, name, questions in rows
                )
            )
        except TypeError as error:
            raise ValueError(f"no course of a command: {error}") from error


def _pieces(here: Moment | Outcome, above: float, upto: float, questions: int) -> Iterator[Piece]:
    """The pieces of the cuts from ``above`` (excluded) up to ``upto``."""
    if isinstance(here, Outcome):
        yield Piece(upto, here, questions)
        return
    now = here.sure
    if upto <= now or here.choice(sure=True) == here.choice(sure=False):
        parts = [(True, above, upto)]
    elif now <= above:
        parts = [(False, above, upto)]
    else:
        parts = [(True, above, now), (False, now, upto)]
    for sure, low, high in parts:
        ahead = here.after(sure=sure)
        asked = questions + (not isinstance(ahead, Outcome))
        yield from _pieces(ahead, low, high, asked)


def _merged(pieces: Iterator[Piece]) -> tuple[Piece, ...]:
    """Neighbours that say the same as one."""
    found: list[Piece] = []
    for piece in pieces:
        if found and found[-1][1:] == piece[1:]:
            found.pop()
        found.append(piece)
    return tuple(found)
