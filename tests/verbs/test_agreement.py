"""Plans that agree, and the plan that agrees most with what is wanted."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.verbs.toy import NaivePlanner, Toy, lit
from verbteach.verbs.agreement import agreement
from verbteach.verbs.application import Evidence, Situation, certain
from verbteach.verbs.selection import GoalCandidate, Pooling, SelectionParameters, select
from verbteach.verbs.space import FrameKey
from verbteach.world.fluents import Literal
from verbteach.world.plan import Action

plans = st.lists(st.sampled_from([Action(n) for n in "abc"]), max_size=5).map(tuple)


@given(plans, plans)
def test_agreement_is_symmetric_and_one_for_equals_only(
    one: tuple[Action, ...], other: tuple[Action, ...]
) -> None:
    assert agreement(one, other) == agreement(other, one)
    assert 0 <= agreement(one, other) <= 1
    assert (agreement(one, other) == 1) == (one == other)


LAMPS = ("Lamp_1", "Lamp_2", "Lamp_3", "Lamp_4", "Lamp_5")
TOY = Toy((), ("Table_1",), LAMPS)


def wanted(score: float, *lamps: str) -> GoalCandidate:
    goal = frozenset(Literal(lit(lamp)) for lamp in lamps)
    situation = Situation(FrameKey("light", 0), (), certain(()), frozenset(), TOY.surroundings)
    return GoalCandidate(goal, score, score, (), (), 0.0, Evidence(goal, (), situation))


def lamps_lit(pooling: Pooling) -> set[str]:
    """The best single goal is an outlier; two others nearly agree with each other."""
    found = (wanted(4.0, "Lamp_5"), wanted(3.0, "Lamp_1", "Lamp_2"),
             wanted(2.5, "Lamp_1", "Lamp_2", "Lamp_3"))  # fmt: skip
    chosen = select(found, frozenset(), NaivePlanner(TOY), SelectionParameters(pooling=pooling))
    assert chosen is not None
    return {action.args[0] for action in chosen.plan.actions}


def test_consensus_takes_the_plan_that_is_nearly_right_for_most() -> None:
    assert lamps_lit(Pooling.SUM) == lamps_lit(Pooling.BEST) == {"Lamp_5"}
    assert lamps_lit(Pooling.CONSENSUS) == {"Lamp_1", "Lamp_2"}


def test_consensus_scores_are_agreements_times_scores() -> None:
    found = (wanted(3.0, "Lamp_1", "Lamp_2"), wanted(2.0, "Lamp_1"))
    parameters = SelectionParameters(pooling=Pooling.CONSENSUS)
    chosen = select(found, frozenset(), NaivePlanner(TOY), parameters)
    assert chosen is not None
    assert chosen.score == pytest.approx(3.0 + 0.5 * 2.0)
