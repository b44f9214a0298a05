"""A study as it was designed: what participants are told, asked and given, as plain values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from verbteach_sessions.lines import digest
from verbteach_sessions.study.questionnaire import Questionnaire

PANELS = ("scene", "mind", "verbs")
"""What may be shown beside the dialogue: the scene, the robot's beliefs, the verbs it knows."""

BETWEEN, WITHIN = "between", "within"
DESIGNS = (BETWEEN, WITHIN)
"""Each participant meets one condition, or all of them one after the other."""


@dataclass(frozen=True)
class Condition:
    """What is varied. ``panels`` are those that are shown, in the order of ``PANELS``.

    ``weights`` is the file that the policy begins with, as the study's file names
    it, and ``weights_hash`` its SHA-256; with ``freeze`` it learns nothing more.
    """

    id: str
    policy: str = "she16"
    noise: str = "perfect"
    noise_reading: str = "literal"
    panels: tuple[str, ...] = PANELS
    weights: str = ""
    weights_hash: str = ""
    freeze: bool = False

    def to_json(self) -> dict[str, Any]:
        """Plain JSON, as a session's header keeps it; of weights only where there are any."""
        own = {"weights": self.weights, "weights_hash": self.weights_hash, "freeze": self.freeze}
        always = {name: value for name, value in vars(self).items() if name not in own}
        said = {name: value for name, value in own.items() if value}
        return {**always, "panels": list(self.panels), **said}


@dataclass(frozen=True)
class Task:
    """Something to have the robot do: what the participant reads, and the scene it is for.

    ``part`` is the part of a within-subjects study that it belongs to, from 1;
    0 is every part.
    """

    scene: str
    text: str
    part: int = 0


@dataclass(frozen=True)
class Stop:
    """When a part is over: at whichever comes first, between two commands; ``None`` is never.

    ``lessons`` commands were given, ``minutes`` have passed, or the last
    ``mastery`` commands in a row were carried out right without being shown.
    ``questions`` is the most that the robot asks about one command.
    """

    lessons: int | None = None
    minutes: float | None = None
    mastery: int | None = None
    questions: int | None = None


@dataclass(frozen=True)
class Lessons:
    """A stretch of teaching: in which scenes, which tasks (none: what the participant likes)."""

    scenes: tuple[str, ...]
    tasks: tuple[Task, ...] = ()
    stop: Stop = field(default_factory=Stop)
    text: str = ""

    def tasks_of(self, part: int) -> tuple[Task, ...]:
        """The tasks of a part, from 1."""
        return tuple(task for task in self.tasks if task.part in (0, part))

    def first_scene(self, part: int) -> str:
        """Where the part begins."""
        tasks = self.tasks_of(part)
        return tasks[0].scene if tasks else self.scenes[0]


@dataclass(frozen=True)
class Study:
    """A whole study. ``file_hash`` is the SHA-256 of the file it was read from.

    ``attached`` are the bytes of the weights that its conditions name, by their SHA-256.
    """

    id: str
    title: str
    seed: int
    design: str
    consent: str
    instructions: str
    thanks: str
    conditions: tuple[Condition, ...]
    lessons: Lessons
    practice: Lessons | None = None
    questionnaire: Questionnaire = field(default_factory=Questionnaire)
    file_hash: str = ""
    attached: Mapping[str, bytes] = field(default_factory=dict, repr=False, compare=False)

    @property
    def consent_hash(self) -> str:
        """SHA-256 of the consent text as it is shown, in UTF-8."""
        return digest(self.consent.encode())

    @property
    def by_id(self) -> Mapping[str, Condition]:
        """The conditions by their names."""
        return {condition.id: condition for condition in self.conditions}
