"""What a planner answers: a plan, or a failure with its reason."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple, Protocol

from verbteach.world.fluents import Goal, State


class Action(NamedTuple):
    """A ground action in the domain's words: ``moveto Kettle_1``."""

    name: str
    args: tuple[str, ...] = ()

    def __str__(self) -> str:
        return " ".join((self.name, *self.args))

    @classmethod
    def parse(cls, text: str) -> Action:
        """Read ``moveto Kettle_1``; parentheses around it are ignored."""
        words = text.strip().removeprefix("(").removesuffix(")").split()
        if not words:
            raise ValueError("an action needs a name")
        return cls(words[0], tuple(words[1:]))


class FailureReason(Enum):
    """Why there is no plan."""

    UNREACHABLE = "unreachable"
    BOUND = "bound"
    UNKNOWN_FLUENT = "unknown_fluent"


@dataclass(frozen=True)
class Plan:
    """Actions that lead from the state asked about to the goal; possibly none."""

    actions: tuple[Action, ...]


@dataclass(frozen=True)
class PlanFailure:
    """No plan: the reason, and in ``detail`` what it concerns.

    That is a literal, a fluent, a bound, or two fluents of which each excludes the other.
    """

    reason: FailureReason
    detail: str = ""


class Planner(Protocol):
    """Answers with a plan or a failure, the same for the same question, bounded by expansions."""

    def plan(self, state: State, goal: Goal) -> Plan | PlanFailure:
        """Plan from ``state`` to a state in which every literal of ``goal`` holds."""
        ...
