"""Application in a new scene, the criteria, and the choice of a plan."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.strategies import FEW, learner, spaces
from tests.verbs.toy import NaivePlanner, Toy, lit, on
from verbteach.verbs.application import (
    ApplicationParameters,
    GroundingBelief,
    Situation,
    certain,
    evidence,
    likeliest,
    uniform,
)
from verbteach.verbs.criteria import (
    MOST_FREQUENT,
    MOST_GENERAL,
    MOST_SPECIFIC,
    PLAIN_CRITERIA,
    Oracle,
)
from verbteach.verbs.hypothesis import Shown
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.learning import derive
from verbteach.verbs.selection import (
    Pooling,
    Selection,
    SelectionParameters,
    candidates,
    select,
)
from verbteach.verbs.space import Demonstration, FrameKey, HypothesisSpace
from verbteach.world.fluents import Literal, satisfied
from verbteach.world.plan import Action

OLD = Toy(("Box_1", "Box_2"), ("Table_1", "Table_2"), ("Lamp_1",))
NEW = Toy(("Box_8", "Box_9"), ("Table_1", "Table_7"), ("Lamp_1",))
MOVE = (Action("grasp", ("Box_1",)), Action("put", ("Box_1", "Table_2")))
LIGHT = (Action("switch", ("Lamp_1",)),)


def taught(name: str, actions: tuple[Action, ...], grounding: tuple[str, ...]) -> HypothesisSpace:
    who = Demonstration(name, "tidy", ("it",) * len(grounding), grounding)
    shown = Shown(OLD.start, actions, OLD.run(OLD.start, actions))
    space = derive(
        who, shown, replace(learner(), planner=NaivePlanner(OLD), surroundings=OLD.surroundings)
    )
    assert isinstance(space, HypothesisSpace)
    return space


def in_new_room(belief: GroundingBelief, arity: int = 1) -> Situation:
    return Situation(FrameKey("tidy", arity), ("it",) * arity, belief, NEW.start, NEW.surroundings)


BOTH = VerbKnowledge.merged([taught("a", MOVE, ("Box_1", "Table_2"))])
BOX = VerbKnowledge.merged([taught("b", MOVE, ("Box_1",))])


def test_arguments_are_replaced_and_other_things_kept() -> None:
    found = evidence(BOTH, in_new_room(certain(("Box_9", "Table_7")), 2))
    goals = {one.goal for one in found}
    there = Literal(on("Box_9", "Table_7"))
    assert goals == {
        frozenset({there}),
        frozenset({there, Literal(on("Box_9", "Table_1"), False)}),
    }


def test_a_goal_about_a_missing_thing_is_dropped_or_moved_to_one_alike() -> None:
    situation = in_new_room(certain(("Box_9",)))
    assert evidence(BOX, situation) == ()
    found = evidence(BOX, situation, ApplicationParameters(replace_missing=8))
    assert frozenset({Literal(on("Box_9", "Table_7"))}) in {one.goal for one in found}
    assert all(s.replaced for one in found for s in one.supports)
    for one in found:
        assert not any("Table_2" in literal.fluent.args for literal in one.goal)


def test_equal_goals_add_up_over_demonstrations_and_groundings() -> None:
    light = [taught(name, LIGHT, ("Box_1",)) for name in "abc"]
    belief = uniform((("Box_8", "Box_9"),))
    (found,) = evidence(VerbKnowledge.merged(light), in_new_room(belief))
    assert found.goal == {Literal(lit("Lamp_1"))}
    assert MOST_FREQUENT.score(found) == pytest.approx(3.0)
    assert found.satisfied == 0.0


def test_the_whole_verb_gives_the_goals_of_its_other_frames() -> None:
    situation = in_new_room(certain(("Box_9",)))
    wide = ApplicationParameters(whole_verb=True, replace_missing=8)
    assert evidence(BOTH, situation) == ()
    # The frame's second argument, Table_2, is not here; its first may be either variable.
    assert {
        literal.fluent.args[0] for one in evidence(BOTH, situation, wide) for literal in one.goal
    } >= {"Box_9"}
    narrow = evidence(BOX, in_new_room(certain(("Box_9", "Table_7")), 2), wide)
    assert {"Box_9", "Table_7"} <= {literal.fluent.args[0] for e in narrow for literal in e.goal}


def test_only_the_most_general_hypotheses_apply_where_asked() -> None:
    situation = in_new_room(certain(("Box_9", "Table_7")), 2)
    (least,) = evidence(BOTH, situation, ApplicationParameters(least_only=True))
    assert least.goal == {Literal(on("Box_9", "Table_7"))}


def test_a_verb_that_nobody_taught_borrows_from_all() -> None:
    situation = in_new_room(certain(("Box_9", "Table_7")), 2)
    borrowed = ApplicationParameters(borrow_below=1)
    unknown = replace(situation, frame=FrameKey("stow", 2))
    assert evidence(BOTH, unknown) == ()
    assert {e.goal for e in evidence(BOTH, unknown, borrowed)} == {
        e.goal for e in evidence(BOTH, situation)
    }
    assert evidence(BOX, situation, borrowed) == ()  # the verb is known, in another frame
    assert evidence(BOTH, situation, ApplicationParameters(borrow_below=2)) == evidence(
        BOTH, situation
    )


def test_objects_that_a_hypothesis_does_not_speak_of_are_not_told_apart() -> None:
    """The lamp's goal is one support, whatever the other noun phrase may mean."""
    light = VerbKnowledge.merged([taught("a", LIGHT, ("Lamp_1", "Box_1"))])
    belief = uniform((("Lamp_1",), ("Box_8", "Box_9", "Table_7")))
    (found,) = evidence(light, in_new_room(belief, 2))
    (support,) = found.supports
    assert support.arguments == ("Lamp_1", None)
    assert support.probability == pytest.approx(1.0)


