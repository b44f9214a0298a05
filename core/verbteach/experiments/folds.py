"""Which instances are learned from and which are tested: whole environments are held out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256

from verbteach.verbs.instance import Instance


@dataclass(frozen=True)
class Fold:
    """Instances to learn from and instances to test on, with a name for the test part."""

    name: str
    train: tuple[Instance, ...]
    test: tuple[Instance, ...]


def leave_one_environment_out(instances: Sequence[Instance]) -> tuple[Fold, ...]:
    """A fold for each environment, sorted. Raises ``ValueError`` where there is only one."""
    names = sorted({instance.environment for instance in instances})
    if len(names) < 2:
        raise ValueError("whole environments are held out, and there is only one")
    return tuple(
        Fold(
            name,
            tuple(i for i in instances if i.environment != name),
            tuple(i for i in instances if i.environment == name),
        )
        for name in names
    )


def held_out(train: Sequence[Instance], test: Sequence[Instance]) -> tuple[Fold, ...]:
    """One fold: learn from these, test on those."""
    if not train or not test:
        raise ValueError("there must be instances to learn from and instances to test on")
    return (Fold("test", tuple(train), tuple(test)),)


def is_development(instance: Instance, share: int = 5) -> bool:
    """Whether the instance's document is in the development part, one in ``share``."""
    digest = sha256(instance.group.encode()).digest()
    return int.from_bytes(digest[:8], "big") % share == 0
