"""A large demonstration is learned from without planning for every part of its goal."""

from __future__ import annotations

from dataclasses import dataclass, field

from verbteach.verbs.hypothesis import (
    GoalHypothesis,
    Learner,
    LearningParameters,
    Shown,
    base_hypothesis,
    generalisations,
)
from verbteach.world.fluents import Fluent, Goal, Literal, State
from verbteach.world.necessity import steps_needed
from verbteach.world.plan import Action, Plan, PlanFailure, Planner
from verbteach.world.simulator import apply
from verbteach_scenarios.settings import make_settings

SETTING = make_settings()("kitchen-1")
STEPS = (
    *("moveto Kettle_1", "grasp Kettle_1", "moveto Burner_1", "set-on Kettle_1 Burner_1"),
    *("moveto StoveKnob_1", "turn StoveKnob_1"),
)


@dataclass
class Witness:
    """Notes what is planned for."""

    planner: Planner
    asked: list[Goal] = field(default_factory=list)

    def plan(self, state: State, goal: Goal) -> Plan | PlanFailure:
        self.asked.append(goal)
        return self.planner.plan(state, goal)


def boiled() -> Shown:
    """Boiling the water on the stove."""
    actions = tuple(Action.parse(step) for step in STEPS)
    start = end = SETTING.scene.initial
    for action in actions:
        end = apply(SETTING.task, end, action)
    return Shown(start, actions, end)


def learned(exhaustive: int | None) -> tuple[GoalHypothesis, tuple[Goal, ...], list[Goal]]:
    """The base, its generalisations, and what was planned for on the way to them."""
    witness, shown = Witness(SETTING.planner), boiled()
    parameters = LearningParameters(exhaustive=exhaustive)
    learner = Learner(witness, SETTING.surroundings, parameters, SETTING.task)
    base = base_hypothesis(shown, ("Kettle_1",), learner)
    assert isinstance(base, GoalHypothesis)
    witness.asked.clear()
    return base, generalisations(base, shown.start, learner), witness.asked


def test_a_goal_of_few_fluents_is_learned_as_ever() -> None:
    base, every, _ = learned(None)
    assert len(base.goal) >= 5
    assert learned(len(base.goal))[1] == every


def test_a_large_one_is_planned_for_no_more_often_than_it_has_fluents() -> None:
    _, every, plans = learned(None)
    base, kept, few = learned(3)
    size = len(base.goal)
    assert len(few) == size < len(plans)
    assert [goal for goal in kept if len(goal) >= size - 1] == [
        goal for goal in every if len(goal) >= size - 1
    ]


def test_what_is_kept_without_a_plan_needs_all_that_was_done() -> None:
    base, kept, _ = learned(3)
    start, whole = boiled().start, len(base.plan.actions)
    small = [goal for goal in kept if len(goal) < len(base.goal) - 1]
    assert small
    for goal in small:
        assert steps_needed(SETTING.task, start, base.plan, goal) == whole


def test_only_the_steps_that_a_goal_needs_are_counted() -> None:
    shown = boiled()
    stands = Literal(Fluent("on", ("Kettle_1", "Burner_1")))
    burns = Literal(Fluent("is-on", ("Burner_1",)))
    counts = {
        goal: steps_needed(SETTING.task, shown.start, Plan(shown.actions), goal)
        for goal in (frozenset[Literal](), frozenset({stands}), frozenset({stands, burns}))
    }
    assert list(counts.values()) == [0, 4, 6]
