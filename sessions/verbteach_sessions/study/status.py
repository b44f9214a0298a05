"""Who of a study's participants is where, and how evenly the conditions have come about."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from verbteach_sessions.errors import SessionError
from verbteach_sessions.lock import in_use
from verbteach_sessions.study.counterbalance import orders
from verbteach_sessions.study.design import Study
from verbteach_sessions.study.enrolment import visits
from verbteach_sessions.study.progress import Progress
from verbteach_sessions.study.steps import steps_of
from verbteach_sessions.study.stopping import STOPPED


@dataclass(frozen=True)
class Row:
    """One participant. ``at`` is the step they are at; ``problem`` is why nothing is known."""

    participant: str
    slot: int | None = None
    order: tuple[str, ...] = ()
    at: str = ""
    done: int = 0
    steps: int = 0
    sessions: tuple[str, ...] = ()
    finished: bool = False
    stopped: bool = False
    here: bool = False
    seen: str = ""
    changed: bool = False
    problem: str = ""

    def to_json(self) -> dict[str, Any]:
        """The fields."""
        return {**vars(self), "order": list(self.order), "sessions": list(self.sessions)}


@dataclass(frozen=True)
class Balance:
    """One order of the conditions: how many were given it, and how many have finished."""

    order: tuple[str, ...]
    given: int
    finished: int

    def to_json(self) -> dict[str, Any]:
        """The fields."""
        return {**vars(self), "order": list(self.order)}


@dataclass(frozen=True)
class Status:
    """Everybody, in the order of their places."""

    rows: tuple[Row, ...]
    balance: tuple[Balance, ...] = field(default=())

    def to_json(self) -> dict[str, Any]:
        """What ``study status --json`` prints of it."""
        return {
            "participants": [row.to_json() for row in self.rows],
            "balance": [one.to_json() for one in self.balance],
            "enrolled": len(self.rows),
            "finished": sum(row.finished for row in self.rows),
        }


def status_of(study: Study, folder: Path) -> Status:
    """The participants in ``folder``; those of another study are rows with a problem."""
    rows = [_row(study, home, found) for home, found in visits(folder)]
    rows.sort(key=lambda row: (row.slot is None, row.slot or 0, row.participant))
    return Status(tuple(rows), _balance(study, rows))


def _row(study: Study, home: Path, found: Progress | SessionError) -> Row:
    if isinstance(found, SessionError):
        return Row(home.name, problem=str(found))
    if found.enrolled["study"] != study.id:
        return Row(home.name, problem=f"is of the study {found.enrolled['study']!r}")
    if found.order not in orders(study):
        return Row(home.name, found.slot, found.order, problem="began when the design was another")
    steps = steps_of(study, found.order)
    number = min(found.step, len(steps) - 1)
    step = steps[number]
    return Row(
        participant=found.code,
        slot=found.slot,
        order=found.order,
        at=" ".join(word for word in (step.kind.value, step.condition) if word),
        done=number,
        steps=len(steps),
        sessions=tuple(found.sessions[one] for one in sorted(found.sessions)),
        finished=bool(found.completion),
        stopped=STOPPED in found.done.values(),
        here=in_use(home),
        seen=found.seen,
        changed=_has_changed(study, found),
    )


def _has_changed(study: Study, found: Progress) -> bool:
    """Whether the study's file, or one of weights, is another than when they began."""
    weights = {one.id: one.weights_hash for one in study.conditions if one.weights_hash}
    begun = dict(found.enrolled.get("weights", ()))
    return bool(found.enrolled["study_hash"] != study.file_hash or begun != weights)


def _balance(study: Study, rows: Sequence[Row]) -> tuple[Balance, ...]:
    given = Counter(row.order for row in rows)
    finished = Counter(row.order for row in rows if row.finished)
    known = list(dict.fromkeys([*orders(study), *(row.order for row in rows if row.order)]))
    return tuple(Balance(order, given[order], finished[order]) for order in known)
