"""What the robot says while it is shown: between the paper's two phases."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import ClassVar

from verbteach.world.fluents import Literal
from verbteach.world.plan import Action


class DemonstrationReason(Enum):
    """Why the robot asks to be shown."""

    UNKNOWN_VERB = "unknown_verb"
    NO_HYPOTHESIS = "no_hypothesis"
    NO_PLAN = "no_plan"
    NOTHING_TO_DO = "nothing_to_do"
    WRONG_EXECUTION = "wrong_execution"
    TAKEN_OVER = "taken_over"
    NO_STEP = "no_step"
    NOTHING_CHANGED = "nothing_changed"
    SHOW_AGAIN = "show_again"
    NOT_SURE = "not_sure"


@dataclass(frozen=True)
class RequestDemonstration:
    """The robot asks to be shown; ``restored``: the world was put back first."""

    reason: DemonstrationReason
    restored: bool = False
    name: ClassVar[str] = "request_demonstration"


@dataclass(frozen=True)
class ObserveStep:
    """The robot saw a demonstrated action; ``change`` is the whole change so far."""

    action: Action
    change: tuple[Literal, ...]
    name: ClassVar[str] = "observe_step"


@dataclass(frozen=True)
class RefuseStep:
    """The demonstrated action cannot be done now; ``reason`` says why in words."""

    action: Action
    reason: str
    name: ClassVar[str] = "refuse_step"


@dataclass(frozen=True)
class ReviseSteps:
    """The demonstration was edited: its steps as they now are, and their whole ``change``."""

    steps: tuple[Action, ...]
    change: tuple[Literal, ...]
    name: ClassVar[str] = "revise_steps"


@dataclass(frozen=True)
class RefuseRevision:
    """The demonstration stays as it is: step number ``step`` would not be possible any more."""

    step: int
    action: Action
    reason: str
    name: ClassVar[str] = "refuse_revision"
