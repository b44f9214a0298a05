"""Holding a recorded session again under another question policy.

The teacher is the record: a question is answered as it was answered there, in
the same command and the same world, each answer once. Where the record holds no
answer the turn is unanswerable, and the command ends there: nothing is made up.
The rooms are the record's, so every command is given where it was given; what
the robot knows of its verbs is what it has learned under the other policy.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

from verbteach.dialogue.acts import (
    QUESTIONS,
    RequestDemonstration,
    RobotAct,
    SelectHypo,
    TeacherAct,
)
from verbteach.dialogue.codec import robot_act_to_json, teacher_act_from_json
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach.world.fluents import State
from verbteach_sessions.errors import SessionError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.fold import Fold
from verbteach_sessions.history import Node
from verbteach_sessions.lines import canonical
from verbteach_sessions.method import Method
from verbteach_sessions.recomputing import Difference
from verbteach_sessions.recorder import MISFITS
from verbteach_sessions.replay import fold_of

Heard = Callable[[int], None]


class NotRecomputableError(SessionError):
    """The record cannot be recomputed as it was, so neither can what might have been."""


@dataclass
class Counterfactual:
    """What became of a recorded session under ``policy``.

    ``commands`` were given and ``finished`` to their end, ``turns`` taken by the
    robot; of those ``unanswerable`` waited for something that the record does
    not hold. ``questions`` and ``reward`` are of the turns that were answered,
    those of the record stand beside them. ``first_difference`` is the first
    turn at which the robot did something else than it had done.
    """

    policy: str
    events: int
    content_hash: str
    recorded_questions: int
    recorded_reward: float
    commands: int = 0
    finished: int = 0
    turns: int = 0
    unanswerable: int = 0
    questions: int = 0
    reward: float = 0.0
    first_difference: Difference | None = None
    warnings: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """What ``replay --policy --json`` prints; ``verified``: nothing differs."""
        difference = self.first_difference
        return {
            "verified": difference is None,
            **vars(self),
            "first_difference": None if difference is None else difference.to_json(),
            "warnings": list(self.warnings),
        }


def counterfactual(
    path: Path, settings: Settings, policy: str, heard: Heard = lambda _: None
) -> Counterfactual:
    """Hold the session at ``path`` again under the policy of this name.

    ``heard`` is told how many events of the record were recomputed. Raises the
    errors of reading a log, ``UnknownPolicyError``, ``UnknownSceneError`` and
    :class:`NotRecomputableError`.
    """
    chosen = Method.named(policy).policy
    reader = LogReader(path)
    past = fold_of(reader, settings, heard)
    if past.difference is not None:
        raise NotRecomputableError(
            f"{reader.path}: event {past.difference.seq} cannot be recomputed as it was"
            " recorded, so what would have been cannot be told"
        )
    fold = past.fold
    turns = fold.history.effective()
    told = Counterfactual(
        policy,
        reader.position.seq,
        fold.content.hexdigest,
        sum(_is_question(one) for one in _asked(turns, fold)),
        sum(fold.states[node.seq].turn.reward for node in turns),
        warnings=reader.warnings,
    )
    method = replace(fold.header.method, policy=chosen)
    _Again(method.robot(settings, fold.header.learned_before), fold, told).hold(_exchanges(turns))
    return told


class _Exchange(NamedTuple):
    """What the teacher began with while the robot waited for a command, and all that followed."""

    opening: Node
    answers: Sequence[Node]


def _exchanges(turns: Sequence[Node]) -> list[_Exchange]:
    found: list[_Exchange] = []
    for node in turns:
        if node.teacher is None or node.parent is None:
            continue
        if node.parent.phase == Phase.COMMAND.value:
            found.append(_Exchange(node, []))
        elif found:
            found[-1] = found[-1]._replace(answers=[*found[-1].answers, node])
    return found


@dataclass
class _Again:
    """A robot that lives through the record once more."""

    robot: Robot
    fold: Fold
    told: Counterfactual
    same: bool = field(default=True)

    def hold(self, exchanges: Sequence[_Exchange]) -> None:
        self._begin()
        for exchange in exchanges:
            self._hold(exchange)

    def _begin(self) -> None:
        first = self.fold.history.effective()[0]
        self.robot.open(first.after["scene"])

    def _hold(self, exchange: _Exchange) -> None:
        """Live through one command; one that cannot be finished leaves the robot as it was."""
        mind = self.robot.state
        before = self._in_the_record(exchange.opening)
        self.robot.state = replace(
            before,
            knowledge=mind.knowledge,
            experience=mind.experience,
            totals=mind.totals,
            policy=mind.policy,
        )
        self.told.commands += 1
        given = iter((exchange.opening, *exchange.answers))
        recorded = next(given, None)
        teacher = _Teacher(exchange, self.fold)
        act: TeacherAct | None = _act(exchange.opening)
        while act is not None:
            if not self._receive(act):
                break
            self._compare(recorded)
            recorded = next(given, None)
            if self.robot.turn.phase is Phase.COMMAND:
                self.told.finished += 1
                return
            act = teacher.reply(self.robot.turn, self.robot.state)
        if self.same and recorded is None:
            return  # the record ends here, in the middle of a command
        self.told.unanswerable += 1
        self.robot.state = mind

    def _receive(self, act: TeacherAct) -> bool:
        waiting = self.robot.turn.waiting_act
        try:
            self.robot.receive(act)
        except (*MISFITS, ValueError):  # what was said of things that this robot never learned
            return False
        self.told.turns += 1
        self.told.questions += _is_question(waiting)
        self.told.reward += self.robot.turn.reward
        return True

    def _in_the_record(self, opening: Node) -> RobotState:
        if opening.parent is None:
            raise RuntimeError("a teacher's act follows a robot's turn")
        return self.fold.states[opening.parent.seq]

    def _compare(self, recorded: Node | None) -> None:
        if not self.same:
            return
        acts = [robot_act_to_json(act) for act in self.robot.turn.acts]
        then = None if recorded is None else self.fold.states[recorded.seq].turn.acts
        before = None if then is None else [robot_act_to_json(act) for act in then]
        if acts != before and recorded is not None:
            self.same = False
            self.told.first_difference = Difference(recorded.seq, "acts", before, acts)


class _Teacher:
    """Answers as the record did in one exchange, each answer once."""

    def __init__(self, exchange: _Exchange, fold: Fold) -> None:
        self._answers: dict[_Matter, deque[TeacherAct]] = defaultdict(deque)
        for node in exchange.answers:
            if node.parent is not None:
                state = fold.states[node.parent.seq]
                self._answers[_matter(state.turn, state)].append(_act(node))

    def reply(self, turn: RobotTurn, state: RobotState) -> TeacherAct | None:
        answers = self._answers[_matter(turn, state)]
        return answers.popleft() if answers else None


class _Matter(NamedTuple):
    """What an answer was an answer to: the act that waited, and the world it was about."""

    phase: str
    act: bytes
    world: State


def _matter(turn: RobotTurn, state: RobotState) -> _Matter:
    return _Matter(turn.phase.value, canonical(_said(turn.waiting_act)), state.world)


def _said(act: RobotAct) -> Mapping[str, Any]:
    """The part of an act that its answer depends on.

    A demonstration is one whatever it was asked for; a judgement is of what was done.
    """
    if isinstance(act, RequestDemonstration):
        return {"act": act.name}
    if isinstance(act, SelectHypo):
        return {"act": act.name, "plan": [str(step) for step in act.plan]}
    return robot_act_to_json(act)


def _act(node: Node) -> TeacherAct:
    if node.teacher is None:
        raise RuntimeError("a turn that follows an act")
    return teacher_act_from_json(node.teacher.data["act"])


def _asked(turns: Sequence[Node], fold: Fold) -> list[RobotAct]:
    """What the robot waited with, for each answer that was given."""
    waited = (node.parent for node in turns if node.teacher is not None)
    return [fold.states[node.seq].turn.waiting_act for node in waited if node is not None]


def _is_question(act: RobotAct) -> bool:
    return isinstance(act, QUESTIONS)
