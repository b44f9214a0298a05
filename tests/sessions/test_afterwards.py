"""A questionnaire is added to a session that has ended, and stays a part of the record."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.tui.room import SETTINGS
from verbteach.dialogue.acts import Command
from verbteach_sessions.afterwards import add_questionnaire
from verbteach_sessions.catalogue import entry
from verbteach_sessions.errors import DamagedLogError, SessionInUseError
from verbteach_sessions.eventlog import LogReader
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Quit
from verbteach_sessions.validate import validate

ANSWERS: dict[str, int | str | None] = {
    "effort": 35,
    "comment": 'nice\n"robot" \x1b[31m',
    "frustration": None,
}


def held(folder: Path, ended: bool = True) -> Path:
    with Session.create(folder, Header.new("kitchen-1"), SETTINGS) as session:
        session.perform(Command("open the fridge"))
        if ended:
            session.perform(Quit())
        return session.path


@pytest.mark.parametrize("ended", [True, False])
def test_it_stands_at_the_end_and_the_record_stays_sound(tmp_path: Path, ended: bool) -> None:
    path = held(tmp_path, ended)
    before = validate(path, SETTINGS)
    add_questionnaire(path, "nasa-tlx", ANSWERS, 12.34)
    last = list(LogReader(path))[-1]
    assert (last.type, last.data["answers"], last.data["seconds"]) == (
        "questionnaire",
        ANSWERS,
        12.3,
    )
    assert validate(path, SETTINGS) == before
    assert before.valid
    assert entry(path).ended == ended


def test_the_session_can_be_gone_on_with_and_its_content_holds_the_answers(tmp_path: Path) -> None:
    path = held(tmp_path)
    with Session.resume(path, SETTINGS) as session:
        content = session.content_hash
    add_questionnaire(path, "nasa-tlx", ANSWERS, 1.0)
    with Session.resume(path, SETTINGS) as session:
        assert session.content_hash != content
        assert session.turn.phase.value == "demonstration"
        with pytest.raises(SessionInUseError):
            add_questionnaire(path, "nasa-tlx", ANSWERS, 1.0)


def test_nothing_is_added_to_a_damaged_record(tmp_path: Path) -> None:
    path = held(tmp_path)
    log = path / "events.jsonl"
    log.write_bytes(log.read_bytes().replace(b"fridge", b"frigde", 1))
    before = log.read_bytes()
    with pytest.raises(DamagedLogError):
        add_questionnaire(path, "nasa-tlx", ANSWERS, 1.0)
    assert log.read_bytes() == before
