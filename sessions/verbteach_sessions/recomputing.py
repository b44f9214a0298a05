"""Folding a recorded log: every reply is computed again and compared with what was recorded."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from verbteach.dialogue.codec import ActFormatError, teacher_act_from_json
from verbteach.dialogue.setting import Settings, UnknownSceneError
from verbteach.language.agreement import NoSecondReaderError
from verbteach_sessions import events as kinds
from verbteach_sessions.events import EVENT_TYPES, FITTING
from verbteach_sessions.fold import Fold, Reply
from verbteach_sessions.lines import Event
from verbteach_sessions.recording import after
from verbteach_sessions.shapes import wrong_fields


class EventError(ValueError):
    """An event that cannot stand where it stands, or whose data is of the wrong kind."""


@dataclass(frozen=True)
class Difference:
    """Where recomputing gave something else: the event, the field, and both values."""

    seq: int
    field: str
    recorded: Any
    recomputed: Any

    def to_json(self) -> dict[str, Any]:
        """The four fields."""
        return asdict(self)


class Recomputing:
    """Takes a log's events in order.

    ``difference`` is the first one found. After a difference nothing more is
    computed until a ``rebuild`` event starts from what was recorded;
    ``diverged`` says whether that is so now.
    """

    def __init__(self, settings: Settings, *, brief: bool = False) -> None:
        self.fold = Fold(settings, brief=brief)
        self.difference: Difference | None = None
        self.diverged = False

    def take(self, event: Event) -> None:
        """Check, recompute, compare and add one event.

        Raises :class:`EventError`, ``UnknownSceneError`` for the scene that the
        session begins in, ``NoSecondReaderError`` where the session was held with
        one and there is none, ``UnknownPolicyError`` and ``UnsafeNameError``.
        """
        check_fields(event)
        if event.type == kinds.REBUILD:
            self.diverged, self.fold.recalls = False, True
        reply = self._recomputed(event)
        try:
            self.fold.take(event, reply)
        except ValueError as error:  # OrderError, and a header that says what cannot be
            raise EventError(str(error)) from error
        if event.type in (kinds.UNDO, kinds.REDO) and not self.diverged:
            self._compare(event, "after", event.data["after"], after(self.fold.robot.state))

    def _recomputed(self, event: Event) -> Reply | None:
        owed = self.fold.history.root or self.fold.history.teacher
        if event.type != kinds.ROBOT or self.diverged or owed is None:
            return None
        try:
            reply = self.fold.reply(owed)
        except NoSecondReaderError:  # says nothing of the record, only of this installation
            raise
        except UnknownSceneError:
            if owed.type == kinds.HEADER:
                raise
            self._differ(event, "acts", event.data["acts"], "the scene is not known")
            return None
        except Exception as error:  # whatever it is, the record stands and this differs
            self._differ(event, "acts", event.data["acts"], f"{type(error).__name__}: {error}")
            return None
        return reply if self._agrees(event, reply) else None

    def _agrees(self, event: Event, reply: Reply) -> bool:
        learned = self.fold.history.learned
        if (learned is None) != (reply.learned is None):
            recorded = None if learned is None else learned.data["record"]
            recomputed = None if reply.learned is None else reply.learned["record"]
            self._differ(event, "record", recorded, recomputed)
        elif learned is not None and reply.learned is not None:
            self._compare(learned, "record", learned.data["record"], reply.learned["record"])
        for name in reply.robot:
            self._compare(event, name, event.data[name], reply.robot[name])
        return not self.diverged

    def _compare(self, event: Event, name: str, recorded: Any, recomputed: Any) -> None:
        found = first_difference(recorded, recomputed, name)
        if found is not None:
            self._differ(event, *found)

    def _differ(self, event: Event, field: str, recorded: Any, recomputed: Any) -> None:
        if not self.diverged and self.difference is None:
            self.difference = Difference(event.seq, field, recorded, recomputed)
        self.diverged, self.fold.recalls = True, False


def check_fields(event: Event) -> None:
    """Raise :class:`EventError` unless the event's type is known and its fields can be read."""
    kind = EVENT_TYPES.get(event.type)
    if kind is None:
        raise EventError(f"there is no event type {event.type!r}")
    if not FITTING[event.type](event.data):
        problem = next(wrong_fields(kind, event.data), "")
        raise EventError(f"{event.type}{problem}")
    if event.type == kinds.TEACHER:
        try:
            teacher_act_from_json(event.data["act"])
        except ActFormatError as error:
            raise EventError(f"teacher.act: {error}") from error


def first_difference(recorded: Any, recomputed: Any, path: str) -> tuple[str, Any, Any] | None:
    """The path of the first leaf that differs, with both values; ``None`` where all agree."""
    if isinstance(recorded, Mapping) and isinstance(recomputed, Mapping):
        names = sorted({*recorded, *recomputed})
        pairs = [(f"{path}.{name}", recorded.get(name), recomputed.get(name)) for name in names]
    elif isinstance(recorded, list) and isinstance(recomputed, list):
        if len(recorded) != len(recomputed):
            return path, recorded, recomputed
        items = enumerate(zip(recorded, recomputed, strict=True))
        pairs = [(f"{path}[{index}]", one, other) for index, (one, other) in items]
    else:
        return None if recorded == recomputed else (path, recorded, recomputed)
    found = (first_difference(one, other, name) for name, one, other in pairs)
    return next((difference for difference in found if difference is not None), None)
