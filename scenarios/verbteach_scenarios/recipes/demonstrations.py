"""A teacher's demonstration: the task's stages, planned one after the other, and the habits."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from verbteach.dialogue.setting import Setting
from verbteach.world.fluents import Fluent, Goal, Literal, State, satisfied
from verbteach.world.plan import Action, Plan
from verbteach.world.simulator import apply
from verbteach_scenarios.recipes.tasks import TeacherHabits

ROBOT, PERSON = "Robot", "Person"


class CannotShowError(ValueError):
    """This teacher finds no way to show this; another cast may do."""


@dataclass(frozen=True)
class Subject:
    """What is to be shown: stages on the way, the goal's parts in order, and what was named."""

    stages: tuple[Goal, ...]
    parts: tuple[Goal, ...]
    named: tuple[str, ...]

    @property
    def goal(self) -> Goal:
        """All parts together."""
        return frozenset(literal for part in self.parts for literal in part)


def demonstrate(setting: Setting, subject: Subject, habits: TeacherHabits) -> tuple[Action, ...]:
    """Show the subject in the scene as it is found; raise ``CannotShowError`` where no plan does.

    The goal holds at the end.
    """
    showing = _Showing(setting, setting.scene.initial)
    if habits.looks:
        showing.look(subject.named)
    for stage in subject.stages:
        showing.reach(stage)
    for wanted in _cumulative(subject, habits.order):
        showing.reach(wanted)
    if habits.puts_down:
        showing.put_down(subject.goal)
    if habits.closes:
        showing.tidy(subject.goal)
    if habits.waits:
        showing.do(Action("wait"))
    if habits.returns and not any(x.fluent.predicate == "near" for x in subject.goal):
        showing.do(Action("moveto", (PERSON,)))
    if not satisfied(subject.goal, showing.state) or not showing.actions:
        raise CannotShowError("the goal does not hold at the end")
    return tuple(showing.actions)


def _cumulative(subject: Subject, order: str) -> Iterable[Goal]:
    """Goals that lead up to the whole one: at once, or a part more each time."""
    parts = [frozenset({one}) for part in subject.parts for one in sorted(part)] if order else []
    kept: Goal = frozenset()
    for part in reversed(parts) if order == "backwards" else parts:
        kept |= part
        yield kept
    if not order:
        yield subject.goal


@dataclass
class _Showing:
    """A demonstration as it grows."""

    setting: Setting
    state: State
    actions: list[Action] = field(default_factory=list)

    def do(self, action: Action) -> None:
        if self.actions[-1:] == [action] and action.name == "moveto":
            return  # there already
        self.state = apply(self.setting.task, self.state, action)
        self.actions.append(action)

    def reach(self, goal: Goal) -> None:
        answer = self.setting.planner.plan(self.state, goal)
        if not isinstance(answer, Plan):
            raise CannotShowError(f"{answer.reason.value} {answer.detail}")
        for action in answer.actions:
            self.do(action)

    def look(self, named: Iterable[str]) -> None:
        """Go to everything that was named and can be gone to."""
        for name in named:
            if self.setting.task.action(Action("moveto", (name,))) is not None:
                self.do(Action("moveto", (name,)))

    def put_down(self, goal: Goal) -> None:
        """Put back what is still held, or at least put it down somewhere."""
        held = sorted(f for f in self.state if f.predicate == "grasping" and f.args[0] == ROBOT)
        for grasp in held:
            if Literal(grasp) not in goal:
                self._put_down(grasp.args[1], goal)

    def _put_down(self, item: str, goal: Goal) -> None:
        start = self.setting.scene.initial
        home = sorted(f for f in start if f.predicate in ("on", "in") and f.args[0] == item)
        supports = (Fluent("on", (item, place)) for place in self._supports())
        for place in (*home, *supports):
            if Literal(place, False) not in goal:
                try:
                    self.reach(goal | {Literal(place)})
                except CannotShowError:
                    continue
                return

    def _supports(self) -> list[str]:
        scene = self.setting.scene
        things = sorted(scene.objects.items())
        return [name for name, thing in things if scene.domain.is_a(thing.type, "surface")]

    def tidy(self, goal: Goal) -> None:
        """Shut and switch off what was not open or on before, as far as the goal allows."""
        new = sorted(self.state - self.setting.scene.initial)
        undone = [f for f in new if f.predicate in ("open", "is-on") and Literal(f) not in goal]
        for fluent in undone:
            if fluent in self.state:
                try:
                    self.reach(goal | {Literal(fluent, False)})
                except CannotShowError:
                    continue
