"""Letting scripts teach: in order, to the end, naming the line that does not fit."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.sessions.records import read_events
from tests.sessions.rooms import BOIL, TAUGHT, begin, say
from verbteach_sessions.driving import ScriptTeacher, drive
from verbteach_sessions.errors import ScriptError


def test_a_script_is_said_in_order_and_recorded_as_it_stands(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "# to begin with\n\n  command: boil the water  \n do: moveto Kettle_1 # go\n")
        said = [e["data"] for e in read_events(session.path) if e["type"] == "teacher"]
        assert [one["raw"] for one in said] == [
            "command: boil the water",
            "do: moveto Kettle_1 # go",
        ]
        assert {one["via"] for one in said} == {"script"}


def test_whoever_listens_hears_every_turn_once(tmp_path: Path) -> None:
    heard: list[tuple[str, ...]] = []
    with begin(tmp_path) as session:
        lines = ["command: boil the water", "why", "do: moveto Kettle_1"]
        drive(session, ScriptTeacher(lines), lambda one: heard.append(one.said))
        assert len(heard) == 4
        assert heard[0] == (session.transcript()[0].text,)
        assert heard[2] == tuple(x.text for x in session.transcript() if x.kind == "why")[1:]
        assert heard[-1] == session.turn.texts


@pytest.mark.parametrize(
    ("script", "line", "reason"),
    [
        ("yes\n", 1, "waits for a command"),
        (BOIL + "\n# done\nhello robot\n", 12, "waits for a command"),
        (BOIL + "scene: the-moon\n", 10, "the-moon"),
        ("command: boil the water\nobject: Kettle_1\n", 2, "waits to be shown"),
        ("undo\n", 1, "nothing to take back"),
        (BOIL + "redo\n", 10, "nothing to do again"),
        ("command: boil the water\ndo:\n", 2, "cannot be read"),
        ("command: wash the glorp\nobject: Nothing_1\n", 2, "Nothing_1"),
        ("command: boil the water\nstrike: (((\n", 2, "cannot be read"),
    ],
)
def test_a_line_that_does_not_fit_is_named_and_what_was_said_before_is_kept(
    tmp_path: Path, script: str, line: int, reason: str
) -> None:
    with begin(tmp_path) as session:
        with pytest.raises(ScriptError, match=f"line {line}: .*{reason}") as refused:
            say(session, script)
        assert refused.value.line == line
        said = [event for event in read_events(session.path) if event["type"] == "teacher"]
        spoken = [text for text in script.splitlines()[: line - 1] if text and text[0] != "#"]
        assert [event["data"]["raw"] for event in said] == spoken


def test_stopping_an_execution_leads_to_a_demonstration(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, TAUGHT + "stop: 3\n")
        assert session.turn.phase.value == "demonstration"
        assert read_events(session.path)[-2]["data"]["act"] == {"act": "stop", "step": 3}


def test_a_script_ends_with_quit_whatever_follows(tmp_path: Path) -> None:
    with begin(tmp_path) as session:
        say(session, "quit\ncommand: boil the water\n")
        assert session.ended
        assert [event["type"] for event in read_events(session.path)][-1] == "end"


def test_lines_are_read_when_they_are_needed(tmp_path: Path) -> None:
    read: list[str] = []

    def pipe() -> Iterator[str]:
        for line in ("command: boil the water\n", "skip\n"):
            assert len([e for e in read_events(session.path) if e["type"] == "teacher"]) == len(
                read
            )
            read.append(line)
            yield line

    with begin(tmp_path) as session:
        drive(session, ScriptTeacher(pipe()))
    assert len(read) == 2


HASHED = """
import sys
from pathlib import Path
from tests.sessions.rooms import begin, say
with begin(Path(sys.argv[1])) as session:
    print(say(session, sys.argv[2]).content_hash)
"""


@pytest.mark.slow
def test_the_order_of_hashing_does_not_reach_the_record(tmp_path: Path) -> None:
    hashes = {
        subprocess.run(
            [sys.executable, "-c", HASHED, str(tmp_path), TAUGHT + "bad\nskip\nwhy\nundo\n"],
            env={"PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("0", "1", "77")
    }
    assert len(hashes) == 1
