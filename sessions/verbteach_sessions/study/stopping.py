"""When a stretch of teaching is over: a function of what has happened in its session alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from verbteach.dialogue.moves import Phase
from verbteach_sessions.history import Node
from verbteach_sessions.study.design import Lessons, Task

TASKS, LESSONS, MINUTES, MASTERY = "tasks", "lessons", "minutes", "mastery"
STOPPED = "stopped"
"""Why a stretch ended; ``STOPPED``: the participant wanted no more."""


@dataclass(frozen=True)
class Standing:
    """How far a session is.

    ``right``: for each sentence whose commands are over, whether all of them were
    carried out and judged right. ``seconds`` of session time. ``between``: no command
    is under way.
    """

    right: tuple[bool, ...]
    seconds: float
    between: bool

    @classmethod
    def of(cls, turns: Sequence[Node], seconds: float) -> Standing:
        """The standing after the turns that hold, the last one now on the screen."""
        right: list[bool] = []
        ended = well = 0
        for before, now in pairwise(turns):
            ended += _more(before, now, "episodes")
            well += _more(before, now, "successes")
            # Of several commands in a sentence the next one follows at once: they are one task.
            if ended and now.phase == Phase.COMMAND.value:
                right.append(well == ended)
                ended = well = 0
        phase = turns[-1].phase if turns else Phase.COMMAND.value
        return cls(tuple(right), seconds, phase == Phase.COMMAND.value)


def _more(before: Node, now: Node, count: str) -> int:
    return int(now.after["totals"][count] - before.after["totals"][count])


def ended_by(lessons: Lessons, part: int, now: Standing) -> str:
    """Why the stretch is over, or nothing while it goes on. A command is never cut short."""
    stop, given = lessons.stop, len(now.right)
    tasks = lessons.tasks_of(part)
    if not now.between:
        return ""
    if tasks and given >= len(tasks):
        return TASKS
    if stop.lessons is not None and given >= stop.lessons:
        return LESSONS
    if stop.mastery is not None and given >= stop.mastery and all(now.right[-stop.mastery :]):
        return MASTERY
    if stop.minutes is not None and now.seconds >= stop.minutes * 60:
        return MINUTES
    return ""


def task_now(lessons: Lessons, part: int, now: Standing) -> Task | None:
    """The task that the participant is at; ``None`` where the choice is free or all are done."""
    tasks = lessons.tasks_of(part)
    return tasks[len(now.right)] if len(now.right) < len(tasks) else None
