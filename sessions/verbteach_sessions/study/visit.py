"""A participant's way through a study, open for writing: where it stands, and what comes next.

It shows nothing and holds no session; whoever does tells it what was begun and
what is over. Each such word is on the disk before the next step shows.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection
from datetime import datetime
from pathlib import Path
from typing import Any

from verbteach_sessions.eventlog import Draft, EventLog
from verbteach_sessions.names import Random, utc_now
from verbteach_sessions.study import visit_events as kinds
from verbteach_sessions.study.counterbalance import seed_of
from verbteach_sessions.study.design import Condition, Lessons, Study
from verbteach_sessions.study.enrolment import copy_of, enrol, has_enrolled, new_completion_code
from verbteach_sessions.study.errors import VisitError
from verbteach_sessions.study.progress import VISIT_NAME, Progress
from verbteach_sessions.study.steps import Kind, Step, lessons_of, steps_of
from verbteach_sessions.study.stopping import STOPPED
from verbteach_sessions.study.study_file import read_study

Clock = Callable[[], datetime]
READ = "read"
"""Why a step that is only looked at is over."""


class Visit:
    """One participant in one study; made by :meth:`enter` or :meth:`come_back`, closed at the end.

    ``home`` is the participant's own folder, where the sessions are.
    """

    def __init__(
        self, home: Path, study: Study, log: EventLog, progress: Progress, now: Clock = utc_now
    ) -> None:
        self.home, self.study = home, study
        self.steps = steps_of(study, progress.order)
        self._log, self._progress, self._now = log, progress, now
        self._enrolled = datetime.fromisoformat(progress.enrolled["created"])

    @classmethod
    def enter(
        cls,
        folder: Path,
        study: Study,
        source: bytes,
        code: str,
        interface: str,
        now: Clock = utc_now,
    ) -> Visit:
        """The participant has consented for the first time. Raises as ``enrol`` does."""
        log, progress = enrol(folder, study, source, code, interface, now())
        return cls(folder / code, study, log, progress, now)

    @classmethod
    def come_back(
        cls,
        folder: Path,
        study_id: str,
        code: str,
        interface: str,
        scenes: Collection[str],
        now: Clock = utc_now,
    ) -> Visit:
        """The participant is here again; the study is as it was when they began.

        Raises ``VisitError``, ``StudyFileError``, ``SessionInUseError`` where the
        participant is here already, and the errors of reading a log.
        """
        if not has_enrolled(folder, code):
            raise VisitError(f"{folder / code}: no participant of this code has begun")
        home, progress = folder / code, Progress()
        path = home / VISIT_NAME
        log, _ = EventLog.open(path, lambda event: progress.take_from(path, event))
        try:
            if progress.enrolled["study"] != study_id:
                raise VisitError(f"{home}: is of the study {progress.enrolled['study']!r}")
            copy = copy_of(folder, progress.enrolled["study_hash"])
            study = read_study(copy, scenes, dict(progress.enrolled.get("weights", ())))
            visit = cls(home, study, log, progress, now)
            created = now().isoformat(timespec="seconds")
            visit._write(kinds.OPENED, {"created": created, "interface": interface})
        except BaseException:
            log.close()
            raise
        return visit

    @property
    def code(self) -> str:
        """The participant's code, by which the record can be withdrawn."""
        return self._progress.code

    @property
    def slot(self) -> int:
        """The participant's place in the order of participants."""
        return self._progress.slot

    @property
    def number(self) -> int:
        """The number of the step that the participant is at."""
        return min(self._progress.step, len(self.steps) - 1)

    @property
    def step(self) -> Step:
        """The step that the participant is at; the last one stays."""
        return self.steps[self.number]

    @property
    def condition(self) -> Condition:
        """The condition of the step. Raises ``KeyError`` where it has none."""
        return self.study.by_id[self.step.condition]

    @property
    def seed(self) -> int:
        """The seed of the step's session."""
        part = 0 if self.step.kind is Kind.PRACTICE else self.step.part
        return seed_of(self.study, self.slot, part)

    @property
    def session(self) -> Path | None:
        """The folder of the session that was begun in this step, if one was."""
        name = self._progress.sessions.get(self.number)
        return None if name is None else self.home / name

    @property
    def last_session(self) -> Path | None:
        """The folder of the session that was begun last, in whatever step but the practice."""
        held = [
            name
            for number, name in sorted(self._progress.sessions.items())
            if self.steps[number].kind is Kind.LESSONS and number <= self.number
        ]
        return self.home / held[-1] if held else None

    def header(self) -> dict[str, Any]:
        """What the header of the step's session says of the study."""
        step, enrolled = self.step, self._progress.enrolled
        return {
            "id": self.study.id,
            "study_hash": self.study.file_hash,
            "consent": dict(enrolled["consent"]),
            "slot": self.slot,
            "order": list(self._progress.order),
            "step": step.kind.value,
            "part": step.part,
            "condition": self.condition.to_json(),
            "questions": self.lessons.stop.questions,
        }

    @property
    def lessons(self) -> Lessons:
        """What is taught in this step."""
        return lessons_of(self.study, self.step)

    def began(self, session: str) -> None:
        """The step's session was begun; one that was begun before no longer counts."""
        self._write(kinds.BEGAN, {"step": self.number, "session": session})

    def done(self, why: str = READ) -> None:
        """The step is over; the last one never is."""
        if self.number < len(self.steps) - 1:
            self._write(kinds.DONE, {"step": self.number, "why": why})

    def stop(self) -> None:
        """The participant wants no more teaching: on to what is asked at the end."""
        first, part, taught = self.number, self.step.part, self.last_session is not None
        for number, step in enumerate(self.steps[:-1]):
            asked = step.kind is Kind.QUESTIONNAIRE and step.part in (0, part) and taught
            if number >= first and not asked:
                self._write(kinds.DONE, {"step": number, "why": STOPPED})

    def completion(self, random: Random = os.urandom) -> str:
        """The completion code, drawn when the thanks are first shown."""
        if self.step.kind is not Kind.THANKS:
            raise VisitError("the study is not over yet")
        if not self._progress.completion:
            self._write(kinds.FINISHED, {"completion": new_completion_code(random)})
        return self._progress.completion

    def close(self) -> None:
        """Let go of the record. Closing twice is harmless."""
        self._log.close()

    def __enter__(self) -> Visit:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def _write(self, kind: str, data: dict[str, Any]) -> None:
        at = round(max((self._now() - self._enrolled).total_seconds(), 0.0), 1)
        for event in self._log.append([Draft(kind, at, data)]):
            self._progress.take(event)
