"""Checkpoints are a cache: they make opening fast, and nothing ever depends on them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import fields, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from tests.sessions.records import raw_lines, read_events
from tests.sessions.rooms import (
    BOIL,
    TAUGHT,
    Clock,
    babble,
    begin,
    recorded,
    resumed,
    say,
    settings,
)
from verbteach.dialogue.robot import Robot
from verbteach.dialogue.setting import Setting
from verbteach_sessions import checkpoints, fold
from verbteach_sessions.checkpoints import CHECKPOINT_NAME
from verbteach_sessions.content import ContentHash
from verbteach_sessions.errors import CannotUndoError, LogError
from verbteach_sessions.eventlog import LOG_NAME, LogReader
from verbteach_sessions.header import Machine
from verbteach_sessions.history import Node
from verbteach_sessions.places import DATA_VARIABLE
from verbteach_sessions.replay import replay, verify
from verbteach_sessions.session import Session
from verbteach_sessions.session_acts import Redo, Undo
from verbteach_sessions.state_codec import state_from_plain

some = hypothesis_settings(max_examples=8, deadline=None)
LONG = TAUGHT + "bad\ndo: moveto Kettle_1\nundo\nnote: so\n"


@pytest.fixture(autouse=True)
def _often() -> Iterator[None]:
    """A checkpoint every few turns, so that short sessions have several."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(checkpoints, "EVERY", 4)
        patched.setattr(fold, "EVERY", 4)
        patched.setattr(fold, "RECENT", 6)
        yield


@pytest.fixture
def no_robot(monkeypatch: pytest.MonkeyPatch) -> None:
    def unable(*_: object) -> None:
        raise AssertionError("the robot was asked to compute")

    monkeypatch.setattr(Robot, "receive", unable)
    monkeypatch.setattr(Robot, "open", unable)


def shown(node: Node) -> tuple[object, ...]:
    """All of a turn but the one before it, of which only the number."""
    parent = None if node.parent is None else node.parent.seq
    record = None if node.record is None else dict(node.record)
    named = {f.name: getattr(node, f.name) for f in fields(node)}
    return tuple({**named, "parent": parent, "record": record}.values())


def everything(session: Session) -> tuple[object, ...]:
    """All that a session carries, down to the parts that no digest covers."""
    history = session._fold.history
    return (
        session.robot.state,
        session.transcript(),
        session.content_hash,
        [shown(node) for node in session.turns()],
        [node.seq for node in history.redoable],
        [(turn.node.seq, turn.learned) for turn in session._fold.turns],
        session.ended,
    )


def cold(path: Path) -> Session:
    """Opened without checkpoints."""
    (path / CHECKPOINT_NAME).unlink(missing_ok=True)
    return resumed(path)


