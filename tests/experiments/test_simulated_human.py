from __future__ import annotations

import numpy as np
import pytest

from tests.experiments.interactive_room import bench
from verbteach.dialogue.acts import (
    BulkNpGrdYnq,
    EnvPredYnq,
    GoalPredYnq,
    NpGrdWhq,
    NpGrdYnq,
    PredChangeYnq,
)
from verbteach.dialogue.inquiry import Label
from verbteach.experiments.simulated_human import (
    AnswerRates,
    HumanParameters,
    People,
    Person,
    SimulatedHuman,
)
from verbteach.world.plan import Plan

BENCH = bench()
RNG = np.random.default_rng(0)


def humans(parameters: HumanParameters | None = None) -> list[SimulatedHuman]:
    return [
        SimulatedHuman(one, BENCH.room(one), parameters or HumanParameters())
        for one in BENCH.instances
    ]


def test_a_grounding_is_right_if_the_demonstration_changed_the_object() -> None:
    for human in humans():
        (gold,) = human.instance.narrowed
        assert human.reply(NpGrdWhq("cup"), 0, RNG).objects == gold
        for thing in ("Cup_1", "Cup_2"):
            assert human.truth(NpGrdYnq("cup", thing)) == (thing in gold)
            assert human.truth(BulkNpGrdYnq((("cup", thing),))) == (thing in gold)


def test_the_environment_is_the_true_start_and_the_goal_the_true_change() -> None:
    for human in humans():
        for fluent in sorted(human.instance.start):
            assert human.truth(EnvPredYnq(fluent))
        for literal in sorted(human.change.literals):
            assert human.truth(GoalPredYnq(literal))
            assert human.truth(PredChangeYnq(literal))
            assert not human.truth(GoalPredYnq(literal._replace(positive=not literal.positive)))


def test_the_demonstration_itself_is_right_and_doing_nothing_is_not() -> None:
    for human in humans():
        assert human.right(human.instance.actions)
        assert not human.right(())
        goal = human.change.literals
        answer = human.room.planner.plan(human.instance.start, goal)
        assert isinstance(answer, Plan)
        assert human.right_goal(goal) == human.right(answer.actions)


def test_errors_are_as_frequent_as_they_are_set() -> None:
    human = humans(HumanParameters(error=0.2))[0]
    question = GoalPredYnq(min(human.change.literals))
    rng = np.random.default_rng(1)
    answers = [human.reply(question, 0, rng).label for _ in range(3000)]
    assert np.mean([a is Label.NO for a in answers]) == pytest.approx(0.2, abs=0.03)


def test_patience_ends_and_some_answers_are_not_known() -> None:
    question = NpGrdYnq("cup", "Cup_1")
    patient = humans(HumanParameters(patience=2))[0]
    labels = [patient.reply(question, asked, RNG).label for asked in range(4)]
    assert [label is Label.UNSURE for label in labels] == [False, False, True, True]
    unsure = humans(HumanParameters(unsure=1.0))[0]
    assert unsure.reply(question, 0, RNG).label is Label.UNSURE


def test_people_have_rates_by_question_and_each_teaches_their_own_instances() -> None:
    wrong = Person(by_question={"np_grd_ynq": AnswerRates(error=1.0)})
    silent = Person(unsure=1.0)
    people = People(people=(wrong, silent))
    teachers = {one.id: people.teaching(one.id) for one in BENCH.instances}
    assert {id(one) for one in teachers.values()} == {id(wrong), id(silent)}
    assert teachers == {one.id: people.teaching(one.id) for one in BENCH.instances}
    (human, *_) = humans(wrong)
    (gold,) = human.instance.narrowed
    assert human.reply(NpGrdYnq("cup", gold[0]), 0, RNG).label is Label.NO
    fluent = sorted(human.instance.start)[0]
    assert human.reply(EnvPredYnq(fluent), 0, RNG).label is Label.YES  # no rate of its own
    assert humans(silent)[0].reply(EnvPredYnq(fluent), 0, RNG).label is Label.UNSURE
