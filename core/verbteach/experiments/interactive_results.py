"""What comes of a run of the interactive protocol: how each command went, and the learning."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Tested:
    """How one test command went; ``questions`` counts acts by name.

    ``trace`` has (IED, SJI) after no question, one, two and so on, where asked for.
    """

    instance: str
    group: str
    ied: float
    sji: float
    right: bool
    expected: float
    certainty: float
    questions: Mapping[str, int]
    trace: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class Taught:
    """How the verbs were acquired: dialogues, goals judged right, questions by act name."""

    dialogues: int
    right: int
    questions: Mapping[str, int]


@dataclass(frozen=True)
class Checkpoint:
    """The test commands carried out with the verbs of the first ``lessons`` only."""

    lessons: int
    tested: tuple[Tested, ...]


@dataclass(frozen=True)
class Result:
    """One run: every test command, in the instances' order, and the learning before."""

    tested: tuple[Tested, ...]
    taught: Taught
    weights: Mapping[str, Mapping[str, float]]
    checkpoints: tuple[Checkpoint, ...] = ()
