"""A session: a robot, the teacher's acts, and the log that holds all of it before anyone sees it.

One :meth:`Session.perform` is one act of the person. The teacher's act is on
the disk before the robot thinks about it, the robot's reply before it is shown.
"""

from __future__ import annotations

import shutil
import time
from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from verbteach.dialogue.acts import QUESTIONS, AskAgain, TeacherAct
from verbteach.dialogue.codec import teacher_act_to_json
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState
from verbteach.dialogue.turn import RobotTurn
from verbteach_sessions import events as kinds
from verbteach_sessions.checkpoints import Checkpoints
from verbteach_sessions.errors import CannotUndoError, SessionEndedError
from verbteach_sessions.eventlog import EventLog
from verbteach_sessions.files import make_private_folder
from verbteach_sessions.fold import Fold
from verbteach_sessions.header import Header, Machine
from verbteach_sessions.header_file import write_header
from verbteach_sessions.history import Node
from verbteach_sessions.recorder import Recorder
from verbteach_sessions.recording import after
from verbteach_sessions.resuming import reopen
from verbteach_sessions.session_acts import Flag, Note, Quit, Redo, Repeat, SessionAct, Undo, Why
from verbteach_sessions.transcript import Line, Transcript

Clock = Callable[[], float]


class Session:
    """An open session; make one with :meth:`create` or :meth:`resume`.

    ``path`` is its folder, ``recovered`` what to tell the person about repairs,
    ``said`` what the robot said last, an explanation or a repetition included.
    """

    def __init__(self, recorder: Recorder, recovered: tuple[str, ...] = ()) -> None:
        self.path = recorder.log.path.parent
        self.recovered = recovered
        self._recorder = recorder
        self._fold = recorder.fold
        rewards = self.header.method.parameters.rewards
        self._transcript = Transcript(recorder.fold.history, rewards)
        self.said = self.turn.texts

    @classmethod
    def create(
        cls, folder: Path, header: Header, settings: Settings, *, clock: Clock = time.monotonic
    ) -> Session:
        """Begin a session: make its folder in ``folder``, and open the scene.

        Raises ``UnknownSceneError`` and ``NoSecondReaderError`` before anything is
        made, and ``StorageError``.
        """
        header.method.settings(settings)(header.scene)
        opened = clock()
        path = folder / header.id
        make_private_folder(path)
        with ExitStack() as undoing:  # nobody has seen the session before it is returned
            undoing.callback(shutil.rmtree, path, ignore_errors=True)
            log = EventLog.create(path)
            undoing.callback(log.close)
            machine = header.machine
            recorder = Recorder(
                log,
                Fold(settings, brief=True),
                lambda: round(clock() - opened, 4),
                Checkpoints(log.path, {"Python": machine.python, **machine.software}),
            )
            first = recorder.add(kinds.HEADER, header.to_json(), 0.0)
            write_header(path, first)
            recorder.begin(first)
            undoing.pop_all()
        return cls(recorder)

    @classmethod
    def resume(
        cls,
        path: Path,
        settings: Settings,
        *,
        machine: Machine | None = None,
        clock: Clock = time.monotonic,
    ) -> Session:
        """Go on with a session, given its folder or its log.

        Raises the errors of reading a log, ``SessionInUseError``,
        ``StorageError``, ``UnknownSceneError`` and ``NoSecondReaderError``.
        """
        reopened = reopen(path, settings, machine or Machine.here("script"), clock)
        return cls(reopened.recorder, reopened.recovered)

    @property
    def robot(self) -> Robot:
        """The robot, in the state that holds."""
        return self._fold.robot

    @property
    def turn(self) -> RobotTurn:
        """The robot's turn that holds."""
        return self.robot.turn

    @property
    def header(self) -> Header:
        """What was settled before the session began."""
        return self._fold.header

    @property
    def ended(self) -> bool:
        """Whether the person has left."""
        return self._fold.history.ended

    @property
    def can_undo(self) -> bool:
        """Whether there is an act to take back."""
        return self._fold.history.can_undo

    @property
    def can_redo(self) -> bool:
        """Whether there is an act to do again."""
        return self._fold.history.redone is not None

    @property
    def content_hash(self) -> str:
        """The hash of what was said so far; free of times and of the interface."""
        return self._fold.content.hexdigest

    def now(self) -> float:
        """Session time in seconds: it stands still while the session is closed."""
        return self._recorder.now()

    def turns(self) -> tuple[Node, ...]:
        """The turns that hold, from the first to the one on the screen."""
        return self._fold.history.effective()

    def transcript(self) -> tuple[Line, ...]:
        """What was said and still holds, in order; notes stay when their turn is undone."""
        return self._transcript.lines()

    def state_after(self, turn: Node) -> RobotState | None:
        """The robot's state after one of its turns; ``None`` where it was not computed."""
        return self._fold.kept(turn)

    @property
    def redoable(self) -> tuple[Node, ...]:
        """The turns that were taken back and can be done again, the next one first."""
        return tuple(reversed(self._fold.history.redoable))

    def perform(
        self,
        act: TeacherAct | SessionAct,
        *,
        raw: str = "",
        via: str = "typed",
        shown_at: float | None = None,
        in_view: Collection[str] = (),
    ) -> RobotTurn:
        """Let the person act; the robot's turn that then holds.

        ``raw`` is what was typed or pressed, ``via`` how, ``shown_at`` the
        session time at which the turn was shown, and ``in_view`` the panels that
        the person could see since then. Raises ``IllegalMoveError``,
        ``UnknownSceneError``, ``UnknownObjectError``, ``CannotUndoError`` and
        ``StorageError``; log and state are then as they were.
        """
        if self.ended:
            raise SessionEndedError(f"{self.path}: the session has ended; resume it to go on")
        now = self.now()
        person = {
            "reply_to": self._node.seq,
            "raw": raw,
            "via": via,
            "shown_at": shown_at,
            "answered_at": now,
            **({"in_view": sorted(in_view)} if in_view else {}),
        }
        said = self._perform(act, person, now)
        self.said = self.turn.texts if said is None else said
        return self.turn

    def close(self) -> None:
        """Let go of the log; the session can be resumed. Closing twice is harmless."""
        self._recorder.close()

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def _perform(
        self, act: TeacherAct | SessionAct, person: Mapping[str, Any], now: float
    ) -> tuple[str, ...] | None:
        """What the robot says where it does not just take its turn."""
        match act:
            case Undo(turns=turns):
                self._move(kinds.UNDO, self._undone(turns), person, now)
            case Redo(turns=turns):
                self._move(kinds.REDO, self._redone(turns), person, now)
            case Why():
                return self._remark(kinds.WHY, self.robot.explain(), person, now)
            case Repeat():
                return self._remark(kinds.REPEAT, self.robot.repeat(), person, now)
            case Flag():
                self._recorder.add(kinds.FLAGGED, person, now)
            case Note(text=text):
                self._recorder.add(kinds.NOTE, {**person, "text": text}, now)
            case Quit():
                self._recorder.add(kinds.END, person, now)
            case _:
                self._recorder.say({**person, "act": teacher_act_to_json(act)}, now)
        return None

    @property
    def _node(self) -> Node:
        node = self._fold.history.current
        if node is None:
            raise RuntimeError("an open session has a robot turn")
        return node

    def _undone(self, turns: int) -> Node:
        back = self._fold.history.undoable()
        if turns > len(back):
            raise CannotUndoError(_too_far(len(back), "take back"))
        return back[turns - 1]

    def _redone(self, turns: int) -> Node:
        forward = self._fold.history.redoable
        if turns > len(forward):
            raise CannotUndoError(_too_far(len(forward), "do again"))
        return forward[-turns]

    def _move(self, kind: str, to: Node, person: Mapping[str, Any], now: float) -> None:
        data = {**person, "to": to.seq, "after": after(self._fold.state_of(to))}
        self._recorder.add(kind, data, now)

    def _remark(
        self, kind: str, texts: tuple[str, ...], person: Mapping[str, Any], now: float
    ) -> tuple[str, ...]:
        self._recorder.add(kind, {**person, "texts": list(texts)}, now)
        return texts


def _too_far(there_are: int, what: str) -> str:
    if there_are == 0:
        return f"there is nothing to {what}"
    return f"there {'is' if there_are == 1 else 'are'} only {there_are} to {what}"


def _by_type(turns: Sequence[Node]) -> dict[str, int]:
    """How often each type of question was asked in turns that hold; one put again counts once."""
    names = {kind.name for kind in QUESTIONS}
    asked = Counter(
        turn.acts[-1] for turn in turns if turn.acts[-1] in names and AskAgain.name not in turn.acts
    )
    return dict(sorted(asked.items()))


def summary(session: Session) -> dict[str, Any]:
    """What ``teach --json`` prints; counts are of the turns that hold."""
    state = session.robot.state
    totals = state.totals
    promise = session.header.method.promise
    made = promise and {"rate": promise.rate, "sure": promise.sure, "lessons": promise.lessons}
    return {
        "session": str(session.path),
        "episodes": totals.episodes,
        "successes": totals.successes,
        "questions": totals.questions,
        "questions_by_type": _by_type(session.turns()),
        "verbs_learned": list(state.knowledge.verbs),
        "reward": totals.reward,
        "content_hash": session.content_hash,
        **({"promise": made} if made else {}),
    }
