"""A stop rule that can promise: how sure the robot has to be for so many executions to be right.

It is calibrated on the courses of commands that nothing was trained on
(``courses.py``). For commands that are exchangeable with them a cut keeps two
bounds, and the lowest cut that keeps both is taken:

* *Of all commands*, at most ``1 - rate`` are carried out wrongly, on average over
  calibrations and commands to come. Split-conformal: a command's score is the
  highest cut at which it still goes wrong, and a new command's score exceeds
  the k-th largest of n with a probability of at most k / (n + 1) (Papadopoulos
  et al. 2002; Lei et al. 2018). Raising the cut can turn a right execution into
  a wrong one, since the robot asks on; taking the highest such cut makes the
  loss fall with the cut all the same, as conformal risk control requires
  (Angelopoulos et al. 2022).
* *Of the commands carried out*, at least ``rate`` are right, with a probability of
  ``CONFIDENCE`` over calibrations. Learn then test (Angelopoulos et al. 2021) with
  exact binomial tests along a fixed sequence of falling cuts, which begins where
  half of the commands are carried out and ends at the first that fails. This is
  what a person takes the promise to mean.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from verbteach.policy.courses import Course, Outcome

CONFIDENCE = 0.8
"""How often, over calibrations, the share right of what is carried out is as promised."""

START = 0.5
"""Where the tests begin: at the strictest cut at which such a share of the commands is done."""


class UnkeepablePromiseError(ValueError):
    """No cut keeps the promise, as far as the calibration can tell; the message says why."""


class Kept(NamedTuple):
    """What a cut came to: how many commands, carried out, rightly, and the questions asked."""

    commands: int
    carried_out: int
    right: int
    questions: int

    @property
    def wrong(self) -> int:
        """How many were carried out wrongly."""
        return self.carried_out - self.right


def kept(courses: Sequence[Course], cut: float) -> Kept:
    """How the commands go where the robot acts at ``cut`` or surer."""
    pieces = [course.at(cut) for course in courses]
    right = sum(piece.outcome is Outcome.RIGHT for piece in pieces)
    shown = sum(piece.outcome is Outcome.SHOWN for piece in pieces)
    return Kept(len(pieces), len(pieces) - shown, right, sum(piece.questions for piece in pieces))


@dataclass(frozen=True)
class Cut:
    """Act when at least ``sure``; calibrated on ``lessons`` commands."""

    sure: float
    lessons: int


def cut_for(courses: Sequence[Course], rate: float) -> Cut:
    """The lowest cut that keeps the promise.

    Raises ``UnkeepablePromiseError`` where none does, ``ValueError`` unless 0 < rate < 1.
    """
    if not 0.0 < rate < 1.0:
        raise ValueError(f"a success rate is between 0 and 1, not {rate}")
    return Cut(max(of_all(courses, rate), of_carried_out(courses, rate)), len(courses))


def of_all(courses: Sequence[Course], rate: float) -> float:
    """The lowest cut at which at most ``1 - rate`` of all commands are carried out wrongly."""
    allowed = math.floor((1.0 - rate) * (len(courses) + 1) + 1e-9)
    if allowed < 1:
        needed = math.ceil(1.0 / (1.0 - rate) - 1e-9) - 1
        raise UnkeepablePromiseError(
            f"{rate:.0%} cannot be promised on {len(courses)} lessons: it takes {needed} or more"
        )
    scores = sorted((course.worst for course in courses), reverse=True)
    score = scores[allowed - 1] if allowed <= len(scores) else -math.inf
    if score >= 1.0:
        raise UnkeepablePromiseError(
            f"{rate:.0%} cannot be promised: too much went wrong however sure the robot was"
        )
    return max(0.0, math.nextafter(score, math.inf))


def of_carried_out(courses: Sequence[Course], rate: float, confidence: float = CONFIDENCE) -> float:
    """The lowest cut at which ``rate`` of what is carried out is right, as far as tests tell."""
    steps = _steps(courses)
    enough = START * len(courses)
    begin = next((i for i, one in enumerate(steps) if one.carried_out >= enough), len(steps))
    found: float | None = None
    for step in steps[begin:]:
        if _chance(step.wrong, step.carried_out, 1 - rate) > 1 - confidence:
            break
        found = step.cut
    if found is None:
        raise UnkeepablePromiseError(_why_not(steps, begin, rate, 1 - confidence))
    return found


class _Step(NamedTuple):
    """A cut, and what is carried out at it."""

    cut: float
    carried_out: int
    wrong: int


def _steps(courses: Sequence[Course]) -> list[_Step]:
    """Every cut at which something changes, from the strictest down; above 1 there is none."""
    acted = [
        (below, min(piece.upto, 1.0), piece.outcome is Outcome.WRONG)
        for course in courses
        for below, piece in zip(
            (-math.inf, *(piece.upto for piece in course.pieces)), course.pieces, strict=False
        )
        if piece.outcome is not Outcome.SHOWN
    ]
    cuts = sorted({upto for _, upto, _ in acted}, reverse=True)
    every, wrong = (_counted([row for row in acted if row[2] or all_], cuts) for all_ in (1, 0))
    return [_Step(*row) for row in zip(cuts, every, wrong, strict=True)]


def _counted(acted: Sequence[tuple[float, float, bool]], cuts: Sequence[float]) -> list[int]:
    """How many of the pieces ``(below, upto, wrong)`` each cut falls into."""
    below = np.sort([row[0] for row in acted])
    upto = np.sort([row[1] for row in acted])
    inside = np.searchsorted(below, cuts, "left") - np.searchsorted(upto, cuts, "left")
    counts: list[int] = inside.tolist()
    return counts


def _chance(wrong: int, among: int, share: float) -> float:
    """The probability of so few wrong ones or fewer, if a ``share`` of all were wrong."""
    return math.fsum(
        math.comb(among, count) * share**count * (1.0 - share) ** (among - count)
        for count in range(wrong + 1)
    )


def _why_not(steps: Sequence[_Step], begin: int, rate: float, level: float) -> str:
    """Too few executions for even a faultless robot to pass, or too many of them wrong.

    Stricter cuts than the one at ``begin`` were not tried, however right they are.
    """
    needed = math.ceil(math.log(level) / math.log(rate))
    most = max((step.carried_out for step in steps), default=0)
    if most < needed:
        return (
            f"{rate:.0%} cannot be promised: {most} commands were carried out in the calibration,"
            f" and it takes {needed} or more"
        )
    enough = [one for one in steps if one.carried_out >= needed]
    tried = [one for one in steps[begin:] if one.carried_out >= needed] or enough
    best = max(1 - one.wrong / one.carried_out for one in tried)
    return (
        f"{rate:.0%} cannot be promised: of what was carried out in the calibration at most"
        f" {best:.0%} was right, and that has to be clearly more"
    )
