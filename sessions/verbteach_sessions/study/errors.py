"""What can be wrong with a study: its file, or what a participant asks of it; never a bug."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from verbteach_sessions.errors import SessionError


class Problem(NamedTuple):
    """Something in a study's file that does not fit; ``line`` counts from 1, 0 is the whole."""

    line: int
    message: str


class StudyError(SessionError):
    """Something about a study that its people can put right."""


class StudyFileError(StudyError):
    """The study's file does not fit. ``problems`` are all that were found, in the file's order."""

    def __init__(self, path: Path, problems: Sequence[Problem]) -> None:
        self.path, self.problems = path, tuple(sorted(problems))
        line, message = self.problems[0]
        place = f"{path}:{line}" if line else str(path)
        more = len(self.problems) - 1
        rest = f" (and {more} more: 'verbteach study check' lists them)" if more else ""
        super().__init__(f"{place}: {message}{rest}")


class VisitError(StudyError):
    """The participant's own record does not fit the study, or not what is asked of it."""
