"""Teachers that are files: a user fitted to sessions, or a recorded session taught again."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from verbteach_tui.conclusion import WrongUseError

if TYPE_CHECKING:
    from collections.abc import Callable

    from verbteach_sessions.people.population import Population
    from verbteach_sessions.session import Session
    from verbteach_tui.beginning import Beginning

FITTED, RECORDED = "fitted", "recorded"
_PREFIX = f"{FITTED}:"


@dataclass(frozen=True)
class StandIn:
    """A teacher who stands in for people: ``kind`` is ``fitted`` or ``recorded``."""

    kind: str
    path: Path


def stand_in_for(teacher: str) -> StandIn | None:
    """The stand-in that ``--teacher`` names, known by what the file holds; ``None`` for a script.

    Raises :class:`WrongUseError` where ``fitted:FILE`` is no fitted user.
    """
    if teacher.startswith(_PREFIX):
        return StandIn(FITTED, Path(teacher.removeprefix(_PREFIX)))
    path = Path(teacher)
    if (path / "events.jsonl").is_file() or path.name == "events.jsonl":
        return StandIn(RECORDED, path)
    if path.suffix != ".json" or not path.is_file():
        return None
    from verbteach_sessions.people.fitting import is_user

    return StandIn(FITTED, path) if is_user(path) else None


def teach_as_fitted(
    session: Session,
    population: Population,
    lessons: int,
    scene: str | None,
    beginning: Beginning,
    given: Callable[[int], None],
) -> None:
    """Let somebody of the fitted population give the lessons; the session's seed says who.

    A session that was broken off goes on with the lesson it was in.
    """
    import numpy as np

    from verbteach.dialogue.simulated import SimulatedTeacher, seeded_order
    from verbteach_scenarios.lessons import load_lessons
    from verbteach_sessions.driving import drive
    from verbteach_sessions.people.habitual import HabitualTeacher
    from verbteach_sessions.transcript import TEACHER

    found = [one for one in load_lessons() if scene in (None, one.scene)]
    seed = session.header.method.parameters.seed
    begun = sum(line.speaker == TEACHER and line.kind == "command" for line in session.transcript())
    knowing = SimulatedTeacher(seeded_order(found, lessons, seed), beginning.setting, begun)
    person = population.person(np.random.default_rng([seed, 1]))
    teacher = HabitualTeacher(knowing, person, beginning.setting, seed)
    drive(session, teacher, lambda now: given(knowing.given))


def begin_as_recorded(beginning: Beginning, path: Path) -> Session:
    """A new session that begins as the recorded one did: scene, method, seed, what was known."""
    from verbteach_sessions.header import Header
    from verbteach_sessions.people.recorded import read_header
    from verbteach_sessions.session import Session

    recorded = read_header(path)
    header = Header.new(
        recorded.scene,
        recorded.method,
        interface=beginning.interface,
        teacher=beginning.teacher,
        source=recorded.source,
    )
    session = Session.create(beginning.folder, header, beginning.setting)
    beginning.opened.append(session)
    return session


def teach_as_recorded(session: Session, path: Path) -> None:
    """Say again what was said in a record. Raises :class:`WrongUseError` where it diverges."""
    from verbteach_sessions.driving import drive
    from verbteach_sessions.people.exact import DivergedError, RecordedTeacher

    try:
        drive(session, RecordedTeacher(path), via="script")
    except DivergedError as error:
        raise WrongUseError(f"{error}; what was said before is kept in {session.path}") from error
