"""The example corpus: sessions held by simulated people, the same ones wherever it is made.

``python -m verbteach_sessions.example DIR`` makes it as ``verbteach sessions
example --out DIR`` does. Times are drawn, not measured, so that the records
differ between machines in nothing but what the header says of the machine.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from verbteach.dialogue.acts import Say, TeacherAct
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.simulated import SimulatedTeacher
from verbteach.perception.noise import NoiseModel
from verbteach_scenarios.lessons import load_lessons
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.errors import StorageError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.example_plan import Planned, plan
from verbteach_sessions.files import replace_file
from verbteach_sessions.header import Header
from verbteach_sessions.method import Method
from verbteach_sessions.people.habitual import HabitualTeacher
from verbteach_sessions.script import spoken
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Quit

PEOPLE_NAME = "people.json"
FIRST_DAY = datetime(2026, 1, 5, 9, tzinfo=UTC)


@dataclass(frozen=True)
class ExampleParameters:
    """How large the corpus is, and the seed of all of it."""

    sessions: int = 48
    lessons: int = 6
    seed: int = 0


class DrawnClock:
    """Session time that goes on only when somebody thinks."""

    def __init__(self) -> None:
        self._time = 0.0

    def __call__(self) -> float:
        """The time in seconds."""
        return self._time

    def pass_by(self, seconds: float) -> None:
        """Let time pass."""
        self._time += round(seconds, 3)


def make_example(
    folder: Path,
    parameters: ExampleParameters | None = None,
    jobs: int = 1,
    heard: Callable[[int, int], None] | None = None,
) -> tuple[Path, ...]:
    """Hold the sessions, each in its folder under ``folder``; the folders, in order.

    A session that is there is left as it is, so that a corpus that was broken
    off is completed. ``jobs`` processes take part and change nothing. ``heard``
    is told how many are done, and of how many. Raises ``StorageError``.
    """
    chosen = parameters or ExampleParameters()
    planned = plan(load_lessons(), chosen.sessions, chosen.lessons, chosen.seed)
    made = []
    for path in _held(folder, planned, jobs):
        made.append(path)
        if heard is not None:
            heard(len(made), len(planned))
    _keep_people(folder, planned, chosen)
    return tuple(made)


def _held(folder: Path, planned: Sequence[Planned], jobs: int) -> Iterator[Path]:
    if jobs == 1:
        yield from (hold(folder, one, _settings()) for one in planned)
        return
    from joblib import Parallel, delayed  # noqa: PLC0415 - only where processes are wanted

    yield from Parallel(n_jobs=jobs, return_as="generator")(
        delayed(_hold_here)(folder, one) for one in planned
    )


def _hold_here(folder: Path, planned: Planned) -> Path:
    return hold(folder, planned, _settings())


@cache
def _settings() -> Settings:
    return make_settings()


def hold(folder: Path, planned: Planned, settings: Settings) -> Path:
    """Hold one session from its first lesson to the last; its folder."""
    header = _header(planned)
    path = folder / header.id
    if (path / LOG_NAME).is_file():
        return path
    clock = DrawnClock()
    teacher = HabitualTeacher(
        SimulatedTeacher(planned.lessons, settings),
        planned.person.habits,
        settings,
        planned.seed,
    )
    rng = np.random.default_rng([planned.seed, 3])
    draft = folder / f".{header.id}"  # of its own: other processes hold other sessions
    with Session.create(draft, header, settings, clock=clock) as session:
        while (act := teacher.reply(session.turn, session.robot.state)) is not None:
            shown = session.now()
            clock.pass_by(_thinking(act, session.turn.phase, rng))
            session.perform(act, raw=spoken(act), via="simulated", shown_at=shown)
        session.perform(Quit(), raw="quit", via="simulated", shown_at=session.now())
    (draft / header.id).rename(path)
    draft.rmdir()
    return path


def _header(planned: Planned) -> Header:
    day = FIRST_DAY + timedelta(days=planned.number // 4, hours=planned.number % 4)
    rng = np.random.default_rng([planned.seed, 4])
    noise = NoiseModel.named(planned.noise, "literal")
    return Header.new(
        planned.lessons[0].scene,
        Method.named(planned.policy, RobotParameters(seed=planned.seed, noise=noise)),
        interface="simulated",
        teacher="simulated",
        participant=planned.person.code,
        now=lambda: day,
        random=rng.bytes,
    )


def _thinking(act: TeacherAct, phase: Phase, rng: np.random.Generator) -> float:
    """Seconds until a person acts: commands and words take longer than keys."""
    median = 6.0 if phase is Phase.COMMAND else 4.0 if isinstance(act, Say) else 2.0
    return float(median * np.exp(0.5 * rng.standard_normal()))


def _keep_people(folder: Path, planned: Sequence[Planned], parameters: ExampleParameters) -> None:
    """What is true of the people, beside the records and not in them."""
    document: dict[str, Any] = {
        "simulated": True,
        **vars(parameters),
        "people": {one.person.code: one.person.to_json() for one in planned},
        "lessons": {_header(one).id: [x.id for x in one.lessons] for one in planned},
    }
    try:
        replace_file(folder / PEOPLE_NAME, json.dumps(document, indent=1).encode() + b"\n")
    except OSError as error:
        raise StorageError(folder / PEOPLE_NAME, error) from error


def main(words: Sequence[str]) -> int:
    """Make the corpus in the folder named; the exit status."""
    if len(words) != 1:
        print("usage: python -m verbteach_sessions.example DIR", file=sys.stderr)
        return 2
    make_example(Path(words[0]), heard=lambda n, of: print(f"{n}/{of}", file=sys.stderr))
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
