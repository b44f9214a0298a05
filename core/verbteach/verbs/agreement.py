"""How much two courses of action agree."""

from __future__ import annotations

from collections.abc import Sequence

from verbteach.world.plan import Action


def agreement(one: Sequence[Action], other: Sequence[Action]) -> float:
    """1 - edit distance / length of the longer one; two empty sequences agree: 1."""
    longer = max(len(one), len(other))
    return 1.0 - edit_distance(one, other) / longer if longer else 1.0


def edit_distance(left: Sequence[Action], right: Sequence[Action]) -> int:
    """Count the insertions, deletions and replacements that turn one sequence into the other."""
    left, right = _without_common_ends(left, right)
    above = list(range(len(right) + 1))
    for row, one in enumerate(left, start=1):
        line = [row]
        for column, other in enumerate(right, start=1):
            replaced = above[column - 1] + (one != other)
            line.append(min(replaced, above[column] + 1, line[-1] + 1))
        above = line
    return above[-1]


def _without_common_ends(
    left: Sequence[Action], right: Sequence[Action]
) -> tuple[Sequence[Action], Sequence[Action]]:
    """What is left of two sequences without their common beginning and end: as far apart."""
    shorter = min(len(left), len(right))
    start = 0
    while start < shorter and left[start] == right[start]:
        start += 1
    stop = 0
    while stop < shorter - start and left[-1 - stop] == right[-1 - stop]:
        stop += 1
    return left[start : len(left) - stop], right[start : len(right) - stop]
