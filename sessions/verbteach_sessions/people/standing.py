"""Where a session stands after a robot turn, followed from the record alone.

The world is followed by running the recorded actions, which takes no planning,
and is held against the world's recorded hash: where they differ it counts as
unknown until the next scene is entered.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from verbteach.dialogue import acts
from verbteach.dialogue.acts import QUESTIONS, RobotAct, TeacherAct
from verbteach.dialogue.codec import robot_act_from_json
from verbteach.dialogue.setting import Settings
from verbteach.world.fluents import State
from verbteach.world.plan import Action
from verbteach.world.simulator import InapplicableError, apply
from verbteach_sessions.recording import world_digest

Grounding = Mapping[str, tuple[str, ...]]
"""Noun phrases and the objects they may mean, the likeliest first."""

_AGAIN = (acts.IncludeFluent, acts.ReviseGoal)
_CORRECTING = (acts.Bad, acts.Strike, acts.Keep)


@dataclass(frozen=True)
class Standing:
    """After one robot turn: what it said, and what of the episode matters for its answers.

    ``world`` and ``start`` (the world before the command) are ``None`` where
    they are not known. ``asked`` counts the command's questions that were
    answered, ``first`` is its grounding before any of them. ``shown`` are the
    steps demonstrated, ``corrected`` says that a goal read back was called
    wrong or changed.
    """

    turn: tuple[RobotAct, ...]
    reading: str
    scene: str
    world: State | None
    start: State | None
    command: str = ""
    asked: int = 0
    grounding: Grounding | None = None
    first: Grounding | None = None
    shown: tuple[Action, ...] = ()
    corrected: bool = False

    @property
    def waiting(self) -> RobotAct:
        """The act that waits for the teacher."""
        return self.turn[-1]

    @property
    def again(self) -> bool:
        """Whether the robot puts something once more that it could not read an answer to."""
        return any(isinstance(act, acts.AskAgain) for act in self.turn)

    @property
    def outcome(self) -> acts.Outcome | None:
        """How an episode ended in this turn, if one did; the first, where several clauses did."""
        closed = (act.outcome for act in self.turn if isinstance(act, acts.CloseEpisode))
        return next(closed, None)


def opened(data: Mapping[str, Any], scene: str, settings: Settings | None) -> Standing:
    """After a ``robot`` event that begins in a scene; without ``settings`` no world is known."""
    world = None if settings is None else settings(scene).scene.initial
    return _checked(Standing(_acts(data), data["reading"], scene, world, world), data)


def stepped(
    before: Standing, said: TeacherAct, data: Mapping[str, Any], settings: Settings | None
) -> Standing:
    """After the ``robot`` event that replies to ``said``."""
    if isinstance(said, acts.GoToScene):
        there = opened(data, said.scene, settings)
        return replace(there, command="")
    turn = _acts(data)
    now = replace(before, turn=turn, reading=data["reading"])
    if isinstance(said, acts.Command):
        now = replace(_fresh(now), command=said.text)
    elif isinstance(before.waiting, QUESTIONS):
        now = replace(now, asked=before.asked + 1)
    elif isinstance(before.waiting, _AGAIN) and isinstance(said, _CORRECTING):
        now = replace(now, corrected=True)
    now = _moved(before, now, data, settings)
    return _checked(_grounded(now, data), data)


def _fresh(now: Standing) -> Standing:
    return replace(
        now, start=now.world, asked=0, grounding=None, first=None, shown=(), corrected=False
    )


def _moved(
    before: Standing, now: Standing, data: Mapping[str, Any], settings: Settings | None
) -> Standing:
    """The world after what was judged, undone, shown and carried out in this turn."""
    judged = isinstance(before.waiting, acts.SelectHypo) and not now.again
    if judged and now.outcome is None:
        now = replace(now, world=now.start)
    for act in now.turn:
        if isinstance(act, acts.RequestDemonstration) and act.reason not in _GOING_ON:
            now = replace(now, world=now.start, shown=(), corrected=False)
        elif isinstance(act, acts.ObserveStep):
            world = _run(now, [act.action], settings)
            now = replace(now, world=world, shown=(*now.shown, act.action))
        elif isinstance(act, acts.CloseEpisode):
            now = _fresh(now)
    done = [] if data["trace"] is None else [Action.parse(text) for text in data["trace"]["done"]]
    return replace(now, world=_run(now, done, settings))


# Here what was shown so far stays.
_GOING_ON = (acts.DemonstrationReason.NO_STEP, acts.DemonstrationReason.NOTHING_CHANGED)


def _run(now: Standing, actions: Sequence[Action], settings: Settings | None) -> State | None:
    world = now.world
    try:
        for action in actions:
            if world is None or settings is None:
                return None
            world = apply(settings(now.scene).task, world, action)
    except (InapplicableError, ValueError):
        return None
    return world


def _grounded(now: Standing, data: Mapping[str, Any]) -> Standing:
    if data["beliefs"] is None:
        return replace(now, grounding=None, first=None)
    rows = data["beliefs"]["grounding"]
    found = {row["phrase"]: tuple(thing for thing, _ in row["objects"]) for row in rows}
    return replace(now, grounding=found, first=now.first or found)


def _checked(now: Standing, data: Mapping[str, Any]) -> Standing:
    if now.world is None or world_digest(now.world) == data["after"]["world"]:
        return now
    return replace(now, world=None)


def _acts(data: Mapping[str, Any]) -> tuple[RobotAct, ...]:
    return tuple(robot_act_from_json(act) for act in data["acts"])
