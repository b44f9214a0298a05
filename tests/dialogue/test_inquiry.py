"""Both phases as decision processes, on the corpus-free toy of the verb tests."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from tests.verbs.toy import Toy, held, lit, on
from verbteach.dialogue import execution_inquiry, learning_inquiry
from verbteach.dialogue.acts import (
    BulkNpGrdYnq,
    EnvPredYnq,
    GoalPredYnq,
    GoalRelevantYnq,
    IncludeFluent,
    NpGrdWhq,
    NpGrdYnq,
    PredChangeYnq,
    RequestDemonstration,
    SelectHypo,
)
from verbteach.dialogue.execution_inquiry import ExecutionInquiry
from verbteach.dialogue.grounding import GroundingBelief
from verbteach.dialogue.inquiry import InquiryParameters, Label, Reply
from verbteach.dialogue.learning_inquiry import LearningInquiry, shown_grounding
from verbteach.perception.belief import Belief
from verbteach.verbs.analogy import Analogies
from verbteach.verbs.examples import Example, Memory
from verbteach.verbs.lifting import lift
from verbteach.verbs.pool import PoolParameters, PoolSource
from verbteach.verbs.resemblance import Said
from verbteach.verbs.seen_change import SeenChange
from verbteach.verbs.space import Demonstration
from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action

TOY = Toy(("b1", "b2"), ("t1", "t2"), ("l1",))
YES, NO, UNSURE = Reply(Label.YES), Reply(Label.NO), Reply(Label.UNSURE)


def example(name: str, goal: Goal) -> Example:
    change, binding = lift(goal, ("b1", "t2"), TOY.surroundings)
    return Example(Demonstration(name, "put", ("box", "table"), ("b1", "t2")), change, binding)


KNOWN = Memory.keeping(
    (
        example("a", frozenset({Literal(on("b1", "t2"))})),
        example("b", frozenset({Literal(on("b1", "t2")), Literal(lit("l1"))})),
        example("c", frozenset({Literal(held("b1"))})),
    )
)


def command(
    belief: Belief | None = None,
    known: Memory = KNOWN,
    parameters: InquiryParameters | None = None,
    relied: frozenset[Fluent] | None = frozenset(),
) -> ExecutionInquiry:
    objects = (("b1", "b2"), ("t1", "t2"))
    joint = tuple(product(*objects))
    source = PoolSource(
        Analogies(Said("put", ("box", "table")), joint, TOY.surroundings), known, PoolParameters()
    )
    grounding = GroundingBelief.of({"box": {"b1": 1.0, "b2": 1.0}, "table": {"t1": 1.0, "t2": 1.0}})
    belief = belief or Belief.certain(frozenset({on("b1", "t1"), on("b2", "t1")}))
    return ExecutionInquiry.begin(
        source, frozenset(), belief, grounding, parameters, lambda state, goal: relied
    )


def acts(state: ExecutionInquiry | LearningInquiry) -> list[object]:
    return [one.act for one in state.candidates()]


def test_every_feature_used_is_documented_and_none_is_missing() -> None:
    doubtful = Belief.of({on("b1", "t1"): 0.6, on("b2", "t1"): 0.4})
    for state, table in ((command(doubtful), execution_inquiry.FEATURES),
                         (demonstration(), learning_inquiry.FEATURES)):  # fmt: skip
        used = {name for one in state.candidates() for name in one.features}
        assert used <= set(table)


def test_a_grounding_answer_changes_goals_at_once() -> None:
    state = command()
    second = state.after(NpGrdYnq("box", "b1"), NO)
    chances = zip(second.pool.literals, second.pool.marginals.tolist(), strict=True)
    wanted = [literal for literal, chance in chances if chance > 0]
    assert not any("b1" in literal.fluent.args for literal in wanted if literal.positive)
    assert second.grounding.best("box") == "b2"
    assert not any(isinstance(act, NpGrdYnq) and act.np == "box" for act in acts(second))


def test_answers_that_may_be_wrong_settle_nothing() -> None:
    """Four fifths sure: a no to one of two equal boxes leaves it one chance in five."""
    state = command(parameters=InquiryParameters(trust=0.8))
    before = dict(state.prior["box"])
    after = state.after(NpGrdYnq("box", "b1"), NO)
    assert before["b1"] == before["b2"]
    assert dict(after.prior["box"])["b1"] == pytest.approx(0.2)
    assert not after.prior.settled
    shown = demonstration(InquiryParameters(trust=0.8))
    question = PredChangeYnq(Literal(lit("l1")))
    chance = shown.after(question, YES).change.table[question.literal]
    assert chance == pytest.approx(0.3 * 0.8 / (0.3 * 0.8 + 0.7 * 0.2))
    (bulk,) = [act for act in acts(shown) if isinstance(act, BulkNpGrdYnq)]
    assert not shown.after(bulk, YES).grounding.settled


def test_experience_moves_the_grounding_belief() -> None:
    """Boxes were put on t2 before, so t2 is likelier to be meant than t1."""
    assert dict(command().grounding["table"])["t2"] > 0.5


def test_a_wh_question_may_be_answered_with_several_objects() -> None:
    state = command().after(NpGrdWhq("box"), Reply(Label.OBJECTS, ("b1", "b2")))
    assert len(state.grounding["box"]) == 2
    assert not any(isinstance(act, NpGrdWhq | NpGrdYnq) and act.np == "box" for act in acts(state))


def test_a_goal_answer_is_kept_through_one_about_the_environment() -> None:
    doubtful = Belief.of({on("b1", "t1"): 0.6, on("b2", "t1"): 0.4})
    state = command(doubtful)
    literal = Literal(lit("l1"))
    state = state.after(GoalPredYnq(literal), YES)
    state = state.after(EnvPredYnq(on("b2", "t1")), YES)
    assert on("b2", "t1") in state.believed
    assert state.pool.marginals[state.pool.literals.index(literal)] == pytest.approx(1.0)
    assert literal in state.best


def test_doubtful_fluents_that_the_plan_needs_are_asked_about_whether_seen_or_not() -> None:
    doubtful = Belief.of({on("b1", "t1"): 0.6, on("b2", "t1"): 0.4, on("b1", "t2"): 0.5})
    both = frozenset({on("b1", "t1"), on("b2", "t1")})
    parameters = InquiryParameters(environment_questions=3)
    state = command(doubtful, parameters=parameters, relied=both)
    asked = {act.fluent for act in acts(state) if isinstance(act, EnvPredYnq)}
    assert asked == both
    assert not any(isinstance(act, EnvPredYnq) for act in acts(command(doubtful)))
    unplanned = acts(command(doubtful, parameters=parameters, relied=None))
    assert {act.fluent for act in unplanned if isinstance(act, EnvPredYnq)} >= both
    assert not any(isinstance(act, EnvPredYnq) for act in acts(command()))


def test_no_question_is_put_twice_and_the_cap_ends_them() -> None:
    state = command(parameters=InquiryParameters(cap=4))
    seen = []
    while len(acts(state)) > 1:
        act = state.candidates()[0].act
        seen.append(act)
        state = state.after(act, UNSURE)
    assert len(seen) == len(set(seen)) <= 4
    assert isinstance(state.candidates()[-1].act, SelectHypo)


def test_where_nothing_is_known_the_robot_asks_to_be_shown() -> None:
    assert isinstance(acts(command(known=Memory()))[0], RequestDemonstration)


CHANGE = SeenChange(
    (
        (Literal(on("b1", "t2")), 0.9),
        (Literal(on("b1", "t1"), False), 0.55),
        (Literal(lit("l1")), 0.3),
    )
)


def demonstration(parameters: InquiryParameters | None = None) -> LearningInquiry:
    grounding = shown_grounding(
        ("box", "table"),
        (("b2", "b1"), ("t1", "t2")),
        CHANGE.likely,
        (Action("grasp", ("b1",)), Action("put", ("b1", "t2"))),
    )
    return LearningInquiry(CHANGE, grounding, parameters or InquiryParameters())


def test_what_changed_is_likelier_to_be_meant() -> None:
    assert demonstration().objects == ("b1", "t1")  # t1 and t2 both changed: the first fits


def test_the_most_doubtful_change_is_asked_about_first_and_answers_settle_it() -> None:
    state = demonstration()
    questions = [act for act in acts(state) if isinstance(act, PredChangeYnq)]
    assert questions[0] == PredChangeYnq(Literal(on("b1", "t1"), False))
    assert questions[0].literal not in state.after(questions[0], NO).goal
    assert Literal(lit("l1")) in state.after(PredChangeYnq(Literal(lit("l1"))), YES).goal


def test_a_bulk_yes_settles_all_phrases_and_a_no_doubts_them() -> None:
    state = demonstration()
    (bulk,) = [act for act in acts(state) if isinstance(act, BulkNpGrdYnq)]
    assert state.after(bulk, YES).grounding.settled == {"box", "table"}
    denied = state.after(bulk, NO)
    assert dict(denied.grounding["box"])["b1"] < dict(state.grounding["box"])["b1"]


def test_relevance_is_asked_only_where_it_is_switched_on() -> None:
    assert not any(isinstance(act, GoalRelevantYnq) for act in acts(demonstration()))
    state = demonstration(InquiryParameters(goal_relevance=True))
    question = GoalRelevantYnq(Literal(on("b1", "t2")))
    assert question in acts(state)
    assert question.literal not in state.after(question, NO).goal


def test_nothing_seen_to_change_cannot_be_included() -> None:
    empty = LearningInquiry(SeenChange(()), GroundingBelief.of({}))
    assert isinstance(empty.candidates()[-1].act, RequestDemonstration)
    assert isinstance(demonstration().candidates()[-1].act, IncludeFluent)


def test_gains_are_offered_with_the_questions() -> None:
    gains = [one.features["ask.gain"] for one in command().candidates()
             if isinstance(one.act, GoalPredYnq)]  # fmt: skip
    assert gains
    assert np.all(np.array(gains) > -1e-6)
