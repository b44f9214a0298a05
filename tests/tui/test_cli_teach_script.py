"""`teach` by a script: what it prints, what it refuses, and that nothing said is lost."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.sessions.records import raw_lines
from tests.tui.commandline import assert_refused, here, process
from tests.tui.scripted import SCRIPT, taught
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.session import Session
from verbteach_tui.conclusion import INTERRUPTED

SUMMARY = {"session", "episodes", "successes", "questions", "verbs_learned", "reward"}


def test_teach_prints_its_summary_and_nothing_else(tmp_path: Path) -> None:
    ran = taught(SCRIPT, tmp_path)
    assert set(ran.document) >= SUMMARY
    assert ran.document["verbs_learned"] == ["fetch"]
    assert ran.document["episodes"] == 1
    assert Path(ran.document["session"]).parent == tmp_path
    assert ran.err == ""


def test_without_json_the_dialogue_is_told(tmp_path: Path) -> None:
    script = tmp_path / "lesson.txt"
    script.write_text(SCRIPT, "utf-8")
    ran = here("teach", "--teacher", script, "--scene", "kitchen-1", "--sessions", tmp_path / "s")
    assert ran.status == 0
    assert "You: command: fetch the kettle" in ran.out
    assert ran.out.count("Robot: ") >= 5
    assert "verbs learned" in ran.out


def test_one_script_gives_one_content_hash(kept: Path, tmp_path: Path) -> None:
    again = taught(SCRIPT, tmp_path).document["content_hash"]
    assert again == here("replay", kept, "--json").document["content_hash"]
    other = taught(SCRIPT.replace("Kettle_1", "Mug_1"), tmp_path).document["content_hash"]
    assert other != again


@pytest.mark.parametrize(
    ("script", "line", "said"),
    [
        ("nonsense", 1, "does not fit"),
        ("# a remark\n\ncommand: fetch the kettle\ngood\n", 4, "does not fit"),
        ("command: fetch the kettle\nobject: two words\n", 2, "one name"),
        ("command: fetch the kettle\ndo:\n", 2, "do:"),
        ("scene: nowhere\n", 1, "nowhere"),
        ("undo\n", 1, "nothing to take back"),
    ],
)
def test_a_line_that_does_not_fit_is_named_and_what_was_said_is_kept(
    tmp_path: Path, script: str, line: int, said: str
) -> None:
    ran = taught(script, tmp_path)
    assert_refused(ran, f"line {line}", said)
    (session,) = tmp_path.iterdir()
    assert str(session) in ran.err
    valid = here("sessions", "validate", session, "--json")
    assert valid.status == 0, valid
    said_before = [text for text in script.splitlines()[: line - 1] if text.startswith("command")]
    shown = here("sessions", "show", session, "--json").document["transcript"]
    assert sum(row["kind"] == "command" for row in shown) == len(said_before)


def test_a_script_that_is_not_text_is_refused_by_its_line(tmp_path: Path) -> None:
    script = tmp_path / "lesson.txt"
    script.write_bytes(b"command: fetch the kettle\n\xff\xfe\x00\n")
    ran = here("teach", "--teacher", script, "--sessions", tmp_path / "s")
    assert ran.status == 2
    assert "line 2: is not UTF-8" in ran.err


def test_a_missing_script_leaves_no_session(tmp_path: Path) -> None:
    assert_refused(
        here("teach", "--teacher", tmp_path / "none.txt", "--sessions", tmp_path / "s"), "none.txt"
    )
    assert not (tmp_path / "s").exists()


@pytest.mark.parametrize(
    ("option", "value", "said"),
    [
        ("--scene", "kitchn-1", "kitchen-1"),
        ("--policy", "poetic", "poetic"),
        ("--noise", "std4", "std3"),
        ("--noise-reading", "poetic", "phantom"),
        ("--seed", "-1", "--seed"),
        ("--seed", "one", "--seed"),
        ("--participant", "../me", "participant code"),
        ("--from", "no-session", "no-session"),
        ("--lessons", "3", "--teacher simulated"),
    ],
)
def test_wrong_use_is_one_line_and_leaves_no_session(
    tmp_path: Path, option: str, value: str, said: str
) -> None:
    words = ("teach", "--teacher", "-", "--sessions", tmp_path / "s", option, value)
    assert_refused(here(*words), said)
    assert not (tmp_path / "s").exists()


def test_extreme_commands_are_answered_and_kept(tmp_path: Path) -> None:
    extreme = ["", "x" * 10_000, "水を沸かして", "\x1b[31mred\x07", "put it " * 500]
    script = "".join(f"command: {text}\n" for text in extreme)
    ran = taught(script, tmp_path)
    # Some of these may read as a command for a verb not known yet; then the next does not fit.
    assert ran.status in (0, 2)
    assert "Traceback" not in ran.err
    (session,) = tmp_path.iterdir()
    assert here("replay", session, "--verify").status == 0
    assert "\x1b" not in here("sessions", "show", session).out


def test_resume_goes_on_where_it_was(tmp_path: Path) -> None:
    lines = SCRIPT.strip().splitlines()
    path = Path(taught("\n".join(lines[:3]), tmp_path).document["session"])
    rest = "\n".join(lines[3:])
    words = ("teach", "--teacher", "-", "--resume", path, "--json")
    ran = here(*words, typed=rest)
    assert ran.status == 0, ran
    assert ran.document["verbs_learned"] == ["fetch"]
    assert ran.document["session"] == str(path)
    assert ran.document["content_hash"] == taught(SCRIPT, tmp_path).document["content_hash"]


def test_resume_takes_no_option_that_the_session_began_with(kept: Path) -> None:
    assert_refused(here("teach", "--resume", kept, "--seed", 3), "--resume", "--seed")


def test_a_session_in_use_is_refused(copy: Path) -> None:
    words = ("teach", "--teacher", "-", "--resume", copy)
    from verbteach_scenarios.settings import make_settings

    with Session.resume(copy, make_settings()):
        assert_refused(here(*words), str(copy))


def test_another_session_starts_with_what_this_one_taught(kept: Path, tmp_path: Path) -> None:
    document = taught("", tmp_path, "--from", kept).document
    assert document["verbs_learned"] == ["fetch"]
    assert document["episodes"] == 0
    record = here("sessions", "show", document["session"], "--json").document
    assert record["goes_on_from"] == kept.name
    # What it learned before is there to be used: the verb is carried out, not asked about.
    ran = taught("command: fetch the kettle\ngood\n", tmp_path, "--from", kept / LOG_NAME)
    assert ran.document["successes"] == 1


def test_a_read_only_folder_is_one_line(tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("not a folder", "utf-8")
    assert_refused(taught(SCRIPT, blocked), str(blocked))


def test_a_process_of_its_own_behaves_the_same(kept: Path, tmp_path: Path) -> None:
    words = ("teach", "--teacher", "-", "--scene", "kitchen-1", "--json")
    ran = process(*words, typed=SCRIPT, sessions=tmp_path)
    assert ran.status == 0, ran
    ours = here("replay", kept, "--json").document["content_hash"]
    assert ran.document["content_hash"] == ours
    assert_refused(process("replay", tmp_path / "none"), "none")


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGKILL])
def test_whatever_ends_the_process_all_that_was_answered_is_kept(
    tmp_path: Path, sent: signal.Signals
) -> None:
    words = ("teach", "--teacher", "-", "--scene", "kitchen-1", "--sessions", tmp_path, "--json")
    child = subprocess.Popen(
        [sys.executable, "-m", "verbteach_tui", *map(str, words)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=dict(os.environ),
    )
    assert child.stdin is not None
    child.stdin.write("command: fetch the kettle\ndo: moveto Kettle_1\nnote: near it\n")
    child.stdin.flush()
    _wait_for_events(tmp_path, 7)  # what comes before the last one was answered for certain
    child.send_signal(sent)
    try:
        child.wait(timeout=60)  # its standard input stays open: nothing else may end it
        _, err = child.communicate()
    finally:
        child.kill()
    (session,) = tmp_path.iterdir()
    assert "Traceback" not in err
    if sent is signal.SIGINT:
        assert child.returncode == INTERRUPTED
        assert f"--resume {session}" in err
    rest = "do: grasp Kettle_1\ndone\ngood\n"
    ran = here("teach", "--teacher", "-", "--resume", session, "--json", typed=rest)
    assert ran.status == 0, ran.err
    assert ran.document["verbs_learned"] == ["fetch"]
    assert here("replay", session, "--verify").status == 0


def _wait_for_events(folder: Path, count: int) -> None:
    """Until a session in ``folder`` holds ``count`` events."""
    for _ in range(600):
        for session in folder.iterdir():
            if (session / LOG_NAME).exists() and len(raw_lines(session)) >= count:
                return
        time.sleep(0.1)
    raise AssertionError("no such session came")
