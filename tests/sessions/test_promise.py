"""A promise stands in the session's record, and is kept, recomputed and checked with it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.sessions.records import first, forge, read_events
from tests.sessions.rooms import BOIL, begin, resumed, say, settings
from verbteach.dialogue import acts
from verbteach.dialogue.acts import DemonstrationReason, Good, No, RequestDemonstration, Yes
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.promise import Promise, Sureness
from verbteach.policy.fixed_rules import ManualPolicy
from verbteach_sessions.method import Method, starting_policy
from verbteach_sessions.plain_values import ParameterError
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_sessions.validate import validate

PLAIN = Method(starting_policy())
AGAIN = "scene: kitchen-1\ncommand: boil the water\n"
SHOWN = BOIL.removesuffix("good\n")


def promising(sure: float, bias: float = 0.0) -> Method:
    """A robot as sure as ``bias`` says, whatever it knows."""
    return replace(PLAIN, promise=Promise(0.8, sure, 60, Sureness({"select_hypo": bias})))


def told_again(session: Session, answer: acts.TeacherAct) -> Session:
    """Boiling is taught, and asked for once more; ``answer`` to what is asked then."""
    say(session, SHOWN)
    while session.turn.phase is Phase.LEARNING:
        session.perform(Yes())
    session.perform(Good())
    say(session, AGAIN)
    while session.turn.phase is Phase.EXECUTION:
        session.perform(answer)
    return session


def test_the_header_says_so_only_where_something_is_promised() -> None:
    method = promising(0.7)
    assert "promise" not in PLAIN.to_json()
    assert set(method.to_json()) == {*PLAIN.to_json(), "promise"}
    assert Method.from_json(method.to_json()) == method
    assert Method.from_json(PLAIN.to_json()) == PLAIN
    for wrong in ({"rate": 2.0}, {"sure": "high"}, {"more": 1}):
        header = method.to_json()
        header["promise"] |= wrong
        with pytest.raises(ParameterError, match="promise"):
            Method.from_json(header)


@pytest.mark.parametrize("policy", [starting_policy(), ManualPolicy()])
@pytest.mark.parametrize("answer", [Yes(), No()])
def test_whatever_asks_an_unsure_robot_wants_to_be_shown(
    tmp_path: Path, policy: Any, answer: acts.TeacherAct
) -> None:
    method = replace(promising(0.7), policy=policy)
    with told_again(begin(tmp_path, method=method), answer) as session:
        assert session.turn.waiting_act == RequestDemonstration(DemonstrationReason.NOT_SURE)
        assert "not sure enough" in session.said[-1]
        path = session.path
    assert verify(path, settings).verified
    assert validate(path, settings).valid


def test_a_sure_robot_does_what_one_without_a_promise_does(tmp_path: Path) -> None:
    with told_again(begin(tmp_path / "a", method=promising(0.5)), Yes()) as session:
        assert session.turn.phase is Phase.JUDGEMENT
        promised = session.transcript()
    with told_again(begin(tmp_path / "b", method=PLAIN), Yes()) as session:
        assert session.transcript() == promised


def test_why_tells_of_the_promise_only_where_it_matters(tmp_path: Path) -> None:
    def why(folder: str, method: Method) -> list[str]:
        with told_again(begin(tmp_path / folder, method=method), Yes()) as session:
            return [one for one in session.robot.explain() if "promised" in one]

    (sure,) = why("sure", promising(0.5))
    assert "I promised that 80% of what I carry out is right" in sure
    assert "at least 50% sure, and am 50% sure now" in sure
    (unsure,) = why("unsure", promising(0.7))
    assert "at least 70% sure, and am 50% sure now" in unsure
    assert not why("plain", PLAIN)


def test_a_session_goes_on_under_its_promise(tmp_path: Path) -> None:
    with told_again(begin(tmp_path, method=promising(0.7)), Yes()) as session:
        path = session.path
    with resumed(path) as session:
        assert session.recovered == ()
        assert session.header.method == promising(0.7)
        say(session, "skip\n" + AGAIN)
        while session.turn.phase is Phase.EXECUTION:
            session.perform(Yes())
        assert session.turn.waiting_act == RequestDemonstration(DemonstrationReason.NOT_SURE)


def test_a_record_in_which_the_promise_was_broken_is_found_out(tmp_path: Path) -> None:
    with told_again(begin(tmp_path, method=promising(0.5)), Yes()) as session:
        path = session.path

    def stricter(events: list[dict[str, Any]]) -> None:
        first(events, "header")["data"]["promise"]["sure"] = 0.6

    forge(path, stricter)
    problem, *_ = validate(path, settings).problems
    assert problem.rule == "promise"
    assert problem.message == "carried out when 0.500 sure, the promise asks for 0.600"
    assert read_events(path)[problem.seq or 0]["type"] == "robot"
