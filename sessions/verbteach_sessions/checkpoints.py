"""States kept beside a log, so that a long session opens without being held again.

They are a cache and never the truth: they serve only while the log is, byte for
byte, what it was, under the same programs and in the same scene. Otherwise they
are as if they were not there, and recomputing the log makes them anew.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from verbteach.dialogue.setting import UnknownSceneError
from verbteach.dialogue.state import RobotState
from verbteach_sessions.chain import Followed, Position
from verbteach_sessions.fold import EVERY, Fold
from verbteach_sessions.lines import canonical, digest
from verbteach_sessions.past_lines import PastLines
from verbteach_sessions.scene_digest import scene_digest
from verbteach_sessions.sealed_file import SealedFile, SealedLine, own_key
from verbteach_sessions.space_pool import SpacePool
from verbteach_sessions.state_codec import StateFormatError, state_from_plain, state_to_plain
from verbteach_sessions.turn_rows import Rows, RowsFormatError

CHECKPOINT_NAME = "checkpoints.cache"
VERSION = 1
_NEAR = 8
_TURNS = "turns"
_STATE = "state"
_LEAST = 1024 * 1024


class StaleCheckpointError(ValueError):
    """The checkpoints do not serve: the log, the scene or the program is another."""


@dataclass(frozen=True)
class _Mark:
    """Where a checkpoint stands, and what it holds under."""

    position: Position
    programs: str
    scene: str
    scene_digest: str
    at_turn: int
    content: str

    def to_json(self) -> dict[str, Any]:
        return {"v": VERSION, **vars(self), "position": list(self.position)}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> _Mark:
        values = {name: data[name] for name in cls.__dataclass_fields__}
        if data["v"] != VERSION:
            raise StaleCheckpointError("of another version")
        return cls(**{**values, "position": Position(*values["position"])})


class Checkpoints:
    """The checkpoints of one log: read once on opening, then appended to."""

    def __init__(self, log: Path, programs: Mapping[str, str]) -> None:
        """``programs`` are the versions of whatever the states come from."""
        self._log = log
        self._programs = digest(canonical(dict(programs)))
        self._rows, self._spaces = Rows(), SpacePool()
        self._mark: _Mark | None = None
        self._states: dict[int, bytes] = {}
        self._open_file()

    def _open_file(self) -> None:
        key = own_key()
        self._file = None if key is None else SealedFile(self._path, key, self._limit())

    @property
    def _path(self) -> Path:
        return self._log.with_name(CHECKPOINT_NAME)

    def _limit(self) -> int:
        """An honest file is far smaller than the log it stands beside."""
        try:
            return _LEAST + 2 * self._log.stat().st_size
        except OSError:
            return _LEAST

    def start(self) -> Position:
        """Read the file; up to where in the log it reaches. The log's beginning if it is no use."""
        try:
            for line in self._file.read() if self._file else ():
                self._take(line)
            if self._mark is not None and self._mark.programs == self._programs:
                return self._mark.position
        except (StaleCheckpointError, RowsFormatError, LookupError, TypeError, ValueError):
            pass
        self.forget()
        return Position()

    def forget(self) -> None:
        """Begin anew: what was read does not serve."""
        self._rows, self._spaces, self._mark = Rows(), SpacePool(), None
        self._states = {}
        if self._file is not None:
            self._file.begin_anew()

    def restore(self, fold: Fold, followed: Followed) -> None:
        """Put ``fold`` where the log stands after the lines that were followed.

        Raises :class:`StaleCheckpointError`, and what ``fold.settings`` raises.
        """
        if self._mark is None:
            raise StaleCheckpointError("there is none")
        lines = PastLines(self._log, followed.begins)
        try:
            history = self._rows.history(lines)
            state = self._state(self._mark.at_turn)
        except (StateFormatError, RowsFormatError) as error:
            raise StaleCheckpointError(str(error)) from error
        current = history.current
        if current is None or state.digest != current.after["digest"]:
            raise StaleCheckpointError("not the state that was recorded")
        try:
            setting = fold.settings(state.scene)
        except UnknownSceneError as error:
            raise StaleCheckpointError("the scene is gone") from error
        if scene_digest(setting.scene) != self._mark.scene_digest:
            raise StaleCheckpointError("the scene has changed")
        fold.restore(history, self._rows.turns, state, self._mark.content, self.saved)

    def saved(self, turn: int) -> RobotState | None:
        """The state kept for the turn with this number, where one was."""
        return self._state(turn) if turn in self._states else None

    def keep(self, fold: Fold, position: Position, *, now: bool = False) -> None:
        """Append a checkpoint if it is time for one, or ``now``. What fails is not kept."""
        new = len(fold.turns) - len(self._rows.turns)
        enough = new >= EVERY or (now and (self._mark is None or position != self._mark.position))
        state = fold.state
        if self._file is None or not enough or state is None or not fold.history.at_rest:
            return
        try:
            lines = self._lines(fold, state, position, _NEAR if now or self._mark is None else 0)
        except StateFormatError:  # a state that holds what has no JSON: nothing is kept of it
            self._file = None
            return
        if not self._file.append(lines):
            self._file = None

    def _take(self, line: SealedLine) -> None:
        if line.kind == _STATE:
            turn, _, text = line.text.partition(b" ")
            self._states[int(turn)] = text
        else:
            data = json.loads(line.text)
            self._mark = _Mark.from_json(data["mark"])
            self._spaces.extend(data["spaces"])
            self._rows.extend(data["rows"])

    def _state(self, turn: int) -> RobotState:
        return state_from_plain(json.loads(self._states[turn]), self._spaces)

    def _lines(
        self, fold: Fold, state: RobotState, position: Position, near: int
    ) -> list[SealedLine]:
        spaces = len(self._spaces)
        to_keep = {**self._near(fold, near), **self._to_keep(fold, state)}
        states = {turn: self._written(state) for turn, state in to_keep.items()}
        current = fold.history.current
        self._mark = _Mark(
            position,
            self._programs,
            state.scene,
            scene_digest(fold.settings(state.scene).scene),
            current.seq if current else 0,
            fold.content.hexdigest,
        )
        data = {
            "mark": self._mark.to_json(),
            "spaces": self._spaces.since(spaces),
            "rows": self._rows.since(fold.history, fold.turns),
        }
        self._states.update(states)
        kept = [
            SealedLine(_STATE, str(turn).encode() + b" " + text) for turn, text in states.items()
        ]
        return [*kept, SealedLine(_TURNS, _compact(data))]

    def _to_keep(self, fold: Fold, state: RobotState) -> dict[int, RobotState]:
        """The state that holds, and of those since the last checkpoint one in ``EVERY``."""
        first = len(self._rows.turns)
        turns = fold.turns[first + EVERY - 1 :: EVERY]
        kept = {t.node.seq: fold.states[t.node.seq] for t in turns if t.node.seq in fold.states}
        current = fold.history.current
        return kept if current is None else {**kept, current.seq: state}

    def _near(self, fold: Fold, count: int) -> dict[int, RobotState]:
        """The states of the last turns before the one that holds, for whoever undoes a few."""
        before = [node.seq for node in fold.history.undoable()[:count]]
        return {
            seq: fold.states[seq]
            for seq in before
            if seq in fold.states and seq not in self._states
        }

    def _written(self, state: RobotState) -> bytes:
        return _compact(state_to_plain(state, self._spaces))


def _compact(value: Any) -> bytes:
    return json.dumps(value, separators=(",", ":"), allow_nan=False).encode()
