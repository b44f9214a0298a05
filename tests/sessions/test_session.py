"""What one act of the person does to the session and to the disk."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.sessions.records import first, raw_lines, read_events
from tests.sessions.rooms import BOIL, TAUGHT, Clock, begin, recorded, resumed, say, settings
from verbteach.dialogue import acts
from verbteach.dialogue.acts import TeacherAct
from verbteach.dialogue.codec import teacher_act_to_json
from verbteach.dialogue.moves import IllegalMoveError, Phase
from verbteach.dialogue.parameters import RobotParameters
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import UnknownObjectError, UnknownSceneError
from verbteach.dialogue.turn import RobotTurn
from verbteach.perception.noise import NoiseModel
from verbteach.verbs.space import FrameKey
from verbteach.world.fluents import Fluent, Literal
from verbteach_sessions.errors import CannotUndoError, SessionEndedError, TooLongError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.header import Header
from verbteach_sessions.header_file import HEADER_NAME
from verbteach_sessions.learned import knowledge_from, source_from
from verbteach_sessions.lines import MAX_LINE
from verbteach_sessions.method import Method
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session, summary
from verbteach_sessions.session_acts import Flag, Note, Redo, Repeat, Undo, Why
from verbteach_sessions.validate import validate


def kinds(session: Session) -> list[str]:
    return [event["type"] for event in read_events(session.path)]


def test_a_new_session_is_on_the_disk_with_its_header(tmp_path: Path) -> None:
    with begin(tmp_path, terminal=(120, 40), participant="p7") as session:
        assert session.path == tmp_path / session.header.id
        header, robot = read_events(session.path)
        shown = json.loads((session.path / HEADER_NAME).read_text())
        assert shown == {"v": 2, **header["data"]}
        assert header["data"]["terminal"] == [120, 40]
        assert robot["data"]["texts"] == list(session.turn.texts) == list(session.said)
        assert session.turn.phase is Phase.COMMAND


def test_nothing_in_a_session_is_open_to_others(tmp_path: Path) -> None:
    with begin(tmp_path / "sessions") as session:
        for path in (session.path.parent, session.path, *session.path.iterdir()):
            assert path.stat().st_mode & 0o077 == 0, path


def test_an_unknown_scene_leaves_no_session_behind(tmp_path: Path) -> None:
    with pytest.raises(UnknownSceneError):
        begin(tmp_path, "the-moon")
    assert list(tmp_path.iterdir()) == []


def test_the_teachers_act_is_on_the_disk_before_the_robot_thinks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[str] = []
    receive = Robot.receive

    def spied(robot: Robot, act: TeacherAct) -> RobotTurn:
        last = read_events(session.path)[-1]
        assert last["data"]["act"] == teacher_act_to_json(act)
        seen.append(last["type"])
        return receive(robot, act)

    with begin(tmp_path) as session:
        monkeypatch.setattr(Robot, "receive", spied)
        say(session, BOIL)
        assert seen == ["teacher"] * len(BOIL.splitlines())
        assert kinds(session)[-1] == "robot"


def test_what_is_acknowledged_is_on_the_disk(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        for line in BOIL.splitlines():
            say(session, line)
            robot = first(read_events(session.path)[::-1], "robot")["data"]
            assert robot["texts"] == list(session.turn.texts)
            assert robot["after"]["digest"] == session.robot.state.digest


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


@pytest.mark.parametrize(
    ("before", "misfit", "error"),
    [
        ("", acts.Yes(), IllegalMoveError),
        ("", acts.Good(), IllegalMoveError),
        ("", acts.GoToScene("the-moon"), UnknownSceneError),
        (
            TAUGHT + "bad\ndo: moveto Mug_1\ndo: grasp Mug_1\ndone\n",
            acts.Strike(Literal(Fluent("hot", ("Nothing",)))),
            IllegalMoveError,
        ),
    ],
)
def test_what_does_not_fit_leaves_log_and_state_as_they_were(
    tmp_path: Path, before: str, misfit: TeacherAct, error: type[Exception]
) -> None:
    with begin(tmp_path) as session:
        say(session, before)
        lines, state = raw_lines(session.path), session.robot.state
        with pytest.raises(error):
            session.perform(misfit)
        assert raw_lines(session.path) == lines
        assert session.robot.state is state


def test_pointing_at_nothing_leaves_log_and_state_as_they_were(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: wash the glorp\n")
        assert session.turn.phase is Phase.EXECUTION
        lines, state = raw_lines(session.path), session.robot.state
        with pytest.raises(UnknownObjectError):
            session.perform(acts.Point("Nothing_1"))
        assert raw_lines(session.path) == lines
        assert session.robot.state is state


def test_a_robot_that_fails_leaves_a_fault_and_the_session_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(robot: Robot, act: TeacherAct) -> RobotTurn:
        raise RuntimeError("a bug")

    with begin(tmp_path) as session:
        say(session, "command: boil the water")
        state = session.robot.state
        with monkeypatch.context() as patched:
            patched.setattr(Robot, "receive", broken)
            with pytest.raises(RuntimeError, match="a bug"):
                session.perform(acts.Skip())
        assert session.robot.state is state
        assert kinds(session)[-2:] == ["teacher", "fault"]
        assert first(read_events(session.path), "fault")["data"]["message"] == "a bug"
        assert "skip" not in [line.kind for line in session.transcript()]
        session.perform(acts.Skip())
        assert session.turn.phase is Phase.COMMAND


def test_an_interrupted_robot_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(robot: Robot, act: TeacherAct) -> RobotTurn:
        raise KeyboardInterrupt

    with begin(tmp_path) as session:
        lines = raw_lines(session.path)
        with monkeypatch.context() as patched:
            patched.setattr(Robot, "receive", interrupted)
            with pytest.raises(KeyboardInterrupt):
                session.perform(acts.Command("boil the water"))
        assert raw_lines(session.path) == lines


def test_undo_and_redo_move_along_what_was_said(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        with pytest.raises(CannotUndoError):
            session.perform(Undo())
        say(session, "command: boil the water\ndo: moveto Kettle_1")
        moved = session.robot.state
        session.perform(Undo())
        session.perform(Undo())
        assert not session.can_undo
        assert session.can_redo
        session.perform(Redo())
        session.perform(Redo())
        assert session.robot.state is moved
        with pytest.raises(CannotUndoError):
            session.perform(Redo())
        session.perform(Undo())
        session.perform(acts.Skip())
        assert not session.can_redo, "a new act is another future"
        assert kinds(session)[-7:] == ["undo", "undo", "redo", "redo", "undo", "teacher", "robot"]


def test_several_acts_are_taken_back_and_done_again_at_once(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        digests = [session.robot.state.digest]
        for line in ("command: boil the water", "do: moveto Kettle_1", "do: grasp Kettle_1"):
            say(session, line)
            digests.append(session.robot.state.digest)
        session.perform(Undo(3))
        assert session.robot.state.digest == digests[0]
        session.perform(Redo(2))
        assert session.robot.state.digest == digests[2]
        with pytest.raises(CannotUndoError, match="only 2 to take back"):
            session.perform(Undo(3))
        with pytest.raises(CannotUndoError, match="only 1 to do again"):
            session.perform(Redo(2))
        assert session.robot.state.digest == digests[2]
        assert kinds(session)[-2:] == ["undo", "redo"]
    assert verify(session.path, settings).verified
    with resumed(session.path) as again:
        again.perform(Redo())
        assert again.robot.state.digest == digests[3]


EDITED = """
command: boil the water
do: moveto Tap_1
do: moveto Kettle_1
insert: 3 grasp Kettle_1
move: 1 3
do: moveto Burner_1
do: set-on Kettle_1 Burner_1
do: moveto StoveKnob_1
do: turn StoveKnob_1
remove: 3
remove: 2
done
good
"""


def test_an_edited_demonstration_and_a_corrected_verb_replay_to_the_bit(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, EDITED)
        frame = session.robot.state.knowledge.frames[FrameKey("boil", 1)]
        node = next(node.literals for node in frame.nodes.values() if node.confirmed)
        on = next(one for one in node if one.fluent.predicate == "on")
        session.perform(acts.RuleOut("boil/1", frozenset(node), on))
        digest = session.robot.state.digest
    assert verify(session.path, settings).verified
    assert validate(session.path, settings).valid
    assert knowledge_from(session.path)[0].digest == session.robot.state.knowledge.digest
    with begin(tmp_path, "kitchen-3", source=source_from(session.path)) as other:
        assert other.robot.state.knowledge.digest == session.robot.state.knowledge.digest
    with resumed(session.path) as again:
        assert again.robot.state.digest == digest
        again.perform(Undo())
        assert FrameKey("boil", 1) in again.robot.state.knowledge.frames
        assert again.robot.state.knowledge.frames[FrameKey("boil", 1)] == frame


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


def test_quitting_ends_the_session_but_not_its_record(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: boil the water\nquit")
        assert session.ended
        with pytest.raises(SessionEndedError, match="resume it"):
            session.perform(Flag())
        assert kinds(session)[-1] == "end"


def test_what_teach_prints_of_a_session(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, TAUGHT + "good\n")
        printed = summary(session)
        assert printed["session"] == str(session.path)
        assert (printed["episodes"], printed["successes"]) == (2, 1)
        assert printed["verbs_learned"] == ["boil"]
        assert printed["reward"] == 200.0
        assert json.loads(json.dumps(printed)) == printed


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


def test_what_is_too_long_for_a_line_is_refused_and_nothing_kept(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        lines = raw_lines(session.path)
        for act in (Note("x" * MAX_LINE), acts.Command("boil" + " the water" * (MAX_LINE // 10))):
            with pytest.raises(TooLongError, match="too long to be kept"):
                session.perform(act)
        assert raw_lines(session.path) == lines


SAID = TAUGHT + "why\ngood\nnote: fine\nundo\nredo\n"


def test_one_script_has_one_content_hash_in_every_interface(tmp_path: Path) -> None:
    hashes: set[str] = set()
    for interface, via in (("app", "key"), ("plain", "typed"), ("script", "script")):
        header = Header.new("kitchen-1", interface=interface, terminal=(80, len(via)))
        clock = Clock(start=float(len(hashes)))
        with Session.create(tmp_path, header, settings, clock=clock) as session:
            say(session, SAID)
            hashes.add(session.content_hash)
    assert len(hashes) == 1


@pytest.mark.parametrize(
    "other",
    [SAID + "flag\n", SAID.replace("fine", "fin"), SAID.replace("good\nnote", "bad\nnote")],
)
def test_another_script_has_another_content_hash(tmp_path: Path, other: str) -> None:
    with begin(tmp_path) as one, begin(tmp_path) as two:
        assert say(one, SAID).content_hash != say(two, other).content_hash


def test_another_seed_has_another_content_hash(tmp_path: Path) -> None:
    seeded = Method(parameters=RobotParameters(seed=1))
    with begin(tmp_path) as one, begin(tmp_path, method=seeded) as two:
        assert one.content_hash != two.content_hash


def test_session_time_starts_at_zero_and_runs_forward(tmp_path: Path) -> None:
    events = read_events(recorded(tmp_path, SAID))
    times = [event["at"] for event in events]
    assert times[0] == 0.0
    assert times == sorted(times)
    assert (tmp_path / events[0]["data"]["id"] / LOG_NAME).exists()
