"""A demonstration's change, base hypothesis and pruned generalisations."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.verbs.strategies import FEW, PLANNER, TOY, Taught, learner, spaces, taught, walks
from tests.verbs.toy import NaivePlanner, Toy, held, lit, on
from verbteach.verbs.change import ObjectSet, StateChange, Touch, restrict, things_of
from verbteach.verbs.hypothesis import (
    GoalHypothesis,
    Learner,
    LearningParameters,
    NoHypothesis,
    NoHypothesisReason,
    Shown,
    base_hypothesis,
    generalisations,
)
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.learning import derive, ground_goals, insisted, learn, struck
from verbteach.verbs.space import Demonstration, HypothesisSpace
from verbteach.world.fluents import Fluent, Goal, Literal, satisfied
from verbteach.world.plan import Action, Plan

START = TOY.start
PUT = (Action("grasp", ("Box_1",)), Action("put", ("Box_1", "Table_2")))
SHOWN = Shown(START, PUT, TOY.run(START, PUT))
WHO = Demonstration("one", "move", ("the box",), ("Box_1",))


def space_of(shown: Shown, parameters: LearningParameters | None = None) -> HypothesisSpace:
    space = derive(WHO, shown, learner(parameters))
    assert isinstance(space, HypothesisSpace)
    return space


def test_change_has_what_came_and_what_went_without_static_predicates() -> None:
    heavy = Fluent("heavy", ("Box_1",))
    change = StateChange.between(START, SHOWN.end | {heavy}, TOY.surroundings.static)
    assert change.added == {on("Box_1", "Table_2")}
    assert change.removed == {on("Box_1", "Table_1")}
    assert len(change) == 2
    assert satisfied(change.literals, SHOWN.end)


@given(walks())
def test_the_change_turns_the_start_into_the_end(actions: tuple[Action, ...]) -> None:
    end = TOY.run(START, actions)
    change = StateChange.between(START, end)
    assert (START - change.removed) | change.added == end


def test_object_sets_choose_the_things_a_goal_may_speak_about() -> None:
    actions = (*PUT, Action("switch", ("Lamp_1",)))
    end = TOY.run(START, actions) | {on("Box_2", "Table_2")}
    chosen = {
        kind: things_of(kind, ("Box_1",), actions, end, TOY.surroundings) for kind in ObjectSet
    }
    assert chosen[ObjectSet.ARGUMENT_ONLY] == {"Box_1"}
    assert chosen[ObjectSet.ARGUMENT_RELATED] == {"Box_1", "Table_2"}
    assert chosen[ObjectSet.MANIPULATED] == {"Box_1", "Table_2", "Lamp_1"}
    assert chosen[ObjectSet.ALL] == set(TOY.surroundings.affordances)


def test_restriction_asks_for_any_or_every_thing_and_ignores_constants() -> None:
    goal = frozenset({Literal(on("Box_1", "Table_2")), Literal(held("Box_1"), False)})
    box = frozenset({"Box_1"})
    assert restrict(goal, box, TOY.surroundings, Touch.ANY) == goal
    assert restrict(goal, box, TOY.surroundings, Touch.EVERY) == {Literal(held("Box_1"), False)}
    assert not restrict(goal, frozenset({"Lamp_1"}), TOY.surroundings, Touch.ANY)


def test_reasons_for_no_hypothesis() -> None:
    idle = base_hypothesis(Shown(START, (), START), ("Box_1",), learner())
    assert idle == NoHypothesis(NoHypothesisReason.NOTHING_CHANGED)
    few = learner(LearningParameters(too_many=2))
    many = base_hypothesis(SHOWN, ("Box_1",), few)
    assert isinstance(many, NoHypothesis)
    assert many.reason is NoHypothesisReason.TOO_MANY_CHANGED
    impossible = Shown(START, PUT, START | {held("Box_1"), held("Box_2")})
    failed = base_hypothesis(impossible, ("Box_1",), learner())
    assert isinstance(failed, NoHypothesis)
    assert failed.reason is NoHypothesisReason.NO_PLAN


def kept_by_brute_force(base: GoalHypothesis) -> set[Goal]:
    """A subset stays if it and everything between it and the base has the base's plan."""
    subsets = [
        frozenset(chosen)
        for size in range(1, len(base.goal) + 1)
        for chosen in combinations(sorted(base.goal), size)
    ]
    same = {s for s in subsets if PLANNER.plan(START, s) == base.plan}
    return {s for s in same if all(between in same for between in subsets if between >= s)}


@given(taught())
def test_pruning_keeps_what_brute_force_keeps(pair: Taught) -> None:
    _, shown = pair
    base = base_hypothesis(shown, (), learner())
    if isinstance(base, GoalHypothesis):
        found = generalisations(base, shown.start, learner())
        assert found[0] == base.goal
        assert len(found) == len(set(found))
        assert set(found) == kept_by_brute_force(base)
        assert [len(goal) for goal in found] == sorted(map(len, found), reverse=True)


