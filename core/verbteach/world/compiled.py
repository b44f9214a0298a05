"""The compiled way to search, where numba is installed and its code is ready.

numba is imported, and the search compiled or loaded from the disk, only by
``warm_up``: compiling takes many seconds the first time on a machine, so a
person's turn must never be the one to ask for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from importlib.util import find_spec
from threading import Lock
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from verbteach.world.domain import Domain
from verbteach.world.relaxed import RelaxedTask, set_bits
from verbteach.world.search import Exhausted, SearchLimits, Steps
from verbteach.world.task import ConditionalEffect, GroundAction, Task

_warming = Lock()
_kernel: ModuleType | None = None


def installed() -> bool:
    """Whether the extra ``fast`` is there."""
    return find_spec("numba") is not None


def available() -> bool:
    """Whether compiled code is ready in this process, so that using it takes no waiting."""
    return _kernel is not None


def warm_up() -> bool:
    """Load or compile the search; return whether it is available now.

    Takes about a second where compiled code is on the disk and half a minute
    where it is not. Safe to call from a background thread, and again.
    """
    global _kernel  # noqa: PLW0603 - compiled code belongs to the process
    with _warming:
        if _kernel is None and installed():
            from verbteach.world import kernel  # noqa: PLC0415 - imports numba

            try:
                _search_once(kernel)
            except Exception:  # what is on the disk may be torn, or an older version's
                kernel.forget()
                _search_once(kernel)
            _kernel = kernel
    return available()


class CompiledEngine:
    """The compiled search over one task; ``warm_up`` must have been called."""

    def __init__(self, task: Task, relaxed: RelaxedTask) -> None:
        if _kernel is None:
            raise RuntimeError(
                "the compiled search is not ready: call warm_up() first"
                if installed()
                else "numba is not installed: the extra 'fast' brings it"
            )
        self._kernel = _kernel
        self._task = laid_out(_kernel, task, relaxed)
        self._words = words(task)
        self._spare: list[Any] = []
        self._start = (0, state_row(0, self._words))

    def search(self, bits: int, goal: Sequence[int], limits: SearchLimits) -> Steps | Exhausted:
        """Return the actions of a refined plan from ``bits`` to the goal, or why there is none."""
        try:
            scratch = self._spare.pop()
        except IndexError:  # the first search, or another thread is searching
            scratch = self._kernel.scratch(self._task)
        end, steps = self._kernel.search(
            self._task,
            scratch,
            self._row(bits),
            np.array(goal, dtype=np.int64),
            _numbers_of(limits),
        )
        self._spare.append(scratch)
        if end == self._kernel.SOLVED:
            return tuple(steps.tolist())
        return Exhausted(bound=bool(end == self._kernel.BOUND))

    def _row(self, bits: int) -> npt.NDArray[np.uint64]:
        """The state as a row; the last one's is kept, since many goals are tried from a state."""
        start = self._start  # held here: another thread may be searching from another state
        if start[0] != bits:
            start = self._start = (bits, state_row(bits, self._words))
        return start[1]


@lru_cache(maxsize=16)
def _numbers_of(limits: SearchLimits) -> npt.NDArray[np.int64]:
    return np.array((limits.expansions, limits.boost), dtype=np.int64)


def words(task: Task) -> int:
    """How many words a state's row has."""
    return len(task.fluents) // 64 + 1


def state_row(bits: int, size: int) -> npt.NDArray[np.uint64]:
    """A state as a row of that many words."""
    row = np.frombuffer(bits.to_bytes(8 * size, "little"), dtype="<u8")
    return row.astype(np.uint64)  # a copy: compiled code is for arrays that can be written


def _search_once(kernel: ModuleType) -> None:
    """Make the compiler do its work, on arrays of the very types that are used later."""
    task = Task(Domain("nothing", {}, {}, {}, {}), {}, frozenset())
    array = laid_out(kernel, task, RelaxedTask(task))
    scratch = kernel.scratch(array)
    kernel.search(
        array, scratch, np.zeros(1, np.uint64), np.zeros(0, np.int64), np.ones(2, np.int64)
    )


def laid_out(kernel: ModuleType, task: Task, relaxed: RelaxedTask) -> npt.NDArray[np.int64]:
    """Lay the task and its relaxation out as ``kernel`` wants them."""
    size = relaxed.size
    effects = [_effects(action) for action in task.actions]
    listed = [effect for some in effects for effect in some]
    numbers = iter(range(len(listed)))
    links = sum(map(len, relaxed.needs)) + sum(map(len, relaxed.makes))
    array: npt.NDArray[np.int64] = kernel.task_array(
        (size, len(relaxed.actor), len(task.actions), links),
        (
            relaxed.needs,
            [[actor] for actor in relaxed.actor],
            relaxed.achievers,
            [_numbers(size, a.needs_true, a.needs_false) for a in task.actions],
            [[next(numbers) for _ in some] for some in effects],
            [_numbers(size, e.needs_true, e.needs_false) for e in listed],
            [set_bits(effect.add) for effect in listed],
            [set_bits(effect.delete) for effect in listed],
            _needed_by(relaxed),
        ),
    )
    return array


def _needed_by(relaxed: RelaxedTask) -> list[list[int]]:
    """The operators that need each proposition."""
    found: list[list[int]] = [[] for _ in range(2 * relaxed.size)]
    for operator, needs in enumerate(relaxed.needs):
        for proposition in needs:
            found[proposition].append(operator)
    return found


def _effects(action: GroundAction) -> list[ConditionalEffect]:
    return [ConditionalEffect(0, 0, action.add, action.delete), *action.conditional]


def _numbers(size: int, true: int, false: int) -> list[int]:
    return [*set_bits(true), *(size + i for i in set_bits(false))]
