"""What must be true of each event of a sound record, one function a rule.

A check gets the event and the history just before it, and answers with what is
wrong, in words. That the fields are of their types was checked before.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.codec import (
    ROBOT_ACTS,
    ActFormatError,
    robot_act_from_json,
    teacher_act_from_json,
)
from verbteach.dialogue.moves import ROBOT_MOVES, TEACHER_MOVES, Phase
from verbteach.dialogue.promise import Promise
from verbteach.dialogue.rewards import Rewards
from verbteach_sessions import events as kinds
from verbteach_sessions.history import History, Node
from verbteach_sessions.lines import Event
from verbteach_sessions.plain_values import from_plain

Check = Callable[[Event, History], Iterator[str]]

TOLERANCE = 1e-9


def check_moves(event: Event, before: History) -> Iterator[str]:
    """The teacher's act fits what the robot waited for, and the robot's reply fits the act."""
    if event.type == kinds.TEACHER:
        yield from _teacher_move(event, before)
    elif event.type == kinds.ROBOT:
        yield from _robot_move(event, before)


def check_rewards(event: Event, before: History) -> Iterator[str]:
    """A turn earns what the header's table of prices says, and the totals add up."""
    if event.type != kinds.ROBOT or before.header is None:
        return
    reward = event.data["reward"]
    fair = {0.0} if before.teacher is None else _fair(event, before.teacher, before)
    if not any(abs(reward - one) <= TOLERANCE for one in fair):
        yield f"the reward is {reward}, by the table of prices it is one of {sorted(fair)}"
    if before.current is not None:
        total = before.current.after["totals"].get("reward", 0) + reward
        stated = event.data["after"]["totals"].get("reward")
        if stated is None or not abs(total - stated) <= TOLERANCE:
            yield f"the rewards add up to {total}, not {stated}"


def check_beliefs(event: Event, before: History) -> Iterator[str]:
    """Probabilities lie between 0 and 1, and those of one phrase, or of the goals, sum to one."""
    if event.type != kinds.ROBOT or event.data["beliefs"] is None:
        return
    beliefs = event.data["beliefs"]
    for phrase in beliefs["grounding"]:
        yield from _distribution(f"'{phrase['phrase']}'", [p for _, p in phrase["objects"]])
    yield from _distribution("the goals", [goal["share"] for goal in beliefs["goals"]])
    for fluent, p in beliefs["uncertain"]:
        if not 0 < p < 1:
            yield f"{fluent} has confidence {p}, which is not between 0 and 1"


def check_decisions(event: Event, before: History) -> Iterator[str]:
    """Each decision chose one of its candidates, with a probability above 0."""
    if event.type != kinds.ROBOT:
        return
    for decision in event.data["decisions"]:
        count = len(decision["candidates"])
        if not 0 <= decision["chosen"] < count:
            yield f"candidate {decision['chosen']} was chosen among {count}"
        if not 0 < decision["propensity"] <= 1:
            yield f"the propensity {decision['propensity']} is no probability of what was chosen"


def check_promise(event: Event, before: History) -> Iterator[str]:
    """Under a promise nothing is carried out that the robot was not sure enough of."""
    promised = before.header.data.get("promise") if before.header else None
    if event.type != kinds.ROBOT or promised is None:
        return
    promise = from_plain(Promise, promised, "promise")
    for decision in event.data["decisions"]:
        chosen = _chosen(decision)
        if chosen is None or chosen["act"].get("act") != acts.SelectHypo.name:
            continue
        sure = promise.sureness.of(chosen["features"])
        if sure < promise.sure:
            yield f"carried out when {sure:.3f} sure, the promise asks for {promise.sure:.3f}"


def check_times(event: Event, before: History) -> Iterator[str]:
    """Session time does not run backwards."""
    if before.last is not None and event.at < before.last.at:
        yield f"it happened at {event.at} s, before the event at {before.last.at} s"


def check_totals(event: Event, before: History) -> Iterator[str]:
    """Undo and redo lead to the state that was recorded with the turn they go to."""
    if event.type not in (kinds.UNDO, kinds.REDO) or before.current is None:
        return
    turns = before.undoable() if event.type == kinds.UNDO else before.redoable
    to = next((turn for turn in turns if turn.seq == event.data["to"]), None)
    if to is not None and event.data["after"] != to.after:
        yield f"the state is not that of event {to.seq}"


