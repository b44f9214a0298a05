"""What the robot says only while it learns from a demonstration: Table 2, acts 6 to 8.

Also what it says of verbs that it knows, which a teacher corrects.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from verbteach.world.fluents import Goal, Literal


@dataclass(frozen=True)
class BulkNpGrdYnq:
    """Table 2, act 6: are all these noun phrases these objects?"""

    pairs: tuple[tuple[str, str], ...]
    name: ClassVar[str] = "bulk_np_grd_ynq"


@dataclass(frozen=True)
class PredChangeYnq:
    """Table 2, act 7: did the demonstration make this literal true?"""

    literal: Literal
    name: ClassVar[str] = "pred_change_ynq"


@dataclass(frozen=True)
class GoalRelevantYnq:
    """Beyond Table 2 (after Table 1, R6): does this change belong to the goal?"""

    literal: Literal
    name: ClassVar[str] = "goal_relevant_ynq"


@dataclass(frozen=True)
class IncludeFluent:
    """Table 2, act 8: keep the conjunction as the verb's goal, after reading it back."""

    goal: Goal
    name: ClassVar[str] = "include_fluent"


@dataclass(frozen=True)
class ReviseGoal:
    """The goal read back was wrong; the robot asks what to strike or to keep."""

    goal: Goal
    name: ClassVar[str] = "revise_goal"


@dataclass(frozen=True)
class Learned:
    """The robot keeps the verb: frame as (verb, number of noun phrases), its lifted goal."""

    verb: str
    arity: int
    hypothesis: str
    new_nodes: int
    name: ClassVar[str] = "learned"


@dataclass(frozen=True)
class ReviseVerb:
    """What is known of a verb was corrected: ``left`` of ``before`` hypotheses are left."""

    verb: str
    literal: Literal
    wanted: bool
    before: int
    left: int
    name: ClassVar[str] = "revise_verb"
