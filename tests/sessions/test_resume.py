"""Resuming where recomputing gives something else: the record is the authority."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.sessions.records import first, forge, raw_lines, read_events
from tests.sessions.rooms import BOIL, TAUGHT, Clock, begin, recorded, resumed, say, settings
from verbteach.dialogue.setting import Setting, UnknownSceneError
from verbteach_sessions.errors import LogError, SessionError
from verbteach_sessions.header import Machine
from verbteach_sessions.learned import knowledge_from
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session, summary

OTHER_ROBOT = "I said it in other words then."


def spoke_otherwise(events: list[dict[str, Any]]) -> None:
    """As if an earlier version of the robot had worded its replies otherwise."""
    events[0]["data"]["software"] = {"numpy": "0.1", "verbteach": "0.0.1"}
    for event in events[2:]:
        if event["type"] == "robot":
            event["data"]["texts"][0] = OTHER_ROBOT
            event["data"]["after"]["digest"] = "0" * 64


@pytest.fixture
def otherwise(tmp_path: Path) -> Path:
    path = recorded(tmp_path, TAUGHT + "good\n")
    forge(path, spoke_otherwise)
    return path


def test_what_was_learned_is_rebuilt_from_the_record(otherwise: Path) -> None:
    learned, experience = knowledge_from(otherwise)
    with resumed(otherwise) as session:
        state = session.robot.state
        assert state.knowledge.digest == learned.digest
        assert state.experience == experience
        assert state.knowledge.verbs == ("boil",)


def test_the_person_is_told_and_goes_on_at_a_fresh_command(otherwise: Path) -> None:
    with resumed(otherwise) as session:
        (told,) = session.recovered
        assert "numpy 0.1, now" in told
        assert "kitchen-3 begins anew" in told
        assert session.turn.phase.value == "command"
        assert session.robot.state.world == settings("kitchen-3").scene.initial
        assert not session.can_undo
        say(session, "command: boil the water\ngood\n")
        printed = summary(session)
        assert (printed["episodes"], printed["successes"], printed["reward"]) == (3, 2, 300.0)


def test_the_lines_of_before_stay_as_they_were_recorded(otherwise: Path) -> None:
    with resumed(otherwise) as session:
        texts = [line.text for line in session.transcript()]
        assert OTHER_ROBOT in texts
        assert "boil the water" in texts
        assert texts[-1] == session.turn.texts[-1]


def test_a_rebuilt_session_resumes_without_another_rebuild(otherwise: Path) -> None:
    with resumed(otherwise) as session:
        say(session, "command: boil the water\ngood\nundo\nundo\n")
        digest = session.robot.state.digest
        hashed = session.content_hash
    with resumed(otherwise) as again:
        assert again.recovered == ()
        assert again.robot.state.digest == digest
        assert again.content_hash == hashed
        assert not again.can_undo
        assert again.can_redo
        say(again, "redo\nredo\n")
    kinds = [event["type"] for event in read_events(otherwise)]
    assert kinds.count("rebuild") == 1
    assert kinds.count("resume") == 2


def test_verifying_a_rebuilt_session_still_names_the_difference(otherwise: Path) -> None:
    resumed(otherwise).close()
    verification = verify(otherwise, settings)
    difference = verification.first_difference
    assert not verification.verified
    assert difference is not None
    assert (difference.seq, difference.field) == (3, "texts[0]")
    rebuild = first(read_events(otherwise), "rebuild")["data"]
    assert (rebuild["difference"]["seq"], rebuild["difference"]["field"]) == (3, "texts[0]")


def test_what_was_undone_is_not_rebuilt(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL + "undo\n")
    forge(path, spoke_otherwise)
    with resumed(path) as session:
        assert session.robot.state.knowledge.verbs == ()
        assert session.robot.state.totals.reward == 0.0


def test_an_act_that_waited_for_an_answer_is_to_be_said_again(tmp_path: Path) -> None:
    path = recorded(tmp_path, TAUGHT + "good\n")

    def cut(events: list[dict[str, Any]]) -> None:
        spoke_otherwise(events)
        while events[-1]["type"] != "teacher":
            events.pop()

    forge(path, cut)
    with resumed(path) as session:
        assert first(read_events(path), "fault")["data"]["message"].endswith("say it again")
        assert session.robot.state.knowledge.verbs == ("boil",)
        assert session.robot.state.totals.successes == 0


def test_a_record_that_was_learned_otherwise_is_the_authority(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)

    def learned_otherwise(events: list[dict[str, Any]]) -> None:
        record = first(events, "learned")["data"]["record"]
        record["experience"] = [["the water", "Kettle_1"]]

    forge(path, learned_otherwise)
    with resumed(path) as session:
        assert session.recovered
        assert session.robot.state.experience == {("the water", "Kettle_1"): 1}


def test_records_that_teach_nothing_are_an_error_that_names_them(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)

    def nonsense(events: list[dict[str, Any]]) -> None:
        first(events, "learned")["data"]["record"]["spaces"] = [{"no": "space"}]

    forge(path, nonsense)
    lines = raw_lines(path)
    with pytest.raises(LogError, match="learned cannot be read"):
        resumed(path)
    with pytest.raises(LogError, match="learned cannot be read"):
        knowledge_from(path)
    assert raw_lines(path) == lines, "what cannot be resumed stays as it was"


def test_a_scene_that_is_gone_is_named(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)

    def no_scenes(scene: str) -> Setting:
        raise UnknownSceneError(f"there is no scene {scene!r}")

    with pytest.raises(UnknownSceneError, match="kitchen-1"):
        Session.resume(path, no_scenes)


def test_session_time_goes_on_where_it_stood_still(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    last = read_events(path)[-1]["at"]
    with Session.resume(path, settings, clock=Clock(start=5.0)) as session:
        say(session, "note: back")
        times = [event["at"] for event in read_events(path)]
        assert times == sorted(times)
        assert last < times[-1] < last + 10


def test_a_resumed_session_says_where_it_went_on(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL + "quit\n")
    machine = Machine.here("plain", (80, 24))
    with Session.resume(path, settings, machine=machine) as session:
        assert not session.ended
        resume = read_events(path)[-1]
        assert resume["type"] == "resume"
        assert (resume["data"]["interface"], resume["data"]["terminal"]) == ("plain", [80, 24])
    with begin(tmp_path) as other:
        assert other.header.machine.interface == "script"


@pytest.mark.parametrize(
    ("field", "value", "reason"),
    [
        ("policy", {"name": "clairvoyant"}, "no policy 'clairvoyant'"),
        ("noise", {"spread": "much"}, "noise"),
        ("parameters", {"rewards": {}, "luck": 7}, "parameters"),
        ("id", "../../etc", "no session name"),
        ("participant", "a/b", "no participant code"),
    ],
)
def test_a_header_that_cannot_be_used_is_refused(
    tmp_path: Path, field: str, value: object, reason: str
) -> None:
    path = recorded(tmp_path, BOIL)

    def change(events: list[dict[str, Any]]) -> None:
        events[0]["data"][field] = value

    forge(path, change)
    with pytest.raises(SessionError, match=reason):
        resumed(path)
