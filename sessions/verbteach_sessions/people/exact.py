"""A recorded person as a teacher: says again what was said, as long as the robot does the same."""

from __future__ import annotations

from pathlib import Path

from verbteach.dialogue.acts import RobotAct, TeacherAct
from verbteach.dialogue.codec import robot_act_from_json, robot_act_to_json, teacher_act_from_json
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach_sessions import events as kinds
from verbteach_sessions.account import Account
from verbteach_sessions.errors import SessionError
from verbteach_sessions.lines import Event


class DivergedError(SessionError):
    """The robot did something else than in the record, which so holds no answer to it."""

    def __init__(self, path: Path, seq: int, recorded: RobotAct, now: RobotAct, where: str) -> None:
        self.seq, self.recorded, self.now = seq, recorded, now
        super().__init__(
            f"{path}: the dialogue left the record at event {seq}: there the robot came to"
            f" {_told(recorded)}, now to {_told(now)}{where}; the record has no answer to that"
        )


class RecordedTeacher:
    """The teacher of a record; what was undone is left out. Implements ``Teacher``.

    ``said`` counts the acts given so far.
    """

    def __init__(self, path: Path) -> None:
        """Read a session's folder or log. Raises the errors of reading a log."""
        account, robots = Account(path), dict[int, Event]()
        for event in account:
            if event.type == kinds.ROBOT:
                robots[event.seq] = event
        self._path = account.reader.path
        self._script = [
            (robots[node.parent.seq], node.teacher)
            for node in account.history.effective()
            if node.parent is not None  # the first turn of all replies to nobody
        ]
        self.said = 0

    def reply(self, turn: RobotTurn, state: RobotState) -> TeacherAct | None:
        """The recorded act; ``None`` after the last. Raises :class:`DivergedError`."""
        if self.said >= len(self._script):
            return None
        before, teacher = self._script[self.said]
        self._check(before, turn, state)
        if teacher is None:
            raise SessionError(
                f"{self._path}: the session was rebuilt after event {before.seq}, where the scene"
                " began anew by itself; its teacher can be followed up to there"
            )
        self.said += 1
        return teacher_act_from_json(teacher.data["act"])

    def _check(self, recorded: Event, turn: RobotTurn, state: RobotState) -> None:
        before = robot_act_from_json(recorded.data["acts"][-1])
        scene = recorded.data["after"]["scene"]
        same = robot_act_to_json(turn.waiting_act) == recorded.data["acts"][-1]
        if not same or state.scene != scene or turn.phase.value != recorded.data["phase"]:
            where = "" if state.scene == scene else f", and in {state.scene} instead of {scene}"
            raise DivergedError(self._path, recorded.seq, before, turn.waiting_act, where)


def _told(act: RobotAct) -> str:
    """An act with its arguments, on one line."""
    terms = {name: value for name, value in robot_act_to_json(act).items() if name != "act"}
    told = ", ".join(f"{name} {_shown(value)}" for name, value in terms.items())
    return f"{act.name} ({told})" if told else act.name


def _shown(value: object) -> str:
    return " ".join(map(str, value)) if isinstance(value, list) else str(value)
