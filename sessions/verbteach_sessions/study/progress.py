"""How far a participant is: the fold of the record of the visit, read without writing."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

from verbteach_sessions.errors import LogError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.lines import Event
from verbteach_sessions.shapes import wrong_fields
from verbteach_sessions.study import visit_events as kinds

VISIT_NAME = "visit.jsonl"


class Progress:
    """What the events so far come to; grows by :meth:`take`.

    ``done`` says why each finished step ended, ``sessions`` which session each
    begun step has, both by the step's number. ``seen`` is when the participant
    was here last, ``completion`` the code that the thanks showed.
    """

    def __init__(self) -> None:
        self.enrolled: Mapping[str, Any] = {}
        self.done: dict[int, str] = {}
        self.sessions: dict[int, str] = {}
        self.seen = ""
        self.completion = ""

    @classmethod
    def read(cls, folder: Path) -> Progress:
        """The progress of the participant with this folder. Raises the errors of reading a log."""
        progress, reader = cls(), LogReader(folder / VISIT_NAME)
        for event in reader:
            progress.take_from(reader.path, event)
        return progress

    @property
    def code(self) -> str:
        """The participant's code."""
        return str(self.enrolled["participant"])

    @property
    def slot(self) -> int:
        """The participant's place."""
        return int(self.enrolled["slot"])

    @property
    def order(self) -> tuple[str, ...]:
        """The conditions in the order they come."""
        return tuple(self.enrolled["order"])

    @property
    def step(self) -> int:
        """The number of the step that the participant is at: the first that is not done."""
        return next(n for n in range(len(self.done) + 1) if n not in self.done)

    def take_from(self, path: Path, event: Event) -> None:
        """Take an event that stands in ``path``. Raises ``LogError`` where it does not fit."""
        shape = kinds.VISIT_EVENTS.get(event.type)
        problem = "is no event of a visit" if shape is None else ""
        if shape is not None:
            problem = next(wrong_fields(shape, event.data), "")
        if not problem and (event.type == kinds.ENROLLED) == bool(self.enrolled):
            problem = "a visit begins with its enrolment and has only one"
        if problem:
            raise LogError(path, event.seq + 1, f"{event.type}{problem}")
        self.take(event)

    def take(self, event: Event) -> None:
        """Take an event that fits."""
        data = event.data
        if event.type == kinds.ENROLLED:
            self.enrolled = data
        elif event.type == kinds.BEGAN:
            self.sessions[data["step"]] = data["session"]
        elif event.type == kinds.DONE:
            self.done[data["step"]] = data["why"]
        elif event.type == kinds.FINISHED:
            self.completion = data["completion"]
        self.seen = _moment(self.enrolled.get("created", ""), event.at)


def _moment(begun: str, seconds: float) -> str:
    """The time of day so many seconds after ``begun``, or that where no such time can be told."""
    try:
        moment = datetime.fromisoformat(begun) + timedelta(seconds=seconds)
    except (ValueError, OverflowError):
        return begun
    return moment.isoformat(timespec="seconds")
