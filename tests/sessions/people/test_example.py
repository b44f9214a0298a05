"""The example corpus: marked as simulated, sound, the same each time, and of people that differ."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from tests.sessions.people.corpus import SMALL, settings
from verbteach_scenarios.lessons import load_lessons
from verbteach_sessions.catalogue import list_sessions
from verbteach_sessions.eventlog import LOG_NAME
from verbteach_sessions.example import PEOPLE_NAME, ExampleParameters, hold, main, make_example
from verbteach_sessions.example_plan import LONGEST, POLICIES, plan
from verbteach_sessions.people.recorded import Recorded, read_header
from verbteach_sessions.replay import verify
from verbteach_sessions.validate import validate


def test_every_session_says_that_it_is_simulated_and_is_closed(example: tuple[Path, ...]) -> None:
    assert len(example) == SMALL.sessions
    for path in example:
        header = read_header(path)
        assert (header.teacher, header.machine.interface) == ("simulated", "simulated")
    assert all(entry.ended for entry in list_sessions(example[0].parent))
    assert sorted(entry.id for entry in list_sessions(example[0].parent)) == sorted(
        path.name for path in example
    )


def test_a_session_of_it_is_valid(example: tuple[Path, ...]) -> None:
    assert validate(example[1], settings()).problems == ()


def test_the_same_seed_holds_the_same_session(example: tuple[Path, ...], tmp_path: Path) -> None:
    planned = plan(load_lessons(), SMALL.sessions, SMALL.lessons, SMALL.seed)
    again = hold(tmp_path, planned[2], settings())
    assert again.name == example[2].name
    assert (again / LOG_NAME).read_bytes() == (example[2] / LOG_NAME).read_bytes()


def test_what_is_there_is_kept_and_the_rest_is_made(example: tuple[Path, ...]) -> None:
    folder = example[0].parent
    before = {path: (path / LOG_NAME).stat().st_mtime_ns for path in example}
    heard: list[tuple[int, int]] = []
    assert make_example(folder, SMALL, heard=lambda n, of: heard.append((n, of))) == example
    assert {path: (path / LOG_NAME).stat().st_mtime_ns for path in example} == before
    assert heard == [(n, SMALL.sessions) for n in range(1, SMALL.sessions + 1)]


def test_the_people_are_told_beside_the_records_and_not_in_them(
    example: tuple[Path, ...], records: tuple[Recorded, ...]
) -> None:
    people = json.loads((example[0].parent / PEOPLE_NAME).read_text())
    assert people["simulated"] is True
    assert set(people["people"]) == {record.person for record in records}
    for record in records:
        taught = people["lessons"][record.header.id]
        assert len(taught) == SMALL.lessons
    for path in example:
        assert b"gives_up" not in (path / LOG_NAME).read_bytes()


def test_answers_take_time(records: tuple[Recorded, ...]) -> None:
    for record in records:
        for said in record.said:
            shown, answered = said.event.data["shown_at"], said.event.data["answered_at"]
            assert shown < answered < shown + 60.0


def test_the_whole_corpus_is_planned_wide(tmp_path: Path) -> None:
    planned = plan(load_lessons(), 48, 6, 0)
    people = {one.person.code: one.person for one in planned}
    assert len(planned) >= 40
    assert len(people) == 24
    assert {one.policy for one in planned} == set(POLICIES)
    assert len({one.seed for one in planned}) == 48
    errors = [one.habits.rates["goal_pred_ynq"].error for one in people.values()]
    assert max(errors) > 0.15
    assert min(errors) < 0.03
    assert len({one.manner for one in people.values()}) > 3
    for one in planned:
        assert len(one.lessons) == 6
        assert all(len(lesson.demonstration) <= LONGEST for lesson in one.lessons)
        verbs = [lesson.verb for lesson in one.lessons]
        assert verbs[:3] == verbs[3:]  # shown in one scene, asked for in another
        assert all(
            a.scene != b.scene for a, b in zip(one.lessons[:3], one.lessons[3:], strict=True)
        )


def test_without_a_folder_it_says_how(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 2
    assert "DIR" in capsys.readouterr().err


@pytest.mark.slow  # all of it is held, and then recomputed turn by turn
def test_every_session_of_the_whole_corpus_is_valid(tmp_path: Path) -> None:
    made = make_example(tmp_path, ExampleParameters(), jobs=os.cpu_count() or 1)
    assert len(made) == ExampleParameters().sessions
    wrong = {path.name: found for path in made if (found := validate(path, settings())).problems}
    assert wrong == {}


@pytest.mark.slow
def test_processes_change_nothing(example: tuple[Path, ...], tmp_path: Path) -> None:
    made = make_example(tmp_path, ExampleParameters(3, SMALL.lessons, SMALL.seed), jobs=2)
    one_by_one = plan(load_lessons(), 3, SMALL.lessons, SMALL.seed)
    again = [hold(tmp_path / "again", planned, settings()) for planned in one_by_one]
    for path, other in zip(made, again, strict=True):
        assert verify(path, settings()).verified
        assert (path / LOG_NAME).read_bytes() == (other / LOG_NAME).read_bytes()