def test_specific_and_general_criteria_pick_the_ends_of_the_space() -> None:
    situation = in_new_room(certain(("Box_9", "Table_7")), 2)
    sizes = {
        criterion.name: [
            len(c.goal) for c in candidates(BOTH, situation, SelectionParameters(criterion))
        ]
        for criterion in (MOST_SPECIFIC, MOST_GENERAL, MOST_FREQUENT)
    }
    assert sizes == {"most_specific": [2], "most_general": [1], "most_frequent": [2, 1]}


def test_the_oracle_criterion_follows_its_judge() -> None:
    situation = in_new_room(certain(("Box_9", "Table_7")), 2)
    oracle = Oracle(lambda goal: 1.0 if len(goal) == 2 else 0.5)
    best, *_ = candidates(BOTH, situation, SelectionParameters(oracle))
    assert len(best.goal) == 2


def test_goals_with_the_same_plan_pool_their_scores() -> None:
    # One lit lamp (score 3) against two goals of one plan (2 each).
    spaces_ = [taught(n, LIGHT, ("Box_1", "Table_2")) for n in "abc"]
    spaces_ += [taught(n, MOVE, ("Box_1", "Table_2")) for n in "de"]
    knowledge = VerbKnowledge.merged(spaces_)
    situation = in_new_room(certain(("Box_9", "Table_7")), 2)
    parameters = SelectionParameters(MOST_FREQUENT)
    wanted = candidates(knowledge, situation, parameters)
    summed = select(wanted, NEW.start, NaivePlanner(NEW), parameters)
    best = select(wanted, NEW.start, NaivePlanner(NEW), replace(parameters, pooling=Pooling.BEST))
    assert isinstance(summed, Selection)
    assert isinstance(best, Selection)
    assert summed.score == pytest.approx(4.0)
    assert summed.plan.actions[-1] == Action("put", ("Box_9", "Table_7"))
    assert best.plan.actions == LIGHT
    assert satisfied(summed.candidate.goal, NEW.run(NEW.start, summed.plan.actions))


def test_what_holds_already_or_has_no_plan_is_not_chosen() -> None:
    lamp = VerbKnowledge.merged([taught("a", LIGHT, ("Box_1",))])
    lit_room = replace(in_new_room(certain(("Box_9",))), state=NEW.start | {lit("Lamp_1")})
    wanted = candidates(lamp, lit_room)
    assert [c.satisfied for c in wanted] == [1.0]
    assert select(wanted, lit_room.state, NaivePlanner(NEW)) is None
    lampless = Toy(NEW.boxes, NEW.tables, ())
    assert select(wanted, NEW.start, NaivePlanner(lampless)) is None
    assert select((), NEW.start, NaivePlanner(NEW)) is None


def test_groundings_are_cut_to_the_likeliest_and_normalised() -> None:
    belief = ((("b",), 0.25), (("a",), 0.25), (("c",), 0.5), (("d",), 0.0))
    assert likeliest(belief, 2) == ((("c",), 2 / 3), (("a",), 1 / 3))
    assert uniform((("a", "b"), ("c",))) == ((("a", "c"), 0.5), (("b", "c"), 0.5))


@FEW
@given(st.lists(spaces(), min_size=1, max_size=5), st.data())
def test_the_choice_does_not_hang_on_the_order_of_learning(
    found: list[HypothesisSpace], data: st.DataObject
) -> None:
    shuffled = data.draw(st.permutations(found))
    key = found[0].demonstration.frame
    belief = uniform((tuple(sorted(OLD.boxes)),) * key.arity)
    situation = Situation(key, ("it",) * key.arity, belief, OLD.start, OLD.surroundings)
    for criterion in PLAIN_CRITERIA.values():
        parameters = SelectionParameters(criterion)
        one = candidates(VerbKnowledge.merged(found), situation, parameters)
        other = candidates(VerbKnowledge.merged(shuffled), situation, parameters)
        assert one == other
        assert [c.score for c in one] == sorted((c.score for c in one), reverse=True)
        assert sum(c.share for c in one) == pytest.approx(1.0 if one else 0.0)
        planner = NaivePlanner(OLD)
        assert select(one, OLD.start, planner) == select(other, OLD.start, planner)
