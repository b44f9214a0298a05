"""What can be done with a session's record: list, show, validate, replay, branch."""

from __future__ import annotations

import shutil
import time
from pathlib import Path

import pytest

from tests.sessions.records import first, forge, raw_lines, write_events
from tests.tui.commandline import assert_refused, here
from verbteach_sessions.eventlog import LOG_NAME


def test_list_has_the_newest_first(kept: Path, tmp_path: Path) -> None:
    assert here("sessions", "list", "--sessions", tmp_path).err != ""
    document = here("sessions", "list", "--sessions", kept.parent, "--json").document
    assert [row["id"] for row in document["sessions"]] == [kept.name]
    assert kept.name in here("sessions", "list", sessions=kept.parent).out


def test_show_tells_what_was_said(kept: Path) -> None:
    document = here("sessions", "show", kept, "--json").document
    said = [(row["speaker"], row["text"]) for row in document["transcript"]]
    assert ("teacher", "fetch the kettle") in said
    assert ("note", "that went well") in said
    assert document["events"] == len(raw_lines(kept))
    assert "fetch the kettle" in here("sessions", "show", kept / LOG_NAME).out


def test_a_folder_of_sessions_is_no_session_and_names_one(kept: Path) -> None:
    for words in (("sessions", "show"), ("replay",), ("sessions", "branch")):
        assert_refused(here(*words, kept.parent), "is a folder of sessions", str(kept))


def test_replay_tells_every_act_in_order_and_stops_where_told(kept: Path) -> None:
    told = here("replay", kept).out
    assert told.index("fetch the kettle") < told.index("moveto Kettle_1") < told.index("went well")
    part = here("replay", kept, "--to", 3).out
    assert told.startswith(part)
    assert "moveto" not in part


def test_replay_at_a_speed_takes_its_time(kept: Path) -> None:
    started = time.monotonic()
    fast = here("replay", kept, "--speed", 1000)
    assert fast.out == here("replay", kept).out
    assert time.monotonic() - started < 10


def test_verify_agrees_with_an_untouched_record(kept: Path) -> None:
    document = here("replay", kept, "--verify", "--json").document
    assert document["verified"] is True
    assert document["first_difference"] is None
    assert document["unanswerable"] == 0
    assert document["events"] == len(raw_lines(kept))


def test_verify_names_the_first_event_that_differs(copy: Path) -> None:
    def change(events: list[dict[str, object]]) -> None:
        first(events, "robot", 2)["data"]["texts"] = ["I see nothing."]

    forge(copy, change)
    ran = here("replay", copy, "--verify", "--json")
    assert ran.status == 1
    assert ran.document["verified"] is False
    assert ran.document["first_difference"]["seq"] == 5
    assert "5" in here("replay", copy, "--verify").out
    assert here("replay", copy, "--verify", "--to", 4).status == 0


def test_a_torn_last_line_is_a_warning(copy: Path) -> None:
    log = copy / LOG_NAME
    log.write_bytes(log.read_bytes()[:-10])
    ran = here("sessions", "validate", copy, "--json")
    assert ran.status == 0
    assert ran.document["valid"] is True
    assert [finding["rule"] for finding in ran.document["warnings"]] == ["torn"]
    verified = here("replay", copy, "--verify")
    assert verified.status == 0
    assert "warning" in verified.err


def test_validate_gives_rule_event_and_message_for_what_is_wrong(copy: Path) -> None:
    log = copy / LOG_NAME
    log.write_bytes(log.read_bytes().replace(b"moveto Kettle_1", b"moveto Kettle_2", 1))
    before = log.read_bytes()
    ran = here("sessions", "validate", copy, "--json")
    assert ran.status == 1
    (problem,) = ran.document["problems"]
    assert set(problem) == {"rule", "seq", "message"}
    assert problem["rule"] == "hash"
    assert log.read_bytes() == before


def test_validate_takes_a_whole_folder(copy: Path, kept: Path) -> None:
    shutil.copytree(kept, copy.parent / "another")
    (copy.parent / "no-session").mkdir()
    events = raw_lines(copy)
    (copy / LOG_NAME).write_bytes(b"".join(events[:2] + events[3:]))
    ran = here("sessions", "validate", copy.parent, "--json")
    assert ran.status == 1
    assert ran.document["valid"] is False
    assert [one["valid"] for one in ran.document["sessions"]] == [False, True]
    assert {problem["session"] for problem in ran.document["problems"]} == {str(copy)}


def test_a_record_of_a_newer_version_is_refused_kindly(copy: Path) -> None:
    log = copy / LOG_NAME
    log.write_bytes(log.read_bytes().replace(b'"v":2', b'"v":99'))
    assert_refused(here("replay", copy), "version", "update")
    assert here("sessions", "validate", copy).status == 1


@pytest.mark.parametrize(
    "words",
    [
        ("replay", "none"),
        ("replay", "none", "--verify"),
        ("sessions", "show", "none"),
        ("sessions", "validate", "none"),
        ("sessions", "list", "--sessions", "none"),
        ("teach", "--teacher", "-", "--resume", "none"),
    ],
)
def test_what_is_not_there_is_one_line(words: tuple[str, ...], tmp_path: Path) -> None:
    named = [str(tmp_path / word) if word == "none" else word for word in words]
    assert_refused(here(*named), "none")


def test_an_empty_log_is_no_session(copy: Path) -> None:
    write_events(copy, [])
    assert_refused(here("replay", copy), "no event")
    assert here("sessions", "validate", copy).status == 1


def test_a_branch_is_made_beside_its_parent_and_goes_on(copy: Path) -> None:
    before = (copy / LOG_NAME).read_bytes()
    made = here("sessions", "branch", copy, "--at", 3, "--json").document
    assert (copy / LOG_NAME).read_bytes() == before
    path = Path(made["session"])
    assert path.parent == copy.parent
    assert made["parent"]["id"] == copy.name
    assert made["events"] == made["parent"]["seq"] + 1 == 4
    prefix = here("replay", copy, "--to", 3, "--json").document
    whole = here("replay", path, "--verify", "--json")
    assert whole.status == 0
    assert whole.document["content_hash"] == prefix["content_hash"] == made["content_hash"]
    on = here("teach", "--teacher", "-", "--resume", path, "--json", typed="skip\n")
    assert on.status == 0, on
    assert here("sessions", "validate", path, "--json").document["valid"]


def test_there_is_no_branch_from_an_event_that_is_not_there(copy: Path) -> None:
    ran = here("sessions", "branch", copy, "--at", 9999)
    assert_refused(ran)
    assert "9999" in ran.err
    assert [one.name for one in copy.parent.iterdir()] == [copy.name]


def test_replay_under_another_policy_prints_its_document(copy: Path) -> None:
    same = here("replay", copy, "--policy", "she16", "--json")
    assert same.status == 0, same
    document = same.document
    assert (document["verified"], document["unanswerable"]) == (True, 0)
    assert document["first_difference"] is None
    recorded = here("replay", copy, "--json").document
    assert document["content_hash"] == recorded["content_hash"]
    assert document["events"] == recorded["events"]
    other = here("replay", copy, "--policy", "random", "--json")
    assert other.status == 0
    assert isinstance(other.document["unanswerable"], int)
    assert "under random" in here("replay", copy, "--policy", "random").out
    assert_refused(here("replay", copy, "--policy", "clairvoyant"))
    assert_refused(here("replay", copy, "--policy", "split", "--verify"))
