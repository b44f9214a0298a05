"""Taking back and doing again: any turns, steps of a demonstration, conditions of a verb."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.records import read_events
from tests.sessions.rooms import begin, resumed, say, settings
from verbteach.dialogue import acts
from verbteach.verbs.space import FrameKey
from verbteach_sessions.errors import CannotUndoError
from verbteach_sessions.learned import knowledge_from, source_from
from verbteach_sessions.replay import verify
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Redo, Undo
from verbteach_sessions.validate import validate


def kinds(session: Session) -> list[str]:
    return [event["type"] for event in read_events(session.path)]


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