@given(taught())
def test_nothing_below_a_rejected_goal_is_planned(pair: Taught) -> None:
    _, shown = pair
    base = base_hypothesis(shown, (), learner())
    if isinstance(base, GoalHypothesis):
        witness = NaivePlanner(TOY)
        kept = set(generalisations(base, shown.start, Learner(witness, TOY.surroundings)))
        rejected = [goal for goal in witness.asked if goal not in kept]
        assert len(witness.asked) == len(set(witness.asked))
        assert not any(low < high for low in witness.asked for high in rejected)


def test_without_pruning_every_subset_stays() -> None:
    base = base_hypothesis(SHOWN, (), learner())
    assert isinstance(base, GoalHypothesis)
    every = learner(LearningParameters(prune=False))
    assert len(generalisations(base, START, every)) == 2 ** len(base.goal) - 1


def test_pruning_drops_a_goal_that_a_shorter_plan_reaches() -> None:
    # "not on the first table" is reached by grasping alone; "on the second" needs both actions.
    space = space_of(SHOWN)
    assert set(ground_goals(space)) == {
        frozenset({Literal(on("Box_1", "Table_2")), Literal(on("Box_1", "Table_1"), False)}),
        frozenset({Literal(on("Box_1", "Table_2"))}),
    }
    assert space.edges == ((0, 1),)
    assert space.general == {1}


@FEW
@given(spaces())
def test_edges_lead_one_fluent_down_and_every_node_hangs_together(space: HypothesisSpace) -> None:
    for upper, lower in space.edges:
        assert len(space.nodes[lower].literals) == len(space.nodes[upper].literals) - 1
    below = {lower for _, lower in space.edges}
    assert below == set(range(1, len(space.nodes)))


@FEW
@given(spaces())
def test_the_plan_to_every_kept_goal_is_the_same(space: HypothesisSpace) -> None:
    plans = {PLANNER.plan(START, goal) for goal in ground_goals(space)}
    assert len(plans) == 1
    assert isinstance(plans.pop(), Plan)


@FEW
@given(spaces())
def test_json_round_trip(space: HypothesisSpace) -> None:
    again = HypothesisSpace.from_json(space.to_json())
    assert again == space
    assert again.digest == space.digest


@pytest.mark.parametrize("data", [{}, {"demonstration": 3}, {"demonstration": {"id": "x"}}])
def test_other_data_is_no_space(data: dict[str, object]) -> None:
    with pytest.raises(ValueError, match="not a hypothesis space"):
        HypothesisSpace.from_json(data)


def test_a_confirmed_goal_replaces_the_change() -> None:
    goal = frozenset({Literal(lit("Lamp_1"))})
    shown = Shown(START, PUT, SHOWN.end, goal)
    space = space_of(shown)
    assert ground_goals(space) == (goal,)
    assert space.confirmed
    unreachable = derive(WHO, Shown(START, PUT, START, frozenset({Literal(on("Box_1", "Sky"))})),
                         learner())  # fmt: skip
    assert isinstance(unreachable, NoHypothesis)
    assert unreachable.reason is NoHypothesisReason.NO_PLAN


def test_a_confirmed_goal_is_generalised_on_request() -> None:
    change = StateChange.between(START, SHOWN.end).literals
    shown = Shown(START, PUT, SHOWN.end, change)
    assert len(space_of(shown).nodes) == 1
    assert len(space_of(shown, LearningParameters(generalise_confirmed=True)).nodes) == 2


@FEW
@given(spaces(), st.data())
def test_striking_leaves_the_fluent_out_everywhere(
    space: HypothesisSpace, data: st.DataObject
) -> None:
    literal = data.draw(st.sampled_from(space.base))
    after = struck(space, literal, TOY.surroundings)
    if after is None:
        assert len(space.base) == 1
    else:
        assert after.confirmed
        assert frozenset(after.base) == frozenset(space.base) - {literal}
        assert all(literal not in goal for goal in ground_goals(after))
        kept = {goal for goal in ground_goals(space) if literal not in goal}
        assert kept <= set(ground_goals(after))


@FEW
@given(spaces(), st.data())
def test_insisting_keeps_the_fluent_everywhere(space: HypothesisSpace, data: st.DataObject) -> None:
    literal = data.draw(st.sampled_from(space.base))
    after = insisted(space, literal, TOY.surroundings)
    assert after.base == space.base
    goals = ground_goals(after)
    assert set(goals) == {goal for goal in ground_goals(space) if literal in goal}
    with pytest.raises(ValueError, match="not in the goal"):
        insisted(space, Literal(lit("Lamp_9")), TOY.surroundings)


def test_learning_that_fails_leaves_knowledge_as_it_was() -> None:
    knowledge = VerbKnowledge()
    after, why = learn(knowledge, WHO, Shown(START, (), START), learner())
    assert after is knowledge
    assert isinstance(why, NoHypothesis)


@settings(max_examples=20)
@given(walks(longest=3))
def test_a_larger_world_gives_the_same_space(actions: tuple[Action, ...]) -> None:
    # What is learned does not hang on objects that the demonstration left alone.
    larger = Toy(TOY.boxes, TOY.tables, (*TOY.lamps, "Lamp_2"))
    shown = Shown(START, actions, TOY.run(START, actions))
    here = derive(WHO, shown, learner())
    own = learner().__class__(NaivePlanner(larger), larger.surroundings)
    assert derive(WHO, shown, own) == here
