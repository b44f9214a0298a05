"""Laboratories for reproductions, opened from what names them, once in every process."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from hashlib import sha256
from pathlib import Path

import verbteach
from verbteach.experiments.reproduction.laboratory import Laboratory, fingerprint
from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.reproduction.task import Task
from verbteach_scenarios.benches import bench_grounded
from verbteach_scenarios.grounds import EvaluationData, of_corpus, of_lessons
from verbteach_scenarios.lessons import load_lessons
from verbteach_scenarios.settings import make_settings

LESSONS = "bundled lessons"


@dataclass(frozen=True)
class LaboratorySource:
    """What a laboratory is made from; small, so that it can travel to other processes.

    Without ``data`` the bundled lessons. ``grounding`` is ``corpus``, ``oracle`` or ``own``.
    """

    data: Path | None = None
    test_data: Path | None = None
    grounding: str = "corpus"

    def about(self) -> dict[str, str]:
        """What rows hang on besides their configuration; opens the laboratory."""
        instances = laboratory(self).bench.instances
        return {
            "grounding": self.grounding,
            "data": fingerprint(instances),
            "program": _program(),
        }


@lru_cache(maxsize=1)
def laboratory(source: LaboratorySource) -> Laboratory:
    """Open a laboratory.

    Raises ``CorpusError`` or ``WorldFileError`` where a folder does not fit.
    """
    data = evaluation_data(source)
    bench = bench_grounded(data, source.grounding)
    return Laboratory(bench, data.grounds, source.grounding, bench.grounder, data.apart)


@lru_cache(maxsize=1)
def evaluation_data(source: LaboratorySource) -> EvaluationData:
    """Read what a laboratory is made from. Raises as ``laboratory`` does."""
    if source.data is None:
        return of_lessons(load_lessons(), make_settings())
    return of_corpus(source.data, source.test_data)


@dataclass(frozen=True)
class Scorer:
    """Carries tasks out in the laboratory of its source, in whatever process it is in."""

    source: LaboratorySource
    clock: Callable[[], float] = time.process_time

    def __call__(self, task: Task) -> Row:
        """The task's row, with the processor time it took."""
        where = laboratory(self.source)
        began = self.clock()
        row = where.row(task)
        return replace(row, seconds=self.clock() - began)


@lru_cache(maxsize=1)
def _program() -> str:
    """A short hash of the learner's source: rows of another one are not the same rows."""
    root = Path(verbteach.__file__).parent
    made = sha256()
    for path in sorted(root.rglob("*.py"), key=lambda p: p.relative_to(root).as_posix()):
        made.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes())
    return made.hexdigest()[:16]
