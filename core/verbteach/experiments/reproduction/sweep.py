"""Many tasks: rows keyed by what they hang on, so that a killed sweep goes on where it was.

How the work is spread comes in as ``mapper`` and where rows are kept as
``keep``; a row is a function of its task alone, so neither the number of
workers nor the order of work changes one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Protocol

from verbteach.experiments.reproduction.rows import Row
from verbteach.experiments.reproduction.task import Task


class Mapper(Protocol):
    """Applies a function to every task, in any number of processes, in any order.

    The tasks come in bundles that had better be carried out by the same
    process, which remembers what it saw and planned.
    """

    def __call__(
        self, function: Callable[[Task], Row], bundles: Sequence[Sequence[Task]], /
    ) -> Iterable[Row]:
        """Give the rows back as they are done."""
        ...


def in_turn(function: Callable[[Task], Row], bundles: Sequence[Sequence[Task]], /) -> Iterator[Row]:
    """The mapper of one process."""
    return (function(task) for bundle in bundles for task in bundle)


def sweep(
    tasks: Sequence[Task],
    score: Callable[[Task], Row],
    done: Iterable[Row] = (),
    keep: Callable[[Row], None] | None = None,
    mapper: Mapper = in_turn,
) -> dict[str, Row]:
    """Score what is not done yet and keep each row as it comes; all rows by key, in tasks' order.

    Tasks of one draw of the noise are a bundle: what was seen in the last draw
    is remembered where they are carried out, and so are the plans. Raises
    ``ValueError`` where the mapper gives a row back that nobody asked for.
    """
    wanted = {task.key: task for task in tasks}
    rows = {row.key: row for row in done if row.key in wanted}
    left = [task for key, task in wanted.items() if key not in rows]
    for row in mapper(score, _bundles(left)):
        if row.key not in wanted or row.key in rows:
            raise ValueError(f"the row {row.key} was not asked for, or came twice")
        rows[row.key] = row
        if keep is not None:
            keep(row)
    return {key: rows[key] for key in wanted}


def _bundles(tasks: Sequence[Task]) -> list[list[Task]]:
    """Tasks by the draw of the noise. Whole runs come first, and in a run what takes longest.

    So that at the end no process is long at work when the others have none left.
    """
    draws: dict[tuple[int, str, str], list[Task]] = {}
    for task in tasks:
        config = task.config
        draws.setdefault((config.run, config.reading, config.noise), []).append(task)
    return [draws[draw] for draw in sorted(draws, key=lambda d: (d[0], -_tests(draws[d]), d))]


def _tests(tasks: Sequence[Task]) -> int:
    """How often the test commands are gone through."""
    return sum(1 + len(task.config.checkpoints) for task in tasks)
