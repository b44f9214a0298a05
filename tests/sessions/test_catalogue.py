"""Listing sessions: quick, private, and never upset by what lies in the folder."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from errno import EACCES
from pathlib import Path
from typing import NoReturn

import pytest

from tests.sessions.records import raw_lines, read_events
from tests.sessions.rooms import BOIL, TAUGHT, babble, begin, recorded, resumed, say, settings
from verbteach_sessions.catalogue import default_folder, entry, find_session, list_sessions
from verbteach_sessions.errors import NoHomeError, NotASessionError, UnsafeNameError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.header import Header
from verbteach_sessions.session import Session, summary


def at(hour: int) -> Header:
    moment = datetime(2030, 1, 1, tzinfo=UTC) + timedelta(hours=hour)
    return Header.new("kitchen-1", participant=f"p{hour}", now=lambda: moment)


def test_sessions_are_listed_the_newest_first(tmp_path: Path) -> None:
    for hour in (2, 9, 5):
        Session.create(tmp_path, at(hour), settings).close()
    entries = list_sessions(tmp_path)
    assert [one.participant for one in entries] == ["p9", "p5", "p2"]
    assert entries[0].created == "2030-01-01T09:00:00+00:00"
    assert entries[0].scene == "kitchen-1"
    assert all(one.resumable for one in entries)
    assert list_sessions(tmp_path / "nowhere") == ()


def test_a_folder_that_may_not_be_looked_into_hides_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Session.create(tmp_path / "k7m2", at(1), settings).close()
    (tmp_path / "lost+found").mkdir()
    within = Path.iterdir

    def guarded(path: Path) -> Iterator[Path]:
        if path.name == "lost+found":
            raise PermissionError(EACCES, "Permission denied", str(path))
        return within(path)

    monkeypatch.setattr(Path, "iterdir", guarded)
    assert [one.participant for one in list_sessions(tmp_path)] == ["p1"]


@pytest.mark.parametrize("seed", range(4))
def test_an_entry_says_what_holds(tmp_path: Path, seed: int) -> None:
    with begin(tmp_path) as session:
        say(session, BOIL)
        babble(session, seed, 20)
        printed, state = summary(session), session.robot.state
    listed = entry(session.path)
    assert listed.id == session.header.id
    assert listed.episodes == printed["episodes"]
    assert list(listed.verbs_learned) == printed["verbs_learned"]
    assert listed.scene == state.scene
    assert json.loads(json.dumps(listed.to_json()))["resumable"] is True


def test_an_entry_knows_of_undo_and_of_the_end(tmp_path: Path) -> None:
    assert entry(recorded(tmp_path, TAUGHT)).verbs_learned == ("boil",)
    undone = recorded(tmp_path, BOIL + "undo\nnote: hm\nquit\n")
    assert (entry(undone).verbs_learned, entry(undone).episodes) == ((), 0)
    assert entry(undone).ended
    resumed(undone).close()
    assert not entry(undone).ended


def test_an_open_session_cannot_be_resumed(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        assert entry(session.path).problem == "it is open in another place"
    assert entry(session.path).resumable


def test_a_torn_last_line_does_not_hide_what_holds(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    with (path / LOG_NAME).open("ab") as file:
        file.write(raw_lines(path)[-1][:100])
    assert entry(path).verbs_learned == ("boil",)
    assert entry(path).resumable


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        (b"", "nothing was said"),
        (b"garbage\n", "is not JSON"),
        (b'{"v":9}\n', "version 9"),
        (b'{"v":1,"type":"note"}\n', "no header"),
        (b"[" * 100_000, "nested too deeply"),
        (b'{"v":1,"type":"header","data":{"created":[],"scene":7,"participant":{}}}\n', "its hash"),
    ],
)
def test_whatever_is_in_a_log_the_list_goes_on(
    tmp_path: Path, content: bytes, problem: str
) -> None:
    bad = tmp_path / "bad"
    bad.mkdir()
    (bad / LOG_NAME).write_bytes(content)
    good = recorded(tmp_path, "")
    entries = {one.id: one for one in list_sessions(tmp_path)}
    assert set(entries) == {"bad", good.name}
    assert problem in entries["bad"].problem
    assert bool(entries["bad"].problem) == bool(problem)


def test_what_is_no_session_is_not_listed(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    (tmp_path / "empty").mkdir()
    pipe = tmp_path / "pipe"
    pipe.mkdir()
    os.mkfifo(pipe / LOG_NAME)
    (one,) = list_sessions(tmp_path)
    assert (one.id, one.resumable) == ("pipe", False)


def _replaced(lines: list[bytes], at: int) -> list[bytes]:
    return [*lines[:at], lines[at].replace(b'"at":', b'"at":1', 1), *lines[at + 1 :]]


@pytest.mark.parametrize("at", [1, 4, -1])
def test_a_line_changed_anywhere_is_said_with_its_number(tmp_path: Path, at: int) -> None:
    path = recorded(tmp_path, BOIL)
    lines = raw_lines(path)
    (path / LOG_NAME).write_bytes(b"".join(_replaced(lines, at % len(lines))))
    listed = entry(path)
    assert listed.problem.startswith(f"line {at % len(lines) + 1} was changed")
    assert "restore the file from a copy" in listed.advice
    assert not listed.resumable
    assert listed.scene == "kitchen-1", "what can be read is told all the same"


def test_a_line_that_was_lost_is_said(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    lines = raw_lines(path)
    (path / LOG_NAME).write_bytes(b"".join([*lines[:5], *lines[6:]]))
    assert "line 6 is event 6 where event 5 should stand" in entry(path).problem


def test_a_session_is_found_by_name_and_only_in_its_folder(tmp_path: Path) -> None:
    folder = tmp_path / "sessions"
    path = recorded(folder, "")
    assert find_session(folder, path.name) == path
    with pytest.raises(NotASessionError):
        find_session(folder, "20300101-000000-nosuchone")
    outside = recorded(tmp_path, "")
    for name in (f"../{outside.name}", str(outside), ".", ""):
        with pytest.raises(UnsafeNameError):
            find_session(folder, name)
    (folder / "link").symlink_to(outside)
    with pytest.raises(UnsafeNameError, match="link"):
        find_session(folder, "link")


def test_listing_loads_nothing_heavy() -> None:
    program = (
        "import sys; from verbteach_sessions import catalogue, script;"
        "heavy = {'numpy', 'pddl', 'textual', 'platformdirs', 'asyncio', 'importlib.metadata'};"
        "print(sorted(heavy & set(sys.modules)))"
    )
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert run.stdout.strip() == "[]"


def nobody(uid: int) -> NoReturn:
    raise KeyError(uid)


def test_without_a_home_directory_a_folder_must_be_named(monkeypatch: pytest.MonkeyPatch) -> None:
    for named in ("VERBTEACH_SESSIONS", "VERBTEACH_DATA", "XDG_DATA_HOME", "HOME"):
        monkeypatch.delenv(named, raising=False)
    monkeypatch.setattr("pwd.getpwuid", nobody)
    with pytest.raises(NoHomeError, match="--sessions"):
        default_folder()
    monkeypatch.setenv("VERBTEACH_SESSIONS", "~/kept")
    with pytest.raises(NoHomeError):
        default_folder()


def test_the_default_folder_can_be_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("VERBTEACH_SESSIONS", "~/lessons")
    assert default_folder() == Path.home() / "lessons"
    monkeypatch.setenv("VERBTEACH_SESSIONS", "")
    monkeypatch.setenv("VERBTEACH_DATA", "~/kept")
    assert default_folder() == Path.home() / "kept" / "sessions"
    monkeypatch.delenv("VERBTEACH_DATA")
    assert default_folder().parts[-2:] == ("verbteach", "sessions")


def test_the_state_after_every_turn_is_in_the_record(tmp_path: Path) -> None:
    events = read_events(recorded(tmp_path, BOIL + "undo\nredo\n"))
    moving = [event for event in events if event["type"] in ("robot", "undo", "redo")]
    assert all("after" in event["data"] for event in moving)
