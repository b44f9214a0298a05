"""What the robot says only while a command is being carried out: Table 2, acts 3 to 5."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action

CORRECTED = "corrected"


@dataclass(frozen=True)
class EnvPredYnq:
    """Table 2, act 3: does the fluent hold now?"""

    fluent: Fluent
    name: ClassVar[str] = "env_pred_ynq"


@dataclass(frozen=True)
class GoalPredYnq:
    """Table 2, act 4: should the literal hold at the end?"""

    literal: Literal
    name: ClassVar[str] = "goal_pred_ynq"


@dataclass(frozen=True)
class SelectHypo:
    """Table 2, act 5: choose a goal hypothesis, plan to it and execute the plan.

    ``goal`` is grounded; ``hypothesis`` names the node of the hypothesis space
    that it came from, or is ``CORRECTED`` where the teacher has put a goal right;
    ``plan`` is what the robot will do.
    """

    goal: Goal
    hypothesis: str
    plan: tuple[Action, ...]
    name: ClassVar[str] = "select_hypo"


@dataclass(frozen=True)
class ReportExecution:
    """What became of an execution: the steps done, and what stopped it if anything did."""

    done: tuple[Action, ...]
    failed: Action | None = None
    obstacle: str = ""
    name: ClassVar[str] = "report_execution"
