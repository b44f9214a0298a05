from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.toy import Toy, held, lit, on
from verbteach.verbs.analogy import Analogies
from verbteach.verbs.application import (
    ApplicationParameters,
    Situation,
    evidence,
    uniform,
)
from verbteach.verbs.examples import Example, Memory
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.learning import lifted_space
from verbteach.verbs.lifting import lift
from verbteach.verbs.pool import GoalPool, PoolParameters, PoolSource
from verbteach.verbs.resemblance import Said
from verbteach.verbs.space import Demonstration, FrameKey
from verbteach.verbs.surroundings import Surroundings
from verbteach.world.fluents import Goal, Literal, State

TOY = Toy(("b1", "b2"), ("t1", "t2"), ("l1", "l2"))
LIGHT = Said("light", ("lamp",))
OFFERED: tuple[Goal, ...] = (
    frozenset({Literal(lit("l1"))}),
    frozenset({Literal(lit("l1")), Literal(on("b1", "t2"))}),
    frozenset({Literal(on("b2", "t2"))}),
    frozenset({Literal(held("b1")), Literal(lit("l1"))}),
)


def example(name: str, verb: str, phrases: tuple[str, ...], objects: tuple[str, ...], goal: Goal
            ) -> Example:  # fmt: skip
    change, binding = lift(goal, objects, TOY.surroundings)
    return Example(Demonstration(name, verb, phrases, objects), change, binding)


def memory(goals: tuple[Goal, ...] = OFFERED) -> Memory:
    return Memory.keeping(
        example(f"d{i}", "light", ("lamp",), ("l1",), goal) for i, goal in enumerate(goals)
    )


def source(
    known: Memory, said: Said = LIGHT, joint: tuple[tuple[str, ...], ...] = (("l1",), ("l2",)),
    parameters: PoolParameters | None = None, surroundings: Surroundings = TOY.surroundings,
) -> PoolSource:  # fmt: skip
    return PoolSource(Analogies(said, joint, surroundings), known, parameters or PoolParameters())


def pool(known: Memory | None = None, state: State = frozenset()) -> GoalPool:
    return source(known or memory()).pool(state, np.array([0.5, 0.5]))


def distinct(found: GoalPool) -> dict[Goal, float]:
    return {
        found.goal(row): p
        for row, p in zip(found.truths, found.probabilities.tolist(), strict=True)
    }


def test_the_candidates_are_those_that_the_evidence_of_one_frame_gives() -> None:
    spaces = [
        lifted_space(Demonstration(f"d{i}", "light", ("lamp",), ("l1",)), (goal,), TOY.surroundings)
        for i, goal in enumerate(OFFERED)
    ]
    knowledge = VerbKnowledge.merged(spaces)
    situation = Situation(
        FrameKey("light", 1), ("lamp",), uniform((("l1", "l2"),)), frozenset(), TOY.surroundings
    )
    slow = {one.goal for one in evidence(knowledge, situation, ApplicationParameters())}
    assert set(distinct(pool(Memory.of(knowledge)))) == slow


def test_a_changed_place_takes_the_thing_away_from_where_it_is() -> None:
    state = frozenset({on("b1", "t1")})
    goals = distinct(pool(state=state))
    moved = frozenset({Literal(on("b1", "t2")), Literal(on("b1", "t1"), False)})
    assert any(moved <= goal for goal in goals)


def test_what_holds_already_is_no_change() -> None:
    state = frozenset({lit("l1"), lit("l2"), on("b2", "t2")})
    for goal in distinct(pool(state=state)):
        assert not any(literal.holds(state) for literal in goal)


def test_probabilities_sum_to_one_and_follow_the_groundings() -> None:
    found = pool()
    assert found.probabilities.sum() == pytest.approx(1.0)
    assert found.referents.sum() == pytest.approx(1.0)
    sure = found.regrounded(np.array([1.0, 0.0]))
    second = [i for i, x in enumerate(sure.literals) if x == Literal(lit("l2"))]
    assert sure.marginals[second] == pytest.approx(0.0)


@given(st.lists(st.booleans(), min_size=1, max_size=4))
def test_answers_settle_their_literals_in_every_hypothesis(truths: list[bool]) -> None:
    found = pool()
    for number, truth in enumerate(truths):
        found = found.answered(number, truth)
        assert found.marginals[number] == pytest.approx(float(truth))
    assert found.probabilities.sum() == pytest.approx(1.0)


def test_a_teacher_who_errs_is_weighed_as_bayes_has_it() -> None:
    sure = pool()
    soft = replace(sure, parameters=PoolParameters(reliability=0.8))
    before = np.where(soft.truths[:, 0], soft.parameters.fit, 1.0 - soft.parameters.fit)
    for said, right in ((True, 0.8), (False, 0.2)):
        after = soft.answered(0, said)
        heard = before * right + (1.0 - before) * (1.0 - right)
        assert after.probabilities == pytest.approx(
            sure.probabilities * heard / float(sure.probabilities @ heard)
        )
        assert after.truths[:, 0] == pytest.approx(before * right / heard)
        assert np.array_equal(after.truths[:, 1:], soft.truths[:, 1:])
    assert soft.answered(0, True).marginals[0] > soft.answered(0, False).marginals[0]


def test_a_teacher_hardly_ever_wrong_is_believed_like_one_who_never_is() -> None:
    sure, nearly = (
        pool(),
        replace(pool(), parameters=PoolParameters(reliability=1 - 1e-9, edits_from=1.0)),
    )
    for number, said in ((0, True), (2, False)):
        sure, nearly = sure.answered(number, said), nearly.answered(number, said)
        assert nearly.goals(1)[0][0] == sure.goals(1)[0][0]
        assert nearly.goals(1)[0][1] == pytest.approx(sure.goals(1)[0][1], abs=1e-5)
        assert nearly.certainty == pytest.approx(sure.certainty, abs=1e-6)


