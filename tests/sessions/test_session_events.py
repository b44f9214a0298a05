"""What an act leaves in the log and in the transcript, to the letter."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.records import first, read_events
from tests.sessions.rooms import BOIL, TAUGHT, begin, recorded, say, settings
from verbteach.dialogue import acts
from verbteach.dialogue.moves import Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.perception.noise import NoiseModel
from verbteach_sessions.method import Method
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Note, Repeat, Why


def kinds(session: Session) -> list[str]:
    return [event["type"] for event in read_events(session.path)]


def test_a_teachers_event_says_how_it_came_and_to_what(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        shown = session.now()
        session.perform(acts.Command("boil the water"), raw="boil the wat\x1b[Aer", shown_at=shown)
        session.perform(acts.Skip(), raw="s", via="key")
        one, other = (first(read_events(session.path), "teacher", n) for n in (0, 1))
        assert one["data"]["reply_to"] == 1
        assert one["data"]["raw"] == "boil the wat\x1b[Aer"
        assert one["data"]["via"] == "typed"
        assert one["data"]["shown_at"] == shown < one["data"]["answered_at"] == one["at"]
        assert other["data"]["reply_to"] == 3
        assert (other["data"]["raw"], other["data"]["via"]) == ("s", "key")


def test_asking_why_changes_nothing_and_is_recorded(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: boil the water")
        state = session.robot.state
        session.perform(Why(), raw="w", via="key")
        assert session.said == session.robot.explain()
        session.perform(Repeat())
        assert session.said == state.turn.texts
        assert session.robot.state is state
        assert kinds(session)[-2:] == ["why", "repeat"]
        assert first(read_events(session.path), "why")["data"]["texts"] == list(
            session.robot.explain()
        )


def test_the_transcript_holds_what_still_holds(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: boil the water\ndo: moveto Kettle_1\nnote: careful\nflag\nwhy\nundo")
        lines = session.transcript()
        assert [line.kind for line in lines if line.speaker == "teacher"] == ["command"]
        assert [(line.speaker, line.text) for line in lines if line.speaker == "note"] == [
            ("note", "careful"),
            ("note", "flagged"),
        ]
        assert [line.seq for line in lines] == sorted(line.seq for line in lines)
        say(session, "redo")
        assert [line.text for line in session.transcript() if line.speaker == "teacher"] == [
            "boil the water",
            "moveto Kettle_1",
            "why",
        ]


def test_questions_in_the_transcript_show_their_price(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: wash the glorp")
        asked = [line for line in session.transcript() if line.price is not None]
        assert [line.kind for line in asked] == [session.turn.waiting_act.name]
        assert (
            asked[0].price
            == {"np_grd_whq": (-6.5, -6.5), "np_grd_ynq": (-1.0, -2.0)}[asked[0].kind]
        )


def test_learning_is_an_event_of_its_own_before_the_reply(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    teacher, learned, robot = read_events(path)[-3:]
    assert [teacher["type"], learned["type"], robot["type"]] == ["teacher", "learned", "robot"]
    assert learned["data"]["reply_to"] == robot["data"]["reply_to"] == teacher["seq"]
    assert learned["data"]["record"]["spaces"][0]["demonstration"]["verb"] == "boil"


def test_a_robots_event_holds_its_choice_and_its_beliefs(tmp_path: Path) -> None:
    events = read_events(recorded(tmp_path, TAUGHT))
    execution = events[-1]["data"]
    decision = execution["decisions"][-1]
    assert decision["candidates"][decision["chosen"]]["act"]["act"] == "select_hypo"
    assert decision["propensity"] == 1.0
    assert execution["beliefs"]["grounding"][0]["phrase"]
    assert sum(goal["share"] for goal in execution["beliefs"]["goals"]) == pytest.approx(1)
    trace = execution["trace"]
    assert len(trace["worlds"]) == len(trace["done"]) + 1
    assert trace["worlds"][-1] == execution["after"]["world"]


def test_with_noise_the_uncertain_fluents_are_recorded(tmp_path: Path) -> None:
    method = Method(parameters=RobotParameters(seed=3, noise=NoiseModel.named("std5", "phantom")))
    events = read_events(recorded(tmp_path, "command: boil the water", method=method))
    uncertain = events[-1]["data"]["beliefs"]["uncertain"]
    assert len(uncertain) > 10
    assert all(0 < p < 1 for _, p in uncertain)


@pytest.mark.parametrize(
    "text",
    [
        "",
        " ",
        "x" * 10_000,
        "\x1b[2J\x00\x07\r\n\u2028",
        "[red]boil[/red] the water",
        "hierve el agua, 沸騰させて, اغلي الماء",
        "\udcff\ud800",
        '{"v":1,"seq":0}\n',
    ],
)
def test_whatever_is_typed_is_kept_to_the_letter(tmp_path: Path, text: str) -> None:
    with begin(tmp_path) as session:
        session.perform(acts.Command(text), raw=text)
        session.perform(Note(text))
        if session.turn.phase is not Phase.COMMAND:
            session.perform(acts.Say(text), raw=text)
    events = read_events(session.path)
    assert first(events, "teacher")["data"]["act"]["text"] == text
    assert first(events, "teacher")["data"]["raw"] == text
    assert verify(session.path, settings).verified
