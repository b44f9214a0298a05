"""`lessons`, `benchmark` and the simulated teacher."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.scenarios.tell_me_dave_folder import FILLING, REAL, needs_corpus, write_document
from tests.tui.commandline import assert_refused, here
from verbteach_scenarios.lesson_file import lesson_to_data, lesson_to_line
from verbteach_scenarios.lessons import load_lessons

SIMULATED = ("teach", "--teacher", "simulated")
SHORT = 4  # steps: long demonstrations take long to learn from


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only the short ones of the bundled lessons."""
    lessons = [one for one in load_lessons() if len(one.demonstration) <= SHORT]
    monkeypatch.setattr("verbteach_scenarios.lessons.load_lessons", lambda: lessons)


def test_list_has_every_lesson_with_its_words() -> None:
    document = here("lessons", "list", "--json").document
    assert document["lessons"] == [lesson_to_data(lesson) for lesson in load_lessons()]
    assert len(here("lessons", "list").out.splitlines()) == len(load_lessons()) + 1


def own(folder: Path, *changes: tuple[str, str]) -> Path:
    """A person's folder with the first three lessons, their text changed."""
    text = "".join(f"{lesson_to_line(lesson)}\n" for lesson in load_lessons()[:3])
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    (folder / "own.jsonl").write_text(text, "utf-8")
    return folder


def test_check_counts_what_there_is(tmp_path: Path) -> None:
    ran = here("lessons", "check", "--lessons", own(tmp_path), "--json")
    assert ran.status == 0, ran
    assert ran.document["lessons"] == 3
    assert ran.document["problems"] == []
    lengths = [len(lesson.demonstration) for lesson in load_lessons()[:3]]
    assert ran.document["length"]["min"] == min(lengths)
    assert ran.document["length"]["max"] == max(lengths)
    assert "SHE & CHAI" in here("lessons", "check", "--lessons", tmp_path).out


def test_check_names_the_lesson_that_cannot_be_shown(tmp_path: Path) -> None:
    lesson = load_lessons()[0]
    step = json.dumps(str(lesson.demonstration[-1]))
    folder = own(tmp_path, (step, '"moveto Nowhere_9"'))
    ran = here("lessons", "check", "--lessons", folder, "--json")
    assert ran.status == 1
    assert {problem["lesson"] for problem in ran.document["problems"]} == {lesson.id}
    assert ran.document["problems"][0]["line"] == 1
    assert lesson.id in here("lessons", "check", "--lessons", folder).out


def test_a_torn_file_of_lessons_is_named_by_its_line(tmp_path: Path) -> None:
    folder = own(tmp_path)
    text = (folder / "own.jsonl").read_text("utf-8")
    (folder / "own.jsonl").write_text(text[:-20], "utf-8")
    assert_refused(here("lessons", "list", "--lessons", folder), "own.jsonl:3")
    ran = here("lessons", "check", "--lessons", folder, "--json")
    assert ran.status == 1
    assert ran.document["problems"][0]["line"] == 3


@pytest.mark.parametrize("command", ["list", "check"])
def test_a_missing_folder_of_lessons_is_one_line(command: str, tmp_path: Path) -> None:
    assert_refused(here("lessons", command, "--lessons", tmp_path / "none"), "none")


@pytest.mark.usefixtures("short")
def test_the_simulated_teacher_gives_the_lessons_asked_for(tmp_path: Path) -> None:
    words = (*SIMULATED, "--lessons", 3, "--seed", 1, "--sessions", tmp_path, "--json")
    first, second = here(*words), here(*words)
    assert first.status == 0, first
    assert first.document["episodes"] == 3
    assert first.document["verbs_learned"]
    for key in ("content_hash", "verbs_learned", "reward", "questions", "successes"):
        assert first.document[key] == second.document[key]
    valid = here("sessions", "validate", tmp_path, "--json")
    assert valid.status == 0, valid


@pytest.mark.usefixtures("short")
def test_another_seed_is_another_session(tmp_path: Path) -> None:
    words = (*SIMULATED, "--lessons", 2, "--sessions", tmp_path, "--json", "--seed")
    assert here(*words, 1).document["content_hash"] != here(*words, 2).document["content_hash"]


