"""Splits that hold out whole environments, as the published test split does."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from verbteach.verbs.instance import Instance


class Fold(NamedTuple):
    """Instances of one environment, held out, and those of all others."""

    environment: str
    train: tuple[Instance, ...]
    test: tuple[Instance, ...]


def environments(instances: Iterable[Instance]) -> tuple[str, ...]:
    """Return the environments that occur, sorted."""
    return tuple(sorted({instance.environment for instance in instances}))


def leave_one_environment_out(instances: Sequence[Instance]) -> Iterator[Fold]:
    """Yield a fold for each environment, sorted; raise ``ValueError`` where there is only one."""
    names = environments(instances)
    if len(names) < 2:
        raise ValueError(f"{len(names)} environment(s): none can be held out")
    for name in names:
        train = tuple(i for i in instances if i.environment != name)
        test = tuple(i for i in instances if i.environment == name)
        yield Fold(name, train, test)
