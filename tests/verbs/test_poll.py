"""Polls: counted as evidence is, and of some voters as if the others were not there."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.strategies import FEW, TOY, spaces
from verbteach.verbs.application import (
    ApplicationParameters,
    Evidence,
    Situation,
    evidence,
    supports,
    uniform,
)
from verbteach.verbs.criteria import PLAIN_CRITERIA, Teller
from verbteach.verbs.features import NAMES
from verbteach.verbs.knowledge import VerbKnowledge
from verbteach.verbs.poll import Poll
from verbteach.verbs.regression import Judged, Regression
from verbteach.verbs.selection import ranked
from verbteach.verbs.space import FrameKey, HypothesisSpace

FITTED = Regression(tuple(0.3 * i - 2 for i in range(len(NAMES))))
TELLERS: tuple[Teller, ...] = (*PLAIN_CRITERIA.values(), FITTED)
WIDE = ApplicationParameters(whole_verb=True)


def situation(space: HypothesisSpace, arity: int) -> Situation:
    belief = uniform((TOY.boxes,) * arity)
    key = FrameKey(space.demonstration.verb, arity)
    return Situation(key, ("the box",) * arity, belief, TOY.start, TOY.surroundings)


def named(found: list[HypothesisSpace]) -> list[HypothesisSpace]:
    """The spaces with demonstrations that differ."""
    return [
        replace(space, demonstration=space.demonstration._replace(id=f"d{i}", verb="move"))
        for i, space in enumerate(found)
    ]


def gathered(found: list[HypothesisSpace], arity: int) -> tuple[Evidence, ...]:
    return evidence(VerbKnowledge.merged(found), situation(found[0], arity), WIDE)


def poll(found: list[HypothesisSpace], arity: int) -> Poll:
    about = situation(found[0], arity)
    return Poll.of(supports(VerbKnowledge.merged(found), about, WIDE, False), about)


@FEW
@given(st.lists(spaces(), min_size=1, max_size=5), st.integers(0, 2), st.data())
def test_some_voters_count_as_if_nobody_else_had_been_asked(
    found: list[HypothesisSpace], arity: int, data: st.DataObject
) -> None:
    found = named(found)
    asked = data.draw(st.lists(st.sampled_from(found), min_size=1, unique_by=id))
    some = poll(found, arity).among({space.demonstration.id for space in asked})
    alone = gathered(asked, arity)
    assert some.goals == tuple(one.goal for one in alone)
    for criterion in TELLERS:
        assert criterion.tally(some).tolist() == [criterion.score(one) for one in alone]
        best = [(one.goal, one.score) for one in ranked(alone, criterion, 3)]
        assert [wanted[1:] for wanted in some.ranked(criterion.tally(some), 3)] == best


@FEW
@given(st.lists(spaces(), min_size=2, max_size=4))
def test_judged_votes_come_goal_by_goal(found: list[HypothesisSpace]) -> None:
    whole = poll(named(found), found[0].demonstration.frame.arity)
    order = list(reversed(range(len(whole.goals))))[:-1]
    judged = Judged.of(whole, {goal: goal / 10 for goal in order})
    expected = [
        (whole.features[vote].tolist(), goal / 10, whole.uses[vote].demonstration.id)
        for goal in order
        for vote in range(len(whole.uses))
        if whole.goals_of[vote] == goal
    ]
    rows = zip(judged.features.tolist(), judged.rewards.tolist(), judged.voters, strict=True)
    assert list(rows) == expected
    some = judged.among({"d0"})
    assert set(some.voters) <= {"d0"}
    assert len(some.rewards) == judged.voters.count("d0")
