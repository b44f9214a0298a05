"""Parts of a corpus: train, validation and test, with no person in two of them.

Sessions that go on or branch off from one another, or hold the same words, stay
together as well: else one part would know what another asks.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from verbteach_sessions.errors import SessionError
from verbteach_sessions.exports.dialogue import Dialogue

PARTS = ("train", "validation", "test")
SHARES = (0.8, 0.1, 0.1)


class SplitError(SessionError):
    """Shares that cannot be, or a file of splits that is none; the message says why."""


class Member(NamedTuple):
    """What of a session decides which others it stays with; ``kin`` are those it comes from."""

    session: str
    participant: str | None
    kin: tuple[str, ...]
    content_hash: str


def member(dialogue: Dialogue) -> Member:
    """The member that a dialogue is."""
    kin = [dialogue.source, dialogue.parent[0] if dialogue.parent else None]
    return Member(
        dialogue.id,
        dialogue.participant,
        tuple(one for one in kin if one is not None),
        dialogue.content_hash,
    )


@dataclass(frozen=True)
class Splits:
    """Each session's part by its alias; ``groups`` had to stay together."""

    seed: int
    shares: tuple[float, float, float]
    parts: Mapping[str, str]
    groups: int

    def to_json(self) -> dict[str, Any]:
        """What the file of splits holds."""
        named = {
            part: [key for key in sorted(self.parts) if self.parts[key] == part] for part in PARTS
        }
        shares = dict(zip(PARTS, self.shares, strict=True))
        return {"seed": self.seed, "shares": shares, "groups": self.groups, **named}


def make_splits(
    members: Iterable[Member],
    rng: np.random.Generator,
    seed: int,
    shares: tuple[float, float, float] = SHARES,
) -> Splits:
    """Put whole groups into parts, in an order drawn from ``rng``.

    Each group goes to the part that lacks most of its share of the sessions, so
    the parts come as near to the shares as the groups allow. Raises :class:`SplitError`.
    """
    if min(shares) < 0 or abs(sum(shares) - 1) > 1e-9:
        raise SplitError(f"shares {shares} are not three numbers from 0 up that add up to 1")
    groups = grouped(list(members))
    total = sum(map(len, groups))
    filled: Counter[str] = Counter()
    parts: dict[str, str] = {}
    for index in rng.permutation(len(groups)):
        lacking = [share * total - filled[part] for part, share in zip(PARTS, shares, strict=True)]
        part = PARTS[int(np.argmax(lacking))]
        filled[part] += len(groups[index])
        parts.update(dict.fromkeys(groups[index], part))
    return Splits(seed, shares, parts, len(groups))


def grouped(members: Sequence[Member]) -> list[list[str]]:
    """Sessions that must stay together, each group sorted, the groups by their first."""
    links = _Links()
    for one in members:
        links.join(f"session {one.session}", f"words {one.content_hash}")
        if one.participant is not None:
            links.join(f"session {one.session}", f"person {one.participant}")
        for other in one.kin:
            links.join(f"session {one.session}", f"session {other}")
    groups: dict[str, list[str]] = {}
    for one in members:
        groups.setdefault(links.root(f"session {one.session}"), []).append(one.session)
    return sorted(sorted(group) for group in groups.values())


class _Links:
    """Which things are connected, directly or through others."""

    def __init__(self) -> None:
        self._above: dict[str, str] = {}

    def root(self, key: str) -> str:
        while (above := self._above.get(key, key)) != key:
            self._above[key] = self._above.get(above, above)
            key = above
        return key

    def join(self, first: str, second: str) -> None:
        self._above[self.root(first)] = self.root(second)


def read_splits(path: Path) -> dict[str, str]:
    """Each session's part, from a file of splits. Raises :class:`SplitError`."""
    try:
        document = json.loads(path.read_bytes())
    except OSError as error:
        raise SplitError(f"{path}: cannot be read, {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise SplitError(f"{path}: is not JSON") from error
    found: dict[str, str] = {}
    for part in PARTS:
        names = document.get(part) if isinstance(document, dict) else None
        if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
            raise SplitError(f"{path}: names no list of sessions under {part!r}")
        for name in names:
            if found.setdefault(name, part) != part:
                raise SplitError(f"{path}: puts {name} into {found[name]} and {part}")
    return found
