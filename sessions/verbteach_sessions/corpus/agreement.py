"""How far different teachers agree on what a verb means.

For one verb frame and two people it is the Jaccard index of the literals of
the goals they had the robot keep, lifted from the objects at hand, as SJI
compares changes. One person's goals for a verb are compared with all of the other's.
"""

from __future__ import annotations

import re
from collections import defaultdict
from itertools import combinations
from statistics import fmean
from typing import Any

from verbteach_sessions.exports.dialogue import Dialogue

Goal = frozenset[str]
_LITERAL = re.compile(r"\(not \([^()]*\)\)|\([^()]*\)")


def literals(hypothesis: str) -> Goal:
    """The literals of a hypothesis as a robot's ``learned`` act words it."""
    return frozenset(_LITERAL.findall(hypothesis))


def jaccard(one: Goal, other: Goal) -> float:
    """The share of literals that both have among those that either has."""
    return len(one & other) / len(one | other) if one | other else 0.0


class Agreement:
    """Grows by one dialogue after the other; teachers without a code count by their session."""

    def __init__(self) -> None:
        self._goals: dict[str, dict[str, list[Goal]]] = defaultdict(lambda: defaultdict(list))

    def add(self, dialogue: Dialogue) -> None:
        """Take the goals that this dialogue's teacher had the robot keep."""
        for turn in dialogue.held:
            for act in turn.acts:
                if act.get("act") == "learned" and act.get("hypothesis"):
                    frame = f"{act.get('verb')}/{act.get('arity')}"
                    goal = literals(str(act["hypothesis"]))
                    self._goals[frame][dialogue.person].append(goal)

    def to_json(self) -> dict[str, Any]:
        """Mean over the frames that several people taught, and each frame's own."""
        frames = {}
        for frame in sorted(self._goals):
            people = self._goals[frame]
            if len(people) > 1:
                frames[frame] = self._of(people)
        pairs = sum(one["pairs"] for one in frames.values())
        mean = round(fmean(one["mean"] for one in frames.values()), 4) if frames else None
        return {"mean": mean, "pairs": pairs, "verbs": frames}

    @staticmethod
    def _of(people: dict[str, list[Goal]]) -> dict[str, Any]:
        shares = [
            fmean(jaccard(a, b) for a in people[one] for b in people[other])
            for one, other in combinations(sorted(people), 2)
        ]
        return {"people": len(people), "pairs": len(shares), "mean": round(fmean(shares), 4)}
