"""Every act survives the way to JSON and back; what is no act is refused with a reason."""

from __future__ import annotations

import json
import re
from dataclasses import fields
from typing import Any, get_type_hints

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach.dialogue import codec
from verbteach.dialogue.acts import DemonstrationReason, Outcome, RobotAct, TeacherAct, Yes
from verbteach.dialogue.decision import Candidate, Decision
from verbteach.world.fluents import Fluent, Goal, Literal
from verbteach.world.plan import Action

WORDS = st.from_regex(r"[A-Za-z][A-Za-z0-9_-]{0,8}", fullmatch=True)
FLUENTS = st.builds(
    Fluent, WORDS.filter(lambda w: w != "not"), st.lists(WORDS, max_size=3).map(tuple)
)
LITERALS = st.builds(Literal, FLUENTS, st.booleans())
ACTIONS = st.builds(Action, WORDS, st.lists(WORDS, max_size=3).map(tuple))
VALUES: dict[Any, st.SearchStrategy[Any]] = {
    str: st.text(),
    int: st.integers(0, 60),
    bool: st.booleans(),
    Fluent: FLUENTS,
    Literal: LITERALS,
    Goal: st.frozensets(LITERALS, max_size=4),
    Action: ACTIONS,
    Action | None: st.none() | ACTIONS,
    tuple[Action, ...]: st.lists(ACTIONS, max_size=4).map(tuple),
    tuple[Literal, ...]: st.lists(LITERALS, max_size=4).map(tuple),
    tuple[tuple[str, str], ...]: st.lists(st.tuples(st.text(), WORDS), max_size=3).map(tuple),
    DemonstrationReason: st.sampled_from(DemonstrationReason),
    Outcome: st.sampled_from(Outcome),
}


def acts_of(kind: type[Any]) -> st.SearchStrategy[Any]:
    hints = get_type_hints(kind)
    return st.builds(kind, **{f.name: VALUES[hints[f.name]] for f in fields(kind)})


ROBOT = st.one_of([acts_of(kind) for kind in codec.ROBOT_ACTS.values()])
TEACHER = st.one_of([acts_of(kind) for kind in codec.TEACHER_ACTS.values()])


@given(ROBOT)
def test_robot_acts_round_trip_through_json_text(act: RobotAct) -> None:
    text = json.dumps(codec.robot_act_to_json(act))
    assert codec.robot_act_from_json(json.loads(text)) == act


@given(TEACHER)
def test_teacher_acts_round_trip_through_json_text(act: TeacherAct) -> None:
    text = json.dumps(codec.teacher_act_to_json(act))
    assert codec.teacher_act_from_json(json.loads(text)) == act


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        (17, "an act is an object"),
        ({"act": "sing"}, "unknown act 'sing'"),
        ({"act": "yes", "loudly": True}, "has the fields"),
        ({"act": "command", "text": 3}, "expected text"),
        ({"act": "stop", "step": True}, "expected an integer"),
        ({"act": "strike", "literal": "((("}, "not a fluent"),
        ({"act": "do", "action": ""}, "an action needs a name"),
    ],
)
def test_what_is_no_act_is_refused_with_its_reason(value: Any, reason: str) -> None:
    with pytest.raises(codec.ActFormatError, match=re.escape(reason)):
        codec.teacher_act_from_json(value)


def test_a_decision_keeps_every_candidate_and_its_numbers() -> None:
    decision = Decision(
        (
            Candidate(
                codec.robot_act_from_json({"act": "await_command"}), {"b": 2.0, "a": 1.0}, 0.5
            ),
        ),
        chosen=0,
        propensity=0.9,
        explored=True,
        reason="told so",
    )
    written = codec.decision_to_json(decision)
    assert list(written["candidates"][0]["features"]) == ["a", "b"]
    assert (written["propensity"], written["explored"], written["chosen"]) == (0.9, True, 0)
    assert codec.teacher_act_to_json(Yes()) == {"act": "yes"}