@pytest.mark.usefixtures("short")
def test_a_scene_narrows_the_lessons(tmp_path: Path) -> None:
    words = (*SIMULATED, "--lessons", 2, "--scene", "kitchen-2", "--sessions", tmp_path, "--json")
    session = here(*words).document["session"]
    shown = here("sessions", "show", session, "--json").document
    assert shown["scene"] == "kitchen-2"
    moved = [row["text"] for row in shown["transcript"] if row["kind"] == "scene"]
    assert all("kitchen-2" in text for text in moved)


@pytest.mark.usefixtures("short")
def test_a_resumed_simulation_gives_what_is_left(tmp_path: Path) -> None:
    """Interrupted after the first lesson, it ends as one that never was."""
    whole = (*SIMULATED, "--lessons", 3, "--seed", 4, "--sessions", tmp_path / "a", "--json")
    part = (*SIMULATED, "--lessons", 1, "--seed", 4, "--sessions", tmp_path / "b", "--json")
    session = here(*part).document["session"]
    rest = here(*SIMULATED, "--lessons", 3, "--resume", session, "--json")
    assert rest.document["content_hash"] == here(*whole).document["content_hash"]


def test_ctrl_c_in_a_simulation_says_how_to_go_on(tmp_path: Path) -> None:
    words = (*SIMULATED, "--lessons", 500, "--sessions", tmp_path, "--json")
    child = subprocess.Popen(
        [sys.executable, "-m", "verbteach_tui", *map(str, words)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=dict(os.environ),
    )
    try:
        _wait_for_growth(tmp_path)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=60)
    finally:
        child.kill()
    assert child.returncode == 130, err
    session = json.loads(out)["session"]
    assert f"--resume {session} --teacher simulated --lessons 500" in err
    assert here("sessions", "validate", session).status == 0


def _wait_for_growth(folder: Path) -> None:
    """Until a session in ``folder`` holds more than its long first line: something was said."""
    for _ in range(600):
        if any(log.read_bytes().count(b"\n") > 5 for log in folder.glob("*/events.jsonl")):
            return
        time.sleep(0.1)
    raise AssertionError("no session came")


def test_benchmark_check_reports_on_a_folder(tmp_path: Path) -> None:
    ran = here("benchmark", "check", write_document(tmp_path), "--json")
    assert ran.document["documents"] == 1
    assert ran.document["transitions"] == len(FILLING) - 1
    assert ran.document["instances"] == 2
    assert ran.document["reproduced"] == 1.0
    assert ran.status == (0 if ran.document["reachable"]["sji"] >= 0.94 else 1)
    text = here("benchmark", "check", tmp_path).out
    assert "transitions" in text


def test_benchmark_check_fails_where_the_domain_does_otherwise(tmp_path: Path) -> None:
    wrong = (*FILLING[:2], ("(Grasping Robot Bowl_1)", "moveto Sink"), *FILLING[3:])
    ran = here("benchmark", "check", write_document(tmp_path, steps=wrong), "--json")
    assert ran.status == 1
    assert ran.document["reproduced"] < 0.995
    for difference in ran.document["differences"]:
        assert {"document", "step", "action", "expected", "got"} <= set(difference)


@needs_corpus
@pytest.mark.slow
def test_benchmark_check_passes_on_the_corpus() -> None:
    ran = here("benchmark", "check", REAL, "--json")
    assert ran.status == 0
    assert ran.document["reproduced"] >= 0.995
    assert ran.document["reachable"]["sji"] >= 0.94


def test_benchmark_check_of_no_corpus_is_one_line(tmp_path: Path) -> None:
    assert_refused(here("benchmark", "check", tmp_path), "no document")
    assert_refused(here("benchmark", "check", tmp_path / "none"), "none")


def test_benchmark_check_names_the_torn_file(tmp_path: Path) -> None:
    (tmp_path / "7.instenv").write_text("Obj list: (Robot:)\n<start step >0\nEnv: (On a\n", "utf-8")
    assert_refused(here("benchmark", "check", tmp_path), "7.instenv")
    (tmp_path / "7.clauses").write_text("", "utf-8")
    assert_refused(here("benchmark", "check", tmp_path), "7.instenv:3")
