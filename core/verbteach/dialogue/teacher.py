"""The interface of teachers: whoever answers the robot, a person, a script or a simulation."""

from __future__ import annotations

from typing import Protocol

from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn


class Teacher(Protocol):
    """Says one thing whenever the robot waits."""

    def reply(self, turn: RobotTurn, state: RobotState) -> TeacherAct | None:
        """The teacher's act for what ``turn`` waits for; ``None`` when there is no more to say."""
        ...
