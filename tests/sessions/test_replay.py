"""Replaying a record, and naming the first thing that recomputing gives otherwise."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.sessions.records import first, forge, raw_lines, read_events
from tests.sessions.rooms import BOIL, TAUGHT, recorded, resumed, settings
from verbteach.dialogue.setting import Setting, UnknownSceneError
from verbteach_sessions.errors import DamagedLogError, LogError, NewerLogError
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.replay import replay, verify

Change = Callable[[list[dict[str, Any]]], object]


@pytest.fixture(scope="module")
def original(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    path = recorded(tmp_path_factory.mktemp("once"), TAUGHT + "good\nundo\nredo\n")
    return (path / LOG_NAME).read_bytes()


@pytest.fixture
def path(original: bytes, tmp_path: Path) -> Path:
    (tmp_path / LOG_NAME).write_bytes(original)
    return tmp_path


def test_an_untouched_record_verifies(path: Path) -> None:
    verification = verify(path, settings)
    assert verification.verified
    assert verification.events == len(raw_lines(path))
    printed = verification.to_json()
    assert json.loads(json.dumps(printed)) == printed
    assert printed["first_difference"] is None
    assert printed["unanswerable"] == 0


def test_verifying_needs_nothing_but_the_log_and_writes_nothing(path: Path) -> None:
    verify(path / LOG_NAME, settings)
    assert [one.name for one in path.iterdir()] == [LOG_NAME]


def robot(events: list[dict[str, Any]]) -> dict[str, Any]:
    data: dict[str, Any] = first(events, "robot", -1)["data"]
    return data


@pytest.mark.parametrize(
    ("change", "field"),
    [
        (lambda e: robot(e)["texts"].__setitem__(0, "No."), "texts[0]"),
        (lambda e: robot(e).__setitem__("reward", 99.0), "reward"),
        (lambda e: robot(e).__setitem__("phase", "learning"), "phase"),
        (lambda e: robot(e)["after"].__setitem__("digest", "0"), "after.digest"),
        (lambda e: robot(e)["after"]["totals"].__setitem__("episodes", 7), "after.totals.episodes"),
        (lambda e: robot(e)["acts"].pop(), "acts"),
        (
            lambda e: first(e, "learned")["data"]["record"]["experience"].clear(),
            "record.experience",
        ),
        (lambda e: first(e, "undo")["data"]["after"].__setitem__("world", "0"), "after.world"),
    ],
)
def test_a_forged_value_is_named_by_event_and_field(path: Path, change: Change, field: str) -> None:
    before = read_events(path)
    forge(path, change)
    after = read_events(path)
    changed = next(n for n, (a, b) in enumerate(zip(before, after, strict=True)) if a != b)
    difference = verify(path, settings).first_difference
    assert difference is not None
    assert difference.seq == changed
    assert difference.field == field


def test_a_forged_probability_is_named_to_the_last_digit(path: Path) -> None:
    events = read_events(path)
    chosen = next(e for e in events if e["type"] == "robot" and e["data"]["trace"])
    feature = sorted(chosen["data"]["decisions"][-1]["candidates"][0]["features"])[0]

    def change(forged: list[dict[str, Any]]) -> None:
        features = forged[chosen["seq"]]["data"]["decisions"][-1]["candidates"][0]["features"]
        features[feature] += 1e-15 + abs(features[feature]) * 1e-15

    forge(path, change)
    difference = verify(path, settings).first_difference
    assert difference is not None
    assert difference.seq == chosen["seq"]
    assert difference.field.endswith(f"candidates[0].features.{feature}")


def test_a_forged_act_of_the_teacher_shows_in_the_reply(path: Path) -> None:
    def change(events: list[dict[str, Any]]) -> None:
        first(events, "teacher", -1)["data"]["act"] = {"act": "bad"}

    forge(path, change)
    difference = verify(path, settings).first_difference
    assert difference is not None
    assert difference.seq == first(read_events(path), "teacher", -1)["seq"] + 2


def test_an_act_that_does_not_fit_is_a_difference_and_no_crash(path: Path) -> None:
    def change(events: list[dict[str, Any]]) -> None:
        first(events, "teacher", -1)["data"]["act"] = {"act": "done"}

    forge(path, change)
    difference = verify(path, settings).first_difference
    assert difference is not None
    assert "IllegalMoveError" in difference.recomputed


def test_an_edited_line_is_not_verified(path: Path) -> None:
    lines = raw_lines(path)
    lines[5] = lines[5].replace(b"Kettle_1", b"Kettle_2", 1)
    (path / LOG_NAME).write_bytes(b"".join(lines))
    verification = verify(path, settings)
    assert not verification.verified
    difference = verification.first_difference
    assert difference is not None
    assert (difference.seq, difference.field) == (5, "line")
    assert "line 6 was changed" in difference.recorded


@pytest.mark.parametrize("line", [1, 5])
def test_a_line_cut_in_the_middle_of_the_record_is_not_verified(path: Path, line: int) -> None:
    lines = raw_lines(path)
    lines[line] = lines[line][:50] + b"\n"
    (path / LOG_NAME).write_bytes(b"".join(lines))
    difference = verify(path, settings).first_difference
    assert difference is not None
    assert f"line {line + 1} is not JSON" in difference.recorded


def test_a_file_that_is_no_log_is_refused(tmp_path: Path) -> None:
    (tmp_path / LOG_NAME).write_text("Dear diary,\ntoday I taught a robot.\n")
    with pytest.raises(LogError, match="line 1: is not JSON"):
        verify(tmp_path, settings)


def test_a_torn_last_line_is_a_warning_only(path: Path) -> None:
    with (path / LOG_NAME).open("ab") as file:
        file.write(b'{"v":1,"seq":')
    verification = verify(path, settings)
    assert verification.verified
    (warning,) = verification.warnings
    assert "not written to its end" in warning


def test_other_versions_are_a_warning(path: Path) -> None:
    def change(events: list[dict[str, Any]]) -> None:
        events[0]["data"]["software"]["numpy"] = "0.9"

    forge(path, change)
    verification = verify(path, settings)
    assert verification.verified
    assert [one for one in verification.warnings if "numpy 0.9" in one]


def test_a_newer_record_is_refused(path: Path) -> None:
    (path / LOG_NAME).write_bytes(b'{"v":3}\n')
    with pytest.raises(NewerLogError):
        verify(path, settings)


def test_a_scene_that_is_not_there_is_said(path: Path) -> None:
    def nowhere(scene: str) -> Setting:
        raise UnknownSceneError(f"there is no scene {scene!r}")

    with pytest.raises(UnknownSceneError):
        verify(path, nowhere)


def test_frames_carry_the_state_that_each_event_led_to(path: Path) -> None:
    frames = list(replay(path, settings))
    assert [frame.event.seq for frame in frames] == list(range(len(raw_lines(path))))
    for frame in frames:
        after = frame.event.data.get("after")
        if after is not None:
            assert frame.state is not None
            assert frame.state.digest == after["digest"]


def test_a_replay_stops_with_the_event_that_was_asked_for(path: Path) -> None:
    frames = list(replay(path, settings, to=6))
    assert [frame.event.seq for frame in frames] == list(range(7))


def test_what_stands_before_the_damage_can_be_shown(path: Path) -> None:
    lines = raw_lines(path)
    lines[5] = b"{}\n"
    (path / LOG_NAME).write_bytes(b"".join(lines))
    with pytest.raises(DamagedLogError, match="replay --to 4"):
        list(replay(path, settings))
    assert len(list(replay(path, settings, to=4))) == 5


def test_after_a_difference_the_record_is_shown_without_states(path: Path) -> None:
    forge(path, lambda events: first(events, "robot", 1)["data"].__setitem__("reward", 5.0))
    seq = first(read_events(path), "robot", 1)["seq"]
    frames = list(replay(path, settings))
    assert all(frame.state is not None for frame in frames[1:seq])
    assert all(frame.state is None for frame in frames[seq:])
    assert frames[seq].event.data["reward"] == 5.0


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda e: e[2].__setitem__("type", "oracle"), "no event type 'oracle'"),
        (lambda e: e[2]["data"].__setitem__("act", "yes"), "teacher.act: is no object"),
        (lambda e: e[2]["data"].__setitem__("act", {"act": "shrug"}), "unknown act 'shrug'"),
        (lambda e: e[3]["data"].__delitem__("texts"), "robot.texts: is missing"),
        (lambda e: e[3]["data"].__setitem__("mood", 1), "robot.mood: is unknown"),
        (lambda e: e[3]["data"].__setitem__("reply_to", 1), "does not reply to event 2"),
        (lambda e: e.pop(3), "nothing was said|still waits"),
        (lambda e: e.insert(3, e[2]), "still waits for the robot"),
        (lambda e: e.insert(1, e[0]), "only one"),
        (lambda e: e.pop(0), "begins with its header"),
    ],
)
def test_a_record_out_of_order_is_refused_with_its_line(
    path: Path, change: Change, reason: str
) -> None:
    forge(path, change)
    with pytest.raises(LogError, match=reason) as refused:
        verify(path, settings)
    assert f"{LOG_NAME}, line" in str(refused.value)


def test_nothing_nested_beyond_measure_is_walked(path: Path) -> None:
    def bury(events: list[dict[str, Any]]) -> None:
        study: dict[str, Any] = {}
        for _ in range(500):
            study = {"deeper": study}
        events[0]["data"]["study"] = study

    forge(path, bury)
    with pytest.raises(LogError, match="study: is nested deeper"):
        verify(path, settings)
    with pytest.raises(LogError, match="study: is nested deeper"):
        resumed(path)


def test_a_session_verifies_from_any_folder(original: bytes, tmp_path: Path) -> None:
    moved = tmp_path / "elsewhere" / "renamed"
    moved.mkdir(parents=True)
    (moved / LOG_NAME).write_bytes(original)
    assert verify(moved, settings).verified
    assert b"/" not in json.dumps(read_events(moved)[0]["data"]["id"]).encode()
    assert str(tmp_path).encode() not in original


def test_a_short_record_verifies(tmp_path: Path) -> None:
    assert verify(recorded(tmp_path, BOIL), settings).verified
