"""The examples in the commands' help, typed as they stand there, on the files that they name."""

from __future__ import annotations

import shlex
import shutil
from importlib.resources import as_file, files
from pathlib import Path

import pytest

from tests.tui.commandline import here
from verbteach_tui.commands.examples import EXAMPLES
from verbteach_tui.conclusion import CHECK_FAILED, DONE

SESSION = "20260101-120000-abcdefgh"
CODE = "k7m2xq9fhd"
TAUGHT = "open the fridge\ngo to the fridge\nopen the fridge\ndone\nyes\nnote: I am Anna Blume\n"
SCRIPT = "command: open the fridge\nskip\nquit\n"

LONG = ("bench", "benchmark", "evaluate", "reproduce", "serve", "train")
"""What takes minutes, waits for somebody, or needs a corpus that is not here."""

TESTED_ELSEWHERE = ("sessions example", "lessons check", "teach --teacher simulated")

FIND_FAULT = {"release", "scan", "evaluate-policy"}
"""Checks that have something to say about the few sessions there are."""


def typed() -> list[list[str]]:
    """The examples as words; what deletes the sessions last."""
    lines = dict.fromkeys(line.partition(" ")[2] for lines in EXAMPLES.values() for line in lines)
    kept = [
        shlex.split(line)
        for line in lines
        if line and not line.startswith((*LONG, *TESTED_ELSEWHERE, "study new"))
    ]
    return sorted(kept, key=lambda words: "withdraw" in words)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where everything lies that the examples name."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("VERBTEACH_SESSIONS", str(tmp_path / "mine"))
    begun = ("teach", "--plain", "--sessions", "my-sessions", "--participant", CODE)
    assert here(*begun, typed=TAUGHT).status == DONE
    (session,) = Path("my-sessions").iterdir()
    session.rename(session.parent / SESSION)
    assert here(*shlex.split(EXAMPLES["verbteach study new"][0])[1:]).status == DONE
    Path("lesson.txt").write_text(SCRIPT, "utf-8")
    Path("names.txt").write_text("Anna Blume\n", "utf-8")
    with as_file(files("verbteach_scenarios") / "data") as data:
        shutil.copytree(data / "household", "my-scenes")
        shutil.copy(data / "weights" / "starting.json", "weights.json")
    Path("my-lessons").mkdir()
    lessons = Path("my-scenes/lessons.jsonl").read_text("utf-8").splitlines(keepends=True)[:3]
    Path("my-lessons/lessons.jsonl").write_text("".join(lessons), "utf-8")
    assert here("sessions", "split", "my-sessions", "--out", "splits.json").status == DONE
    return tmp_path


def test_the_examples_in_the_help_can_be_typed(folder: Path) -> None:
    tried = 0
    for words in typed():
        if "--check" in words:  # of a fit: wants more people
            continue
        if "withdraw" in words and "--yes" not in words:  # asks on a terminal
            continue
        if "--out" in words:
            out = Path(words[words.index("--out") + 1])
            shutil.rmtree(out) if out.is_dir() else out.unlink(missing_ok=True)
        said = "yes\nquit\n" if "--study" in words else ""
        done = here(*words, typed=said)
        allowed = {DONE, CHECK_FAILED} if FIND_FAULT & {*words} else {DONE}
        assert done.status in allowed, f"{shlex.join(words)}\n{done.out[-500:]}\n{done.err}"
        tried += 1
    assert tried > 40
    assert not Path("my-sessions", SESSION).exists()
