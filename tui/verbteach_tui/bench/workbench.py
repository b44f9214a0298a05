"""What the parts of the benchmark work on: the lessons, the planner, a folder to throw away."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Literal

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Settings
from verbteach.world import compiled
from verbteach.world.planner import PlannerPath
from verbteach_scenarios.lessons import load_lessons
from verbteach_scenarios.settings import make_settings
from verbteach_tui.bench import planning
from verbteach_tui.bench.allowance import Allowance
from verbteach_tui.bench.dialogue import Turns, long_session
from verbteach_tui.bench.questions import Question, of_corpus, of_lessons, spread
from verbteach_tui.commands.streams import Progress, counting

PlannerChoice = Literal["auto", "plain"]


@dataclass(frozen=True)
class Amounts:
    """How much of everything is measured, given the time.

    ``before`` turns are held before ``timed`` ones, ``app`` in the app whose
    memory is looked at, and ``replayed`` in the record that is recomputed.
    """

    questions: int = 200
    peers_questions: int = 40
    before: int = 500
    timed: int = 300
    app: int = 1000
    replayed: int = 200


AMOUNTS = Amounts()


@dataclass(frozen=True)
class Workbench:
    """Where sessions are made, with which planner, and for how many seconds a part.

    ``data`` is a Tell Me Dave folder to plan on instead of the lessons.
    """

    folder: Path
    show: Progress
    seconds: float
    data: Path | None = None
    planner: PlannerChoice = "auto"
    amounts: Amounts = field(default_factory=lambda: AMOUNTS)

    @cached_property
    def lessons(self) -> Sequence[Lesson]:
        """The bundled lessons."""
        return load_lessons()

    @property
    def paths(self) -> tuple[PlannerPath, ...]:
        """The ways to plan that are measured, the quickest last."""
        return ("plain",) if self.planner == "plain" else planning.paths()

    @property
    def without(self) -> tuple[str, ...]:
        """The packages that processes started for a part are to do without."""
        return ("numba",) if self.planner == "plain" else ()

    @cached_property
    def settings(self) -> Settings:
        """The bundled scenes, with the planner ready: compiling is nobody's turn."""
        if self.planner != "plain" and compiled.installed():
            self.show("making the planner ready", 0, 1)
            compiled.warm_up()
            self.show("making the planner ready", 1, 1)
        return make_settings()

    @cached_property
    def turns(self) -> Turns:
        """A long session, made once for all the parts that look at it."""
        before, timed = self.amounts.before, self.amounts.timed
        done = counting(self.show, "teaching", before + timed)
        allowance = Allowance(self.seconds)
        return long_session(
            self.folder, self.lessons, self.settings, (before, timed), allowance, done
        )

    @cached_property
    def questions(self) -> list[Question]:
        """What planners are asked. Raises ``CorpusError``."""
        if self.data is not None:
            return spread(list(of_corpus(self.data)), self.amounts.questions)
        return spread(list(of_lessons(self.lessons, self.settings)), self.amounts.questions)