CHECKS: Mapping[str, Check] = {
    "moves": check_moves,
    "rewards": check_rewards,
    "beliefs": check_beliefs,
    "decisions": check_decisions,
    "promise": check_promise,
    "times": check_times,
    "undo": check_totals,
}


def _chosen(decision: Mapping[str, Any]) -> Mapping[str, Any] | None:
    candidates, chosen = decision["candidates"], decision["chosen"]
    found: Mapping[str, Any] | None = candidates[chosen] if 0 <= chosen < len(candidates) else None
    return found


def _teacher_move(event: Event, before: History) -> Iterator[str]:
    act = _act(event)
    phase = _phase(before.current)
    if act is None or phase is None:
        yield "the act cannot be read"
    elif type(act) not in TEACHER_MOVES[phase]:
        yield f"'{act.name}' does not fit, the robot waited for {phase.value}"


def _robot_move(event: Event, before: History) -> Iterator[str]:
    phase = _phase_named(event.data["phase"])
    if phase is None:
        yield f"there is no phase {event.data['phase']!r}"
        return
    try:
        robot_acts = [robot_act_from_json(act) for act in event.data["acts"]]
    except ActFormatError as error:
        yield f"an act cannot be read, {error}"
        return
    if len(robot_acts) != len(event.data["texts"]) or not robot_acts:
        yield f"{len(robot_acts)} acts have {len(event.data['texts'])} wordings"
    elif type(robot_acts[-1]) not in ROBOT_MOVES[phase]:
        yield f"'{robot_acts[-1].name}' does not wait for {phase.value}"
    was, act = _phase(before.current), _act(before.teacher) if before.teacher else None
    if was is not None and act is not None and phase not in TEACHER_MOVES[was].get(type(act), ()):
        yield f"{was.value} and '{act.name}' do not lead to {phase.value}"


def _fair(event: Event, teacher: Event, before: History) -> set[float]:
    """What the teacher's act may earn: 0, or the price of what the robot waited with."""
    act, node, header = _act(teacher), before.current, before.header
    waiting = node.acts[-1] if node and node.acts else ""
    if act is None or header is None or waiting not in ROBOT_ACTS:
        return {0.0}
    rewards = from_plain(Rewards, header.data["parameters"]["rewards"])
    yes = rewards.of(waiting, positive=True)
    otherwise = rewards.of(waiting, positive=False)
    if acts.AskAgain.name in [one.get("act") for one in event.data["acts"]]:
        return {0.0}
    in_question = waiting in {kind.name for kind in acts.QUESTIONS}
    if waiting == acts.IncludeFluent.name and isinstance(act, acts.Good):
        return {
            yes,
            otherwise,
            0.0,
        }  # right as read back, right once corrected, called wrong before
    earns = _EARNS.get(type(act), _nothing)
    return earns(yes, otherwise, in_question)


def _nothing(yes: float, otherwise: float, in_question: bool) -> set[float]:
    return {0.0}


# Judging a goal that was already called wrong earns nothing more, hence the zeros.
_Earns = Callable[[float, float, bool], set[float]]
_EARNS: Mapping[type[TeacherAct], _Earns] = {
    acts.Yes: lambda yes, otherwise, in_question: {yes},
    acts.Point: lambda yes, otherwise, in_question: {yes},
    acts.No: lambda yes, otherwise, in_question: {otherwise},
    acts.Unsure: lambda yes, otherwise, in_question: {otherwise},
    acts.Skip: lambda yes, otherwise, in_question: {otherwise if in_question else 0.0},
    acts.Good: lambda yes, otherwise, in_question: {yes, 0.0},
    acts.Bad: lambda yes, otherwise, in_question: {otherwise, 0.0},
    acts.Stop: lambda yes, otherwise, in_question: {otherwise},
    acts.Say: lambda yes, otherwise, in_question: {yes, otherwise, 0.0},
}


def _distribution(of: str, chances: list[Any]) -> Iterator[str]:
    if any(not 0 <= p <= 1 for p in chances):
        yield f"{of}: a probability is not between 0 and 1"
    elif chances and abs(math.fsum(chances) - 1) > TOLERANCE:
        yield f"{of}: the probabilities sum to {math.fsum(chances)}"


def _act(event: Event) -> TeacherAct | None:
    try:
        return teacher_act_from_json(event.data["act"])
    except ActFormatError:
        return None


def _phase(node: Node | None) -> Phase | None:
    return None if node is None else _phase_named(node.phase)


def _phase_named(name: str) -> Phase | None:
    return next((phase for phase in Phase if phase.value == name), None)
