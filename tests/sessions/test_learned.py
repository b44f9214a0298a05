"""Going on from another session: what it taught, read from its record alone."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.sessions.records import raw_lines, read_events
from tests.sessions.rooms import BOIL, TAUGHT, begin, recorded, resumed, say, settings
from verbteach_sessions.errors import DamagedLogError, NotASessionError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.learned import knowledge_from, source_from
from verbteach_sessions.replay import verify


def test_what_was_learned_comes_without_recomputing(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, TAUGHT + "good\n")
        state = session.robot.state
        for path in (session.path, session.path / LOG_NAME):
            knowledge, experience = knowledge_from(path)
            assert knowledge.digest == state.knowledge.digest
            assert experience == state.experience


def test_what_was_undone_does_not_count(tmp_path: Path) -> None:
    assert knowledge_from(recorded(tmp_path, BOIL + "undo\n"))[0].verbs == ()
    assert knowledge_from(recorded(tmp_path, BOIL + "undo\nredo\n"))[0].verbs == ("boil",)


def test_a_session_goes_on_from_another_and_carries_it_along(tmp_path: Path) -> None:
    old = recorded(tmp_path, BOIL)
    with begin(tmp_path, "kitchen-3", source=source_from(old)) as session:
        assert session.robot.state.knowledge.digest == knowledge_from(old)[0].digest
        say(session, "command: boil the water\ngood\n")
        assert session.robot.state.totals.successes == 1
        digest = session.robot.state.digest
    header = read_events(session.path)[0]["data"]
    assert header["source"] == {
        "id": old.name,
        "content_hash": verify(old, settings).content_hash,
    }
    shutil.rmtree(old)
    assert verify(session.path, settings).verified
    with resumed(session.path) as again:
        assert again.robot.state.digest == digest
    assert str(tmp_path).encode() not in b"".join(raw_lines(session.path))


def test_a_third_session_knows_what_the_first_and_the_second_learned(tmp_path: Path) -> None:
    one = recorded(tmp_path, BOIL)
    open_fridge = "command: open the fridge\ndo: moveto Fridge_1\ndo: open Fridge_1\ndone\ngood\n"
    two = recorded(tmp_path, open_fridge, source=source_from(one))
    with begin(tmp_path, source=source_from(two)) as three:
        assert three.robot.state.knowledge.verbs == ("boil", "open")
        assert three.robot.state.knowledge.digest == knowledge_from(two)[0].digest


def test_going_on_from_the_same_lessons_has_one_content_hash(tmp_path: Path) -> None:
    hashes = set[str]()
    for _ in range(2):
        with begin(tmp_path, source=source_from(recorded(tmp_path, BOIL))) as session:
            hashes.add(session.content_hash)
    with begin(tmp_path) as session:
        assert session.content_hash not in hashes
    assert len(hashes) == 1


def test_what_cannot_be_trusted_is_not_learned_from(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    lines = raw_lines(path)
    (path / LOG_NAME).write_bytes(b"".join([*lines[:4], *lines[5:]]))
    with pytest.raises(DamagedLogError):
        knowledge_from(path)
    with pytest.raises(NotASessionError):
        knowledge_from(tmp_path)
    (path / LOG_NAME).write_bytes(lines[0])
    with pytest.raises(NotASessionError, match="nothing was said"):
        knowledge_from(path)
