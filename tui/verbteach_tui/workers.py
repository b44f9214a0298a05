"""Spreading tasks over processes, here or on a cluster; which of them is busy changes no result."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import chain
from typing import Any, Generic, TypeVar

from verbteach_tui.conclusion import WrongUseError

Task = TypeVar("Task")
Row = TypeVar("Row")
_BUNDLES = 8
"""With fewer bundles for each process the last ones would be waited for too long."""
_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def one_thread() -> None:
    """Let numpy use one thread, here and in processes begun later, unless the person chose.

    The matrices are small: more threads only wait for each other, and take two
    to three times as long. It must be called before numpy is imported.
    """
    for name in _THREADS:
        os.environ.setdefault(name, "1")


@dataclass(frozen=True)
class Workers:
    """A mapper for sweeps: ``jobs`` processes here, or those of a Dask cluster."""

    jobs: int = 1
    cluster: str | None = None

    def __call__(self, function: Callable[[Task], Row], tasks: Sequence[Task], /) -> Iterable[Row]:
        """The rows as they are done, in any order."""
        if self.cluster is None and (self.jobs == 1 or len(tasks) < 2):
            return map(function, tasks)
        return self._spread(function, tasks)

    def bundled(
        self, function: Callable[[Task], Row], bundles: Sequence[Sequence[Task]], /
    ) -> Iterable[Row]:
        """The same where tasks of a bundle share what a process remembers.

        A bundle stays in one process where there are enough of them, and its
        rows come together.
        """
        if self.cluster is None and self.jobs > 1 and len(bundles) >= _BUNDLES * self.jobs:
            return chain.from_iterable(self._spread(_Bundle(function), bundles))
        return self(function, list(chain.from_iterable(bundles)))

    def _spread(self, function: Callable[[Task], Row], tasks: Sequence[Task]) -> Iterator[Row]:
        from joblib import Parallel, delayed

        with self._backend() as jobs:
            parallel = Parallel(n_jobs=jobs, return_as="generator_unordered", batch_size=1)
            yield from parallel(delayed(_kept)(function, task) for task in tasks)

    @contextmanager
    def _backend(self) -> Iterator[int]:
        from joblib import parallel_config

        if self.cluster is None:
            with parallel_config(backend="loky", inner_max_num_threads=1):
                yield self.jobs
            return
        with _client(self.cluster) as client, parallel_config(backend="dask", client=client):
            yield -1


@dataclass(frozen=True)
class _Bundle(Generic[Task, Row]):
    """Does a bundle of tasks, one after another."""

    function: Callable[[Task], Row]

    def __call__(self, tasks: Sequence[Task]) -> list[Row]:
        return [self.function(task) for task in tasks]


def _kept(function: Callable[[Task], Row], task: Task) -> Row:
    """Do a task in a process that is kept for the next.

    Where psutil is installed, loky takes a process that remembers what it has
    read and planned for one that leaks, and begins it anew. What it remembers
    is kept for good, so that nobody need look for rings of garbage in it.
    """
    from joblib.externals.loky import process_executor

    process_executor._USE_PSUTIL = False
    gc.disable()
    try:
        return function(task)
    finally:
        gc.freeze()
        gc.enable()


@contextmanager
def _client(address: str) -> Iterator[Any]:
    """A client of the cluster's scheduler."""
    try:
        import distributed
    except ImportError:
        raise WrongUseError("--cluster needs Dask: pip install 'verbteach[cluster]'") from None
    try:
        make: Any = distributed.Client  # it has no types
        client = make(address, timeout="10s", set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise WrongUseError(f"there is no Dask scheduler at {address}: {error}") from error
    with client:
        yield client
