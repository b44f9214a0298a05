"""What each question brought: what the robot expected of the answer, and what came of it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from verbteach.dialogue.acts import RobotAct
from verbteach.dialogue.inquiry import Label
from verbteach.experiments.asked_command import AskedCommand
from verbteach.experiments.carrying_out import carry_out
from verbteach.policy.asking_policy import ENDING


@dataclass(frozen=True)
class Answered:
    """A question with its answer.

    ``expected``: how much the robot thought the answer would raise the expected
    Jaccard index, where it works that out; ``gained``: by how much carrying the
    command out at once then scored better, in SJI, than before the question.
    """

    act: RobotAct
    label: Label
    expected: float | None
    gained: float


def answered(command: AskedCommand, rng: np.random.Generator) -> tuple[Answered, ...]:
    """Hold the dialogue once more, carrying the command out after each answer.

    ``rng`` must draw as it did for the dialogue; see ``sight.stream``.
    """
    state = command.start
    found: list[Answered] = []
    before = carry_out(state, command.human, command.gold).sji
    while True:
        decision = command.policy.choose(None, state.candidates(), rng)
        if isinstance(decision.act, ENDING):
            return tuple(found)
        reply = command.human.reply(decision.act, len(found), rng)
        state = state.after(decision.act, reply)
        after = carry_out(state, command.human, command.gold).sji
        expected = decision.candidates[decision.chosen].features.get("ask.gain")
        found.append(Answered(decision.act, reply.label, expected, after - before))
        before = after


@dataclass(frozen=True)
class Kind:
    """All questions of one type.

    ``expected`` and ``gained`` are means; ``expected`` is None where the robot
    expects nothing in figures. ``helped`` and ``harmed`` are shares.
    """

    name: str
    asked: int
    yes: float
    expected: float | None
    gained: float
    helped: float
    harmed: float


def by_kind(questions: Iterable[Answered]) -> tuple[Kind, ...]:
    """The types of questions that were asked, the most frequent first."""
    groups: dict[str, list[Answered]] = {}
    for one in questions:
        groups.setdefault(one.act.name, []).append(one)
    kinds = [_kind(name, group) for name, group in sorted(groups.items())]
    return tuple(sorted(kinds, key=lambda kind: -kind.asked))


def _kind(name: str, questions: Sequence[Answered]) -> Kind:
    expected = [one.expected for one in questions if one.expected is not None]
    gained = [one.gained for one in questions]
    return Kind(
        name,
        len(questions),
        _mean([float(one.label in {Label.YES, Label.OBJECTS}) for one in questions]),
        _mean(expected) if expected else None,
        _mean(gained),
        _mean([float(gain > 0.0) for gain in gained]),
        _mean([float(gain < 0.0) for gain in gained]),
    )


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)
