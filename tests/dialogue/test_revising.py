"""A fluent of a learned hypothesis is struck out or confirmed; the verb then means that."""

from __future__ import annotations

import pytest

from tests.dialogue.stage import robot, taught_to_boil, tell
from verbteach.dialogue import acts
from verbteach.dialogue.moves import IllegalMoveError, Phase
from verbteach.dialogue.robot import Robot
from verbteach.verbs.knowledge import FrameSpace
from verbteach.verbs.revision import Revision, revised
from verbteach.verbs.space import FrameKey
from verbteach.world.fluents import Literal

BOIL = FrameKey("boil", 1)


def frame_of(pupil: Robot) -> FrameSpace:
    return pupil.state.knowledge.frames[BOIL]


def confirmed(frame: FrameSpace) -> tuple[Literal, ...]:
    (node,) = [node for node in frame.nodes.values() if node.confirmed]
    return node.literals


def in_the_goal(pupil: Robot, predicate: str) -> Literal:
    return next(x for x in confirmed(frame_of(pupil)) if x.fluent.predicate == predicate)


def predicates(frame: FrameSpace) -> set[str]:
    return {x.fluent.predicate for node in frame.nodes for x in node if x.positive}


def test_what_is_struck_out_is_in_no_hypothesis_any_more() -> None:
    pupil = taught_to_boil()
    before = frame_of(pupil)
    on = in_the_goal(pupil, "on")
    turn = tell(pupil, acts.RuleOut("boil/1", frozenset(confirmed(before)), on))
    after = frame_of(pupil)
    assert confirmed(after) == tuple(x for x in confirmed(before) if x != on)
    assert all(on not in node for node in after.nodes)
    assert 0 < len(after.nodes) < len(before.nodes)
    assert turn.phase is Phase.COMMAND
    assert f"{len(after.nodes)} of its {len(before.nodes)} hypotheses" in turn.texts[0]


def test_what_was_struck_out_is_not_asked_for_in_the_next_execution() -> None:
    pupil = taught_to_boil()
    on = in_the_goal(pupil, "on")
    tell(pupil, acts.RuleOut("boil/1", frozenset(confirmed(frame_of(pupil))), on))
    turn = tell(pupil, acts.GoToScene("kitchen-3"), acts.Command("boil the water"))
    assert isinstance(turn.waiting_act, acts.SelectHypo)
    assert {x.fluent.predicate for x in turn.waiting_act.goal} == {"hot"}


def test_what_is_confirmed_is_part_of_every_goal_of_that_lesson() -> None:
    pupil = taught_to_boil()
    whole = next(iter(frame_of(pupil).nodes))
    extra = next(x for x in whole if x.fluent.predicate == "is-on")
    tell(pupil, acts.Confirm("boil/1", frozenset(whole), extra))
    after = frame_of(pupil)
    assert all(any(x.fluent.predicate == "is-on" for x in node) for node in after.nodes)
    turn = tell(pupil, acts.GoToScene("kitchen-3"), acts.Command("boil the water"))
    assert isinstance(turn.waiting_act, acts.SelectHypo)
    assert "is-on" in {x.fluent.predicate for x in turn.waiting_act.goal}


def test_it_is_in_the_record_of_what_was_learned() -> None:
    pupil = taught_to_boil()
    before, on = pupil.state.knowledge, in_the_goal(pupil, "on")
    turn = tell(pupil, acts.RuleOut("boil/1", frozenset(confirmed(frame_of(pupil))), on))
    assert turn.learned is not None
    (recorded,) = turn.learned["revisions"]
    again = revised(before, Revision.from_json(recorded))
    assert again.digest == pupil.state.knowledge.digest


@pytest.mark.parametrize(
    ("frame", "hypothesis", "literal", "problem"),
    [
        ("fly/1", "(hot ?0)", "(hot ?0)", "nothing is known of fly/1"),
        ("boil", "(hot ?0)", "(hot ?0)", "write verb/number"),
        ("boil/1", "(hot ?0)", "(hot ?1)", "is not in that hypothesis"),
        ("boil/1", "(cold ?0)", "(cold ?0)", "no such hypothesis"),
    ],
)
def test_what_fits_nothing_is_refused_with_its_reason(
    frame: str, hypothesis: str, literal: str, problem: str
) -> None:
    pupil = taught_to_boil()
    on = in_the_goal(pupil, "on")
    tell(pupil, acts.RuleOut("boil/1", frozenset(confirmed(frame_of(pupil))), on))
    before = pupil.state.digest
    act = acts.RuleOut(frame, frozenset({Literal.parse(hypothesis)}), Literal.parse(literal))
    with pytest.raises(IllegalMoveError, match=problem):
        pupil.receive(act)
    assert pupil.state.digest == before


def test_the_last_fluent_cannot_be_struck_out() -> None:
    pupil = taught_to_boil()
    for _ in range(len(next(iter(frame_of(pupil).nodes)))):
        node = next(iter(frame_of(pupil).nodes))
        if len(node) == 1:
            break
        act = acts.RuleOut("boil/1", frozenset(node), node[0])
        tell(pupil, act)
    node = next(iter(frame_of(pupil).nodes))
    with pytest.raises(IllegalMoveError, match="nothing would be left"):
        pupil.receive(acts.RuleOut("boil/1", frozenset(node), node[0]))


def test_confirming_what_every_goal_has_says_so() -> None:
    pupil = taught_to_boil()
    node = confirmed(frame_of(pupil))
    hot = next(x for x in node if x.fluent.predicate == "hot")
    tell(pupil, acts.Confirm("boil/1", frozenset(node), hot))
    with pytest.raises(IllegalMoveError, match="nothing would change"):
        pupil.receive(acts.Confirm("boil/1", frozenset(node), hot))


def test_verbs_are_not_corrected_in_the_middle_of_a_command() -> None:
    pupil = taught_to_boil()
    act = acts.RuleOut("boil/1", frozenset(confirmed(frame_of(pupil))), in_the_goal(pupil, "on"))
    tell(pupil, acts.Command("wash the mug"))
    with pytest.raises(IllegalMoveError, match="does not fit"):
        pupil.receive(act)


def test_a_robot_that_knows_nothing_says_so() -> None:
    with pytest.raises(IllegalMoveError, match="nothing is known"):
        robot().receive(acts.RuleOut("boil/1", frozenset(), Literal.parse("(hot ?0)")))