def test_a_session_opens_from_a_checkpoint_without_being_held_again(
    tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    with begin(tmp_path) as session:
        say(session, LONG)
        live = everything(session)
    request.getfixturevalue("no_robot")
    with resumed(session.path) as again:
        assert everything(again) == live
        assert again.recovered == ()


def test_after_a_crash_only_what_followed_the_checkpoint_is_recomputed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = begin(tmp_path)
    say(session, LONG)
    live, kept = everything(session), (session.path / CHECKPOINT_NAME).read_bytes()
    session.close()
    (session.path / CHECKPOINT_NAME).write_bytes(kept)  # as if the process had died before
    received: list[str] = []
    monkeypatch.setattr(Robot, "receive", _told(Robot.receive, received))
    with resumed(session.path) as again:
        assert everything(again) == live
        assert 0 < len(received) < fold.EVERY


@some
@given(st.integers(0, 2**32 - 1), st.integers(1, 40))
def test_a_session_reopened_anywhere_is_the_one_never_closed(seed: int, first: int) -> None:
    with TemporaryDirectory() as folder:
        with begin(Path(folder)) as session:
            say(session, BOIL)
            babble(session, seed, first)
            live = everything(session)
        with resumed(session.path) as again:
            assert everything(again) == live
            babble(again, seed + 1, 10)
            longer = everything(again)
        with cold(session.path) as recomputed:
            assert everything(recomputed) == longer
        assert verify(session.path, settings).content_hash == longer[2]


def test_undo_goes_back_past_what_a_checkpoint_holds(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, TAUGHT + "good\n")
    states = {f.event.seq: f.state for f in replay(session.path, settings)}
    with resumed(session.path) as again:
        assert len(again._fold.states) < len(again.turns())
        while again.can_undo:
            again.perform(Undo())
            assert again.robot.state == states[again.turns()[-1].seq]
        while again.can_redo:
            again.perform(Redo())
        assert again.robot.state.digest == session.robot.state.digest
    with resumed(session.path) as third:
        third.perform(Undo(turns=len(third.turns()) - 1))
        assert third.robot.state == states[1]
    assert verify(session.path, settings).verified


def test_undo_in_the_part_after_the_checkpoint_leads_before_it(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, BOIL)
        kept = (session.path / CHECKPOINT_NAME).read_bytes()
        say(session, "undo\nundo\nundo\nundo\nundo\ndone\n")
        live = everything(session)
    (session.path / CHECKPOINT_NAME).write_bytes(kept)
    with resumed(session.path) as again:
        assert everything(again) == live
        assert again.recovered == ()


def test_a_turn_that_cannot_be_recomputed_cannot_be_gone_back_to(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = recorded(tmp_path, TAUGHT)

    def mute(robot: Robot, act: object) -> None:
        robot.state = replace(robot.state, suggested="other words")

    with resumed(path) as session:
        lines, state = raw_lines(path), session.robot.state
        monkeypatch.setattr(Robot, "receive", mute)
        with pytest.raises(CannotUndoError, match="something else than was recorded"):
            session.perform(Undo(turns=3))
        assert raw_lines(path) == lines
        assert session.robot.state is state


@pytest.mark.parametrize("where", np.linspace(0, 0.999, 7).tolist())
def test_checkpoints_that_were_changed_or_cut_are_not_used(tmp_path: Path, where: float) -> None:
    path = recorded(tmp_path, LONG)
    right, file = everything_of(path), path / CHECKPOINT_NAME
    kept = file.read_bytes()
    at = int(where * len(kept))
    for wrong in (kept[:at], kept[:at] + bytes([kept[at] ^ 1]) + kept[at + 1 :]):
        file.write_bytes(wrong)
        assert everything_of(path) == right
        assert file.read_bytes() != wrong, "made anew"


def everything_of(path: Path) -> tuple[object, ...]:
    with resumed(path) as session:
        return everything(session)


def test_checkpoints_by_another_person_are_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = recorded(tmp_path / "sessions", LONG)
    right = everything_of(path)
    monkeypatch.setenv(DATA_VARIABLE, str(tmp_path / "elsewhere"))
    read: list[str] = []
    monkeypatch.setattr(checkpoints, "state_from_plain", _told(state_from_plain, read))
    assert everything_of(path) == right
    assert read == []
    assert everything_of(path) == right
    assert len(read) == 1


def test_without_a_place_for_a_key_there_are_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv(DATA_VARIABLE, str(tmp_path / "file"))
    path = recorded(tmp_path / "sessions", LONG)
    assert not (path / CHECKPOINT_NAME).exists()
    assert everything_of(path)


def test_another_program_recomputes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = recorded(tmp_path, LONG)
    machine = replace(Machine.here("script"), python="3.99.0")
    opened: list[str] = []
    monkeypatch.setattr(Robot, "open", _told(Robot.open, opened))
    Session.resume(path, settings, clock=Clock()).close()
    assert opened == []
    Session.resume(path, settings, machine=machine, clock=Clock()).close()
    assert opened


def _told(function: Callable[..., object], heard: list[str]) -> Callable[..., object]:
    def told(*given: object) -> object:
        heard.append("called")
        return function(*given)

    return told


def test_a_scene_that_was_changed_is_found(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)

    def changed(scene_id: str) -> Setting:
        setting = settings(scene_id)
        initial = setting.scene.initial - {min(setting.scene.initial)}
        return replace(setting, scene=replace(setting.scene, initial=initial))

    with Session.resume(path, changed, clock=Clock()) as session:
        assert session.recovered, "the session is rebuilt from its record"
        assert session.robot.state.world == changed("kitchen-1").scene.initial


def test_a_log_that_was_changed_is_found_in_spite_of_its_checkpoints(tmp_path: Path) -> None:
    path = recorded(tmp_path, LONG)
    whole = (path / LOG_NAME).read_bytes()
    for place in range(200, len(whole), len(whole) // 9):
        changed = whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :]
        (path / LOG_NAME).write_bytes(changed)
        with pytest.raises(LogError):
            resumed(path)
    (path / LOG_NAME).write_bytes(whole)
    resumed(path).close()


def test_a_log_that_was_cut_back_behind_its_checkpoint_is_recomputed(tmp_path: Path) -> None:
    path = recorded(tmp_path, LONG)
    lines = raw_lines(path)
    robot = [n for n, event in enumerate(read_events(path)) if event["type"] == "robot"][3]
    (path / LOG_NAME).write_bytes(b"".join(lines[: robot + 1]))
    with resumed(path) as session:
        assert session.turns()[-1].seq == robot
    assert verify(path, settings).verified


def test_checkpoints_are_private_and_a_full_disk_costs_only_them(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    assert (path / CHECKPOINT_NAME).stat().st_mode & 0o777 == 0o600
    (path / CHECKPOINT_NAME).unlink()
    (path / CHECKPOINT_NAME).mkdir()
    with resumed(path) as session:
        say(session, "scene: kitchen-3\ncommand: boil the water\ngood\n")
        live = everything(session)
    (path / CHECKPOINT_NAME).rmdir()
    assert everything_of(path)[0] == live[0]


def test_the_content_hash_goes_on_from_a_checkpoint(tmp_path: Path) -> None:
    path = recorded(tmp_path, LONG)
    with resumed(path) as session:
        say(session, "note: more\n")
        content = ContentHash()
        for event in LogReader(path):
            content.add(event)
        assert session.content_hash == content.hexdigest


def test_no_more_states_are_held_than_are_needed(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "command: sing\nskip\n" * 10)
        held = session._fold.states
        assert len(held) <= 6 + 20 // 4 + 1
        first = session.turns()[0]
        assert session.state_after(first) is None
        session.perform(Undo(turns=20))
        assert session.robot.state.digest == first.after["digest"]
        session.perform(Redo(turns=20))
    assert verify(session.path, settings).verified
    assert everything_of(session.path)[0] == session.robot.state
