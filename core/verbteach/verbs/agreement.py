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
    above = list(range(len(right) + 1))
    for row, one in enumerate(left, start=1):
        line = [row]
        for column, other in enumerate(right, start=1):
            replaced = above[column - 1] + (one != other)
            line.append(min(replaced, above[column] + 1, line[-1] + 1))
        above = line
    return above[-1]
