"""How far a stretch of teaching is: by sentences, as the tasks are given."""

from __future__ import annotations

from pathlib import Path

from tests.sessions.rooms import BOIL, begin, say
from verbteach_sessions.session import Session
from verbteach_sessions.study.stopping import Standing


def standing(session: Session) -> Standing:
    return Standing.of(session.turns(), session.now())


def test_several_commands_in_a_sentence_are_one_task(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: squash the bread and crush the egg\nskip\n")
        assert standing(session).right == ()
        assert not standing(session).between
        say(session, "skip\n")
        assert standing(session).right == (False,)
        assert standing(session).between


def test_commands_one_after_the_other_are_one_each_and_undone_as_such(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, BOIL + "command: squash the bread\nskip\n")
        assert len(standing(session).right) == 2
        say(session, "undo\n")
        assert len(standing(session).right) == 1
        assert not standing(session).between