def test_an_outcome_is_as_likely_liked_as_the_hypotheses_say() -> None:
    found = pool()
    hypotheses = [
        (found.goal(r), p) for r, p in zip(found.truths, found.probabilities, strict=True)
    ]
    beside = Literal(lit("nowhere"))
    for outcome in (found.goals(1)[0][0], found.goals(1)[0][0] | {beside}, frozenset({beside})):
        expected = sum(p * len(outcome & t) / len(outcome | t) for t, p in hypotheses)
        assert (
            found.likenesses([outcome, outcome]) == [pytest.approx(float(expected), abs=1e-6)] * 2
        )


def test_what_no_action_can_bring_about_is_not_proposed_and_makes_an_example_less_likely() -> None:
    dark = replace(TOY.surroundings, made=frozenset({lit("l1"), on("b1", "t2")}), ended=frozenset())
    found = source(memory(), surroundings=dark).pool(frozenset(), np.array([0.5, 0.5]))
    assert set(found.literals) <= {Literal(lit("l1")), Literal(on("b1", "t2"))}
    assert set(found.literals) < set(pool().literals)


def test_the_best_goal_has_the_highest_expected_jaccard_index_of_all_conjunctions_offered() -> None:
    found = pool()
    hypotheses = [
        (found.goal(r), p) for r, p in zip(found.truths, found.probabilities, strict=True)
    ]

    def expected(goal: Goal) -> float:
        return float(sum(p * len(goal & t) / len(goal | t) for t, p in hypotheses))

    best, value = found.goals(1)[0]
    assert value == pytest.approx(expected(best), abs=1e-6)
    assert all(value >= expected(goal) - 1e-6 for goal, _ in hypotheses)


def test_the_gain_of_a_question_is_what_its_answers_bring_on_average() -> None:
    found = pool()
    for number in range(len(found.literals)):
        [chance] = found.yes_chances([number])
        values = [
            float(found.answered(number, truth).decision.values.max()) for truth in (True, False)
        ]
        brought = chance * values[0] + (1 - chance) * values[1] - found.decision.values.max()
        # Answers are also edited in here, and new conjunctions offered: never less than foreseen.
        assert brought >= found.literal_gains([number])[0] - 1e-4


def _without(gone: set[int], goal: set[int]) -> set[int]:
    return goal - gone


def test_gains_are_what_counting_literals_by_hand_gives() -> None:
    found = pool()
    now, trust = found.decision, found.parameters.agreement

    def best(edited: Callable[[set[int]], set[int]], weights: list[float]) -> float:
        choices = [edited(set(np.flatnonzero(row).tolist())) for row in now.choices]
        truths = [edited(set(np.flatnonzero(row).tolist())) for row in now.truths]
        return max(
            sum(w * len(c & t) / max(1, len(c | t)) for t, w in zip(truths, weights, strict=True))
            for c in choices
        )

    numbers = range(len(found.literals))
    for number, gain in zip(numbers, found.literal_gains(numbers), strict=True):
        says = [trust if row[number] else 1 - trust for row in now.truths]
        yes = [c * s for c, s in zip(now.chances, says, strict=True)]
        no = [c * (1 - s) for c, s in zip(now.chances, says, strict=True)]
        one = {number}
        after = best(partial(set.union, one), yes) + best(partial(_without, one), no)
        assert gain == pytest.approx(after - now.values.max(), abs=1e-5)


def test_telling_groundings_apart_never_loses() -> None:
    found = pool()
    assert found.grounding_gain(np.array([0, 1]), 2) >= -1e-6
    assert found.grounding_gain(np.array([0, 0]), 1) == pytest.approx(0.0, abs=1e-6)


def test_other_verbs_speak_but_less() -> None:
    known = Memory.keeping(
        (
            example("a", "light", ("lamp",), ("l1",), frozenset({Literal(lit("l1"))})),
            example("b", "grab", ("lamp",), ("l1",), frozenset({Literal(held("b1"))})),
        )
    )
    goals = distinct(source(known, joint=(("l1",),)).pool(frozenset(), np.ones(1)))
    assert goals[frozenset({Literal(lit("l1"))})] > goals[frozenset({Literal(held("b1"))})] > 0.0


def test_the_cache_of_bindings_leaves_no_trace_in_a_pool() -> None:
    analogies = Analogies(Said("light", ("lamp",)), (("l1",), ("l2",)), TOY.surroundings)
    backwards = Memory(tuple(reversed(memory().examples)))
    PoolSource(analogies, backwards, PoolParameters())
    warm = PoolSource(analogies, memory(), PoolParameters()).pool(frozenset(), np.full(2, 0.5))
    cold = pool()
    assert warm.literals == cold.literals
    assert np.array_equal(warm.truths, cold.truths)
    assert np.array_equal(warm.probabilities, cold.probabilities)


def test_nothing_known_is_an_empty_pool() -> None:
    found = pool(Memory())
    assert found.empty
    assert found.goals(3) == ()


def test_all_arities_bind_in_order() -> None:
    two = example("d", "put", ("box", "table"), ("b1", "t2"), frozenset({Literal(on("b1", "t2"))}))
    joint = tuple(product(("b2",)))
    found = distinct(
        source(Memory((two,)), Said("put", ("box",)), joint).pool(frozenset(), np.ones(1))
    )
    assert set(found) == {
        frozenset({Literal(on("b2", "t2"))}),
        frozenset({Literal(on("b1", "b2"))}),
    }
