"""Judging plans for one instance: run on the true state, compared with what was demonstrated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from verbteach.experiments.gold import gold_sequence, whole_change
from verbteach.experiments.metrics import ied, sji
from verbteach.experiments.workroom import Workroom
from verbteach.verbs.change import StateChange
from verbteach.verbs.instance import Instance
from verbteach.world.fluents import Goal
from verbteach.world.plan import Action, Plan


class Score(NamedTuple):
    """IED of the plan and SJI of what it really changed; 0 and 0 where nothing was done."""

    ied: float = 0.0
    sji: float = 0.0


@dataclass(frozen=True)
class Judge:
    """Knows the gold of an instance."""

    instance: Instance
    room: Workroom
    _judged: dict[tuple[Action, ...], Score] = field(default_factory=dict, repr=False)

    @cached_property
    def gold(self) -> tuple[Action, ...]:
        """The cleaned gold sequence."""
        return gold_sequence(self.instance, self.room.task, self.room.planner)

    @cached_property
    def change(self) -> StateChange:
        """The gold change."""
        return whole_change(self.instance, self.room.task)

    @cached_property
    def _wanted(self) -> Goal:
        return self.change.literals

    def score(self, plan: Sequence[Action]) -> Score:
        """Run the plan from the true start, up to the first action that cannot be done."""
        actions = tuple(plan)
        if not actions:
            return Score()
        if actions not in self._judged:
            self._judged[actions] = Score(ied(self.gold, actions), self.sji(actions))
        return self._judged[actions]

    def sji(self, plan: Sequence[Action]) -> float:
        """The SJI alone: what the plan really changed, against the gold."""
        return sji(self.change, self.room.changed(self.instance.start, plan)) if plan else 0.0

    def most(self, goal: Goal) -> float:
        """The best SJI that bringing the goal about could come to: what is not gold counts."""
        gold, start = self._wanted, self.instance.start
        needless = sum(not literal.holds(start) for literal in goal.difference(gold))
        return len(gold) / (len(gold) + needless) if gold else 0.0

    def of_goal(self, goal: Goal) -> Score | None:
        """What planning to the goal from the true start comes to; None without a plan."""
        answer = self.room.planner.plan(self.instance.start, goal)
        if not isinstance(answer, Plan) or not answer.actions:
            return None
        return self.score(answer.actions)

    @property
    def ceiling(self) -> Score:
        """What planning to the whole gold change comes to."""
        return self.of_goal(self.change.literals) or Score()
