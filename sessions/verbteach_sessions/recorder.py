"""Writes down what happens: on the disk first, and only then into the fold."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

from verbteach.dialogue.moves import IllegalMoveError
from verbteach.dialogue.setting import UnknownObjectError, UnknownSceneError
from verbteach.language.agreement import NoSecondReaderError
from verbteach_sessions import events as kinds
from verbteach_sessions.chain import Position
from verbteach_sessions.checkpoints import Checkpoints
from verbteach_sessions.errors import StorageError, TooLongError
from verbteach_sessions.eventlog import Draft, EventLog
from verbteach_sessions.fold import Fold, Reply
from verbteach_sessions.lines import Event

# The person's doing: the act does not fit, or what it takes to read it is not installed.
# Nothing of it is kept.
MISFITS = (IllegalMoveError, UnknownSceneError, UnknownObjectError, NoSecondReaderError)


class Recorder:
    """The one way into a session's log; ``now`` gives the session time in seconds."""

    def __init__(
        self,
        log: EventLog,
        fold: Fold,
        now: Callable[[], float],
        checkpoints: Checkpoints | None = None,
    ) -> None:
        self.log = log
        self.fold = fold
        self.now = now
        self._checkpoints = checkpoints

    def add(self, kind: str, data: Mapping[str, Any], at: float | None = None) -> Event:
        """Record an event that the robot does not reply to."""
        (event,) = self.log.append([self._draft(kind, data, at)])
        self.fold.take(event)
        self._checkpoint()
        return event

    def begin(self, root: Event) -> None:
        """Record the robot's first turn after a ``header`` or ``rebuild`` event."""
        self._keep((), self.fold.reply(root))

    def say(self, data: Mapping[str, Any], at: float) -> None:
        """Record the teacher's act, and then the robot's reply to it.

        Raises what does not fit, :class:`StorageError` and :class:`TooLongError`;
        the log is then as it was. A robot that fails otherwise leaves a ``fault`` event, since the
        act has been on the disk.
        """
        before = self.log.position
        (teacher,) = self.log.append([self._draft(kinds.TEACHER, data, at)])
        try:
            self._keep((teacher,), self.fold.reply(teacher))
        except (*MISFITS, StorageError, TooLongError):
            self._take_back(before)
            raise
        except Exception as error:
            self._keep_fault(teacher, error)
            raise
        except BaseException:  # the person has interrupted
            self._take_back(before)
            raise

    def answer(self, teacher: Event) -> str:
        """Record the reply to an act that an earlier process recorded; what went wrong, if so."""
        try:
            self._keep((), self.fold.reply(teacher))
        except (StorageError, NoSecondReaderError):
            raise
        except Exception as error:
            self.refuse(teacher, error)
            return str(error)
        return ""

    def refuse(self, teacher: Event, error: Exception) -> None:
        """Record that the robot will not reply to the act."""
        self.add(kinds.FAULT, _fault(teacher, error))

    def close(self) -> None:
        """Let go of the log, keeping where it stands. Closing twice is harmless."""
        if not self.log.closed:
            self._checkpoint(now=True)
        self.log.close()

    def _keep(self, said: tuple[Event, ...], reply: Reply) -> None:
        at = self.now()
        drafts = [Draft(kinds.ROBOT, at, reply.robot)]
        if reply.learned is not None:
            drafts.insert(0, Draft(kinds.LEARNED, at, reply.learned))
        *others, robot = self.log.append(drafts)
        for event in (*said, *others):
            self.fold.take(event)
        self.fold.take(robot, reply)
        self._checkpoint()

    def _checkpoint(self, *, now: bool = False) -> None:
        if self._checkpoints is not None:
            self._checkpoints.keep(self.fold, self.log.position, now=now)

    def _keep_fault(self, teacher: Event, error: Exception) -> None:
        (fault,) = self.log.append([self._draft(kinds.FAULT, _fault(teacher, error))])
        self.fold.take(teacher)
        self.fold.take(fault)

    def _take_back(self, before: Position) -> None:
        with suppress(StorageError):  # the log now refuses more; the first error says why
            self.log.take_back(before)

    def _draft(self, kind: str, data: Mapping[str, Any], at: float | None = None) -> Draft:
        return Draft(kind, self.now() if at is None else at, data)


def _fault(teacher: Event, error: Exception) -> Mapping[str, Any]:
    return {"reply_to": teacher.seq, "error": type(error).__name__, "message": str(error)}
