"""Sessions without a person at them: a script's lines, or the simulated teacher's lessons."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.simulated import SimulatedTeacher, TeacherHabits, seeded_order
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.errors import ScriptError
from verbteach_sessions.session import Session
from verbteach_sessions.transcript import TEACHER
from verbteach_tui.conclusion import WrongUseError

STANDARD_INPUT = "-"
Tell = Callable[[str], None]


def play_script(session: Session, script: str, lines: Iterable[str], tell: Tell) -> None:
    """Let the ``lines`` of ``script`` teach, and ``tell`` what is said.

    Raises :class:`WrongUseError` at the first line that does not fit.
    """
    teacher = ScriptTeacher(_echoed(lines, tell))
    try:
        drive(session, teacher, lambda now: _robot(now, tell), via="script")
    except ScriptError as error:
        place = f"{_called(script)}, line {error.line}"
        kept = f"what was said before is kept in {session.path}"
        raise WrongUseError(f"{place}: {error.reason}; {kept}") from error


@contextmanager
def script_lines(script: str) -> Iterator[Iterator[str]]:
    """The lines of a file (``-``: of standard input), read as they are needed.

    Raises ``OSError`` where there is no such file.
    """
    if script == STANDARD_INPUT:
        stream = getattr(sys.stdin, "buffer", None)
        yield iter(sys.stdin) if stream is None else _decoded(stream, script)
    else:
        with Path(script).open("rb") as file:
            yield _decoded(file, script)


def _decoded(lines: Iterable[bytes], script: str) -> Iterator[str]:
    for number, line in enumerate(lines, start=1):
        try:
            yield line.decode("utf-8-sig" if number == 1 else "utf-8")
        except UnicodeDecodeError as error:
            raise WrongUseError(f"{_called(script)}, line {number}: is not UTF-8 text") from error


def _called(script: str) -> str:
    return "standard input" if script == STANDARD_INPUT else script


def _echoed(lines: Iterable[str], tell: Tell) -> Iterator[str]:
    for line in lines:
        if line.strip() and not line.strip().startswith("#"):
            tell(f"You: {line.strip()}")
        yield line


def _robot(session: Session, tell: Tell) -> None:
    for text in session.said:
        tell(f"Robot: {text}")


def simulate(
    session: Session,
    lessons: Sequence[Lesson],
    count: int,
    settings: Settings,
    given: Callable[[int], None],
    habits: TeacherHabits | None = None,
) -> None:
    """Let the simulated teacher give ``count`` lessons, in an order that the session's seed sets.

    A session that was broken off goes on with the lesson it was in. ``given``
    hears how many lessons have been begun, whenever that changes.
    """
    seed = session.header.method.parameters.seed
    begun = sum(line.speaker == TEACHER and line.kind == "command" for line in session.transcript())
    teacher = SimulatedTeacher(seeded_order(lessons, count, seed), settings, begun, habits)
    drive(session, teacher, lambda now: given(teacher.given))
