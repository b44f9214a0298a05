"""Does the domain do what the traces recorded? Every recorded action is run in it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise

from verbteach.world.fluents import Fluent, State
from verbteach.world.plan import Action
from verbteach.world.simulator import InapplicableError, Obstacle, Unmet, apply
from verbteach.world.task import Task
from verbteach_scenarios.tell_me_dave.documents import Document
from verbteach_scenarios.tell_me_dave.instructions import instruction
from verbteach_scenarios.tell_me_dave.rooms import ROBOT, Rooms, whole


class DifferenceKind(Enum):
    """Why a recorded transition is not reproduced.

    ``EMPTY_HANDED``: something is done with an object that is not in the hand.
    ``ELSEWHERE``: it is done far from where it must be done. ``UNMET``: some
    other condition does not hold. ``UNKNOWN``: no action of the domain has
    these words for objects with these marks. ``EFFECT``: it can be done and
    changes other things than recorded.
    """

    EMPTY_HANDED = "empty-handed"
    ELSEWHERE = "elsewhere"
    UNMET = "unmet"
    UNKNOWN = "unknown"
    EFFECT = "effect"


@dataclass(frozen=True)
class Difference:
    """A recorded transition that came out otherwise.

    ``expected`` and ``got`` list what changed, sorted: ``+(On Mug_1 Sink)``
    came to hold, ``-(Grasping Robot Mug_1)`` ceased to.
    """

    document: str
    step: int
    action: str
    expected: tuple[str, ...]
    got: tuple[str, ...]
    kind: DifferenceKind
    reason: str


def differences(document: Document, rooms: Rooms) -> Iterator[Difference]:
    """Yield a document's transitions that the domain does not reproduce, in order."""
    key = rooms.of_document[document.name]
    task, static = rooms.task(key), rooms.static(key)
    states = [whole(step.state, static) for step in document.steps]
    for number, (before, after) in enumerate(pairwise(states)):
        action = document.steps[number].action
        assert action is not None, "only a trace's last step has no action"
        got, kind, reason = _outcome(task, before, action)
        if got != after or kind is not DifferenceKind.EFFECT:
            yield Difference(
                document.name,
                number,
                instruction(action),
                _changes(before, after),
                _changes(before, got),
                kind,
                reason,
            )


def _outcome(task: Task, before: State, action: Action) -> tuple[State, DifferenceKind, str]:
    try:
        return apply(task, before, action), DifferenceKind.EFFECT, "its effects differ"
    except InapplicableError as error:
        first = error.obstacles[0]
        return before, _kind(first), _reason(first)


def _kind(obstacle: Obstacle) -> DifferenceKind:
    if not isinstance(obstacle, Unmet) or obstacle.static:
        return DifferenceKind.UNKNOWN
    fluent = obstacle.literal.fluent
    if fluent.args[:1] == (ROBOT,):
        known = {"Grasping": DifferenceKind.EMPTY_HANDED, "Near": DifferenceKind.ELSEWHERE}
        return known.get(fluent.predicate, DifferenceKind.UNMET)
    return DifferenceKind.UNMET


def _reason(obstacle: Obstacle) -> str:
    return f"needs {obstacle.literal}" if isinstance(obstacle, Unmet) else str(obstacle)


def _changes(before: State, after: State) -> tuple[str, ...]:
    def listed(sign: str, fluents: frozenset[Fluent]) -> tuple[str, ...]:
        return tuple(f"{sign}{fluent}" for fluent in sorted(fluents))

    return listed("+", after - before) + listed("-", before - after)
