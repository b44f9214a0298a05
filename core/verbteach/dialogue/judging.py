"""Judging by a lesson's goal: was an execution right, does a goal read back mean the same?

Right means that the goal holds afterwards and that nothing changed beyond the
goal, the demonstrated change and what a plan to the goal changes itself, so
that leaving out a demonstrator's needless step is never wrong.
"""

from __future__ import annotations

from dataclasses import dataclass

from verbteach.dialogue.lesson import Lesson
from verbteach.dialogue.setting import Setting
from verbteach.verbs.change import StateChange
from verbteach.world.fluents import Goal, State, satisfied
from verbteach.world.plan import Plan
from verbteach.world.simulator import run


@dataclass(frozen=True)
class Judge:
    """Judges for one lesson in one setting.

    ``incidental`` predicates never make an execution wrong: where the robot
    stands is no part of what a command asks for unless its goal says so.
    """

    lesson: Lesson
    setting: Setting
    incidental: frozenset[str] = frozenset({"near"})

    def execution(self, start: State, end: State) -> bool:
        """Whether going from ``start`` to ``end`` is what the lesson's command meant."""
        if not satisfied(self.lesson.goal, end):
            return False
        beyond = self._change(start, end) - self._allowed(start)
        return all(literal.fluent.predicate in self.incidental for literal in beyond)

    def goal(self, start: State, goal: Goal) -> bool:
        """Whether planning to ``goal`` from ``start`` does what the lesson's command meant."""
        answer = self.setting.planner.plan(start, goal)
        if not isinstance(answer, Plan):
            return False
        return self.execution(start, run(self.setting.task, start, answer.actions)[-1])

    def _allowed(self, start: State) -> Goal:
        shown = run(self.setting.task, start, self.lesson.demonstration)[-1]
        allowed = self.lesson.goal | self._change(start, shown)
        answer = self.setting.planner.plan(start, self.lesson.goal)
        if isinstance(answer, Plan):
            planned = run(self.setting.task, start, answer.actions)[-1]
            allowed |= self._change(start, planned)
        return allowed

    def _change(self, start: State, end: State) -> Goal:
        return StateChange.between(start, end, self.setting.scene.domain.static).literals
