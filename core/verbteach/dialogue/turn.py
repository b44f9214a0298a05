"""One turn of the robot: what it says and does, what it then waits for, and why."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from verbteach.dialogue.acts import RobotAct
from verbteach.dialogue.decision import Decision
from verbteach.dialogue.moves import Phase
from verbteach.world.fluents import State
from verbteach.world.plan import Action


@dataclass(frozen=True)
class Trace:
    """An execution on the true world.

    ``states`` has one state more than ``done`` has actions: ``states[k]`` is the
    world after ``k`` steps. ``failed`` is the first action that could not be done.
    """

    done: tuple[Action, ...]
    states: tuple[State, ...]
    failed: Action | None = None
    obstacle: str = ""


@dataclass(frozen=True)
class RobotTurn:
    """What the robot says after the teacher's act.

    ``acts`` and ``texts`` run in parallel; the last act is the one that waits.
    ``reading`` says how the teacher's act was read; ``reward`` is what it earned.
    ``trace`` is there when the turn executed a plan. ``decisions`` are the choices
    made in it, in order. ``learned`` is the JSON-ready record of what was learned.
    """

    acts: tuple[RobotAct, ...]
    texts: tuple[str, ...]
    phase: Phase
    reading: str = ""
    reward: float = 0.0
    trace: Trace | None = None
    decisions: tuple[Decision, ...] = ()
    learned: Mapping[str, Any] | None = field(default=None)

    @property
    def waiting_act(self) -> RobotAct:
        """The act that the teacher's next act answers."""
        return self.acts[-1]
