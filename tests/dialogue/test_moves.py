"""The tables of legal moves are complete and consistent with each other."""

from __future__ import annotations

from typing import get_args

import pytest

from verbteach.dialogue import acts
from verbteach.dialogue.moves import (
    ROBOT_MOVES,
    TEACHER_MOVES,
    IllegalMoveError,
    Phase,
    check_teacher_act,
    expected,
)
from verbteach.dialogue.rewards import Rewards

# Said on the way to the act that waits, so that no phase waits on them.
PASSING = {
    acts.StartClause,
    acts.ReportExecution,
    acts.Learned,
    acts.ReviseVerb,
    acts.CloseEpisode,
}


def test_every_phase_stands_in_both_tables() -> None:
    assert set(ROBOT_MOVES) == set(TEACHER_MOVES) == set(Phase)


def test_every_act_has_a_place() -> None:
    waiting = {kind for kinds in ROBOT_MOVES.values() for kind in kinds}
    assert waiting | PASSING == set(get_args(acts.RobotAct))
    assert not waiting & PASSING
    assert {k for kinds in TEACHER_MOVES.values() for k in kinds} == set(get_args(acts.TeacherAct))


def test_every_phase_can_be_reached_from_the_first() -> None:
    reached = {Phase.COMMAND}
    for _ in Phase:
        reached |= {
            p for start in reached for nexts in TEACHER_MOVES[start].values() for p in nexts
        }
    assert reached == set(Phase)


def test_every_phase_but_the_first_leads_back_to_it() -> None:
    home = {Phase.COMMAND}
    for _ in Phase:
        home |= {p for p in Phase if any(home & set(nexts) for nexts in TEACHER_MOVES[p].values())}
    assert home == set(Phase)


def test_a_misfit_names_what_would_fit() -> None:
    with pytest.raises(IllegalMoveError, match=r"waits to hear .*: good, bad, stop"):
        check_teacher_act(Phase.JUDGEMENT, acts.Done())
    assert expected(Phase.COMMAND) == ("command", "scene", "rule_out", "confirm")


def test_the_prices_are_those_of_table_2() -> None:
    rewards = Rewards()
    assert {kind.name for kind in acts.QUESTIONS} < set(rewards.prices)
    assert rewards.of("np_grd_whq", positive=False) == -6.5
    assert rewards.of("goal_pred_ynq", positive=True) == -1.0
    assert rewards.of("goal_pred_ynq", positive=False) == -2.0
    assert rewards.of("bulk_np_grd_ynq", positive=False) == -6.0
    assert rewards.of("select_hypo", positive=True) == 100.0
    assert rewards.of("await_command", positive=True) == 0.0
