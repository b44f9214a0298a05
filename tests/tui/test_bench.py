"""The benchmark measures what it says it does."""

from __future__ import annotations

import multiprocessing
import sys
import time
from collections.abc import Iterator
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

from tests.tui.commandline import here
from verbteach.dialogue.setting import Settings
from verbteach_scenarios.lessons import load_lessons
from verbteach_scenarios.pddl import parse_domain, parse_problem
from verbteach_scenarios.settings import make_settings
from verbteach_sessions.replay import verify
from verbteach_tui.bench import clock, peers, planning, startup
from verbteach_tui.bench.allowance import Allowance
from verbteach_tui.bench.apart import measured_apart
from verbteach_tui.bench.dialogue import (
    PlanCounter,
    dialogues_per_second,
    long_session,
    planned_episodes_per_second,
)
from verbteach_tui.bench.memory import resident_mb
from verbteach_tui.bench.painting import PRESSED, key_to_paint
from verbteach_tui.bench.parts import PARTS
from verbteach_tui.bench.questions import Question, of_lessons, spread
from verbteach_tui.bench.workbench import Amounts
from verbteach_tui.commands.bench import NAMES

SHORT = [
    lesson
    for lesson in load_lessons()
    if lesson.scene == "kitchen-1" and len(lesson.demonstration) < 5
]


@pytest.fixture(scope="module")
def settings() -> Settings:
    return make_settings()


@pytest.fixture(scope="module")
def questions(settings: Settings) -> list[Question]:
    some = [lesson for lesson in load_lessons() if lesson.scene == "kitchen-1"]
    return list(of_lessons(some[:6], settings))


def test_percentiles_are_those_of_the_sorted_times() -> None:
    assert clock.percentiles([]) == {"p50": None, "p95": None}
    assert clock.percentiles([3.0]) == {"p50": 3.0, "p95": 3.0}
    assert clock.percentiles([float(n) for n in range(101)]) == {"p50": 50.0, "p95": 95.0}


def test_timed_counts_milliseconds() -> None:
    spent, answer = clock.timed(lambda: sum(_ticks(20)))
    assert answer == 20
    assert 15 < spent < 2000


def _ticks(count: int) -> Iterator[int]:
    """``count`` ones, a millisecond each."""
    for _ in range(count):
        time.sleep(0.001)
        yield 1


def test_per_second_counts_what_was_done() -> None:
    calls: list[int] = []

    def call() -> int:
        calls.append(1)
        time.sleep(0.01)
        return 3

    rate = clock.per_second(call, 0.05)
    assert 0 < rate <= 300
    assert len(calls) >= 2


def test_spread_takes_evenly_from_the_whole_list() -> None:
    assert spread(range(6), 100) == [0, 1, 2, 3, 4, 5]
    assert spread(range(6), 3) == [0, 2, 4]
    assert spread(range(1000), 4) == [0, 250, 500, 750]


def test_a_question_as_pddl_is_the_same_question(questions: list[Question]) -> None:
    domain_text, problem_text = questions[0].pddl()
    domain = parse_domain(domain_text)
    problem = parse_problem(problem_text, domain, Path("problem.pddl"))
    assert problem.goal == questions[0].goal
    assert problem.initial == questions[0].state


def test_planning_answers_every_question_and_is_told_of_each(questions: list[Question]) -> None:
    told: list[int] = []
    measured = planning.measure(questions, "plain", told.append)
    assert measured["solved"] == measured["questions"] == len(questions)
    assert told == list(range(1, len(questions) + 1))
    assert 0 < measured["p50"] <= measured["p95"]


@pytest.mark.skipif("kairos" not in peers.here(), reason="kairos has wheels for Linux only")
def test_a_peer_solves_the_same_questions(questions: list[Question]) -> None:
    measured = peers.measure("kairos", [one.pddl() for one in questions[:2]], lambda n: None)
    assert measured["problem"] is None
    assert measured["solved"] == 2
    assert multiprocessing.active_children() == []


def test_this_planner_is_asked_from_text_as_well(questions: list[Question]) -> None:
    name = "verbteach, from text"
    assert name in peers.here()
    some = questions[:2]
    measured = peers.measure(name, [one.pddl() for one in some], lambda n: None)
    ready = planning.measure(some, planning.paths()[-1], lambda n: None)
    assert (measured["problem"], measured["solved"]) == (None, 2)
    assert measured["steps"] == ready["steps"]


def test_a_peer_that_breaks_is_reported_and_not_waited_for() -> None:
    if "kairos" not in peers.here():
        pytest.skip("no peer to break")
    measured = peers.measure("kairos", [("(define", "nonsense")] * 3, lambda n: None)
    assert measured["solved"] == 0
    assert measured["problem"]


def sleeping() -> peers.Solve:
    """A peer that takes its time over long questions."""

    def solve(domain: str, problem: str) -> int | None:
        time.sleep(30.0 if problem == "hard" else 0.0)
        return 1

    return solve


def test_a_question_that_takes_too_long_is_broken_off_and_the_next_one_asked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(peers, "_serve", serve_sleeping)
    monkeypatch.setattr(peers, "LONGEST", 0.0)
    told: list[int] = []
    texts = [("", "easy"), ("", "hard"), ("", "easy")]
    measured = peers.measure("kairos", texts, told.append)
    assert (measured["questions"], measured["solved"], measured["timed_out"]) == (3, 2, 1)
    assert measured["problem"] is None
    assert told == [1, 2, 3]
    assert multiprocessing.active_children() == []


def serve_sleeping(name: str, connection: Connection) -> None:
    connection.send((0.0, None, ""))
    while True:
        _, problem = connection.recv()
        connection.send((1.0, sleeping()("", problem), ""))


def test_a_peer_that_used_up_its_time_gets_no_further_question(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(peers, "BUDGET", -1.0)
    measured = peers.measure("kairos", [("", "easy")] * 3, lambda n: None)
    assert (measured["questions"], measured["solved"], measured["problem"]) == (0, 0, None)


def test_a_peer_that_cannot_be_loaded_says_so() -> None:
    if "pyperplan" in peers.here():
        pytest.skip("pyperplan is installed")
    measured = peers.measure("pyperplan", [("", "")] * 2, lambda n: None)
    assert "ModuleNotFoundError" in measured["problem"]


def test_the_counter_sees_every_plan(settings: Settings) -> None:
    counter = PlanCounter(settings)
    setting = counter("kitchen-1")
    lesson = next(one for one in load_lessons() if one.scene == "kitchen-1")
    answer = setting.planner.plan(setting.scene.initial, lesson.goal)
    assert answer == settings("kitchen-1").planner.plan(setting.scene.initial, lesson.goal)
    assert counter.calls == 1


def test_dialogues_and_episodes_are_counted(
    settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("verbteach_tui.bench.dialogue.SECONDS", 0.2)
    monkeypatch.setattr("verbteach_tui.bench.dialogue.TAUGHT", 2)
    assert dialogues_per_second(settings, "kitchen-1") > 1
    assert planned_episodes_per_second(SHORT, settings, Allowance(60)) > 0.1


def test_a_long_session_is_timed_after_the_turns_before_it(
    settings: Settings, tmp_path: Path
) -> None:
    told: list[int] = []
    held = long_session(tmp_path, SHORT, settings, (5, 7), Allowance(600), told.append)
    assert (held.before, len(held.plain) + len(held.planned)) == (5, 7)
    assert told == list(range(1, 13))
    assert held.planned, "a demonstration that ends is planned for"
    assert held.longest[0] == max(*held.plain, *held.planned)
    found = verify(held.path, settings)
    assert found.first_difference is None
    assert found.events > 12


def test_a_long_session_ends_when_its_time_is_up(settings: Settings, tmp_path: Path) -> None:
    held = long_session(tmp_path, SHORT, settings, (5, 7), Allowance(0), lambda n: None)
    assert (held.before, held.plain, held.planned) == (0, [], [])


def test_planning_ends_when_its_time_is_up(questions: list[Question]) -> None:
    measured = planning.measure(questions, "plain", lambda n: None, Allowance(0))
    assert (measured["questions"], measured["p95"]) == (0, None)


def test_an_allowance_runs_out() -> None:
    short = Allowance(0.02)
    time.sleep(0.03)
    assert short.over()
    assert short.over(0.5)
    assert not Allowance(600).over(0.01)


def test_a_process_apart_says_how_far_it_is_and_what_it_found(tmp_path: Path) -> None:
    told: list[int] = []
    answer = measured_apart("tests.tui.apart", ("3",), 60, told.append, without=["numba"])
    assert told == [1, 2, 3]
    assert answer == {"words": ["3"], "numba": False}


def test_a_process_apart_that_fails_or_never_ends_has_no_answer(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("verbteach_tui.bench.apart.GRACE", 0.1)
    assert measured_apart("tests.tui.apart", ("torn",), 60, lambda n: None) is None
    start = time.monotonic()
    assert measured_apart("tests.tui.apart", ("endless",), 1, lambda n: None) is None
    assert time.monotonic() - start < 30


@pytest.mark.slow
def test_keys_are_timed_in_a_session_that_was_made(settings: Settings, tmp_path: Path) -> None:
    held = long_session(tmp_path, SHORT, settings, (0, 8), Allowance(600), lambda n: None)
    told: list[int] = []
    found = key_to_paint(held.path, 300, told.append)
    assert len(found["typing"]) + len(found["turning"]) == PRESSED == told[-1]
    assert max(found["typing"]) < 2000, "no key that types goes unseen"


def test_only_the_parts_that_were_named_are_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    small = Amounts(questions=3)
    monkeypatch.setattr("verbteach_tui.bench.workbench.AMOUNTS", small)
    ran = here("bench", "--part", "plans", "--plain", "--json")
    assert ran.status == 0
    assert set(ran.document) == {"plan_ms", "peers", "seconds", "load"}
    assert ran.document["plan_ms"]["path"] == "plain"
    assert set(ran.document["seconds"]) == {"plans"}


def test_a_part_that_is_not_there_is_refused() -> None:
    ran = here("bench", "--part", "wheels")
    assert ran.status == 2
    assert "'wheels'" in ran.err
    assert "startup, plans" in ran.err


def test_every_part_that_can_be_named_can_be_measured() -> None:
    assert tuple(PARTS) == NAMES


def test_this_process_holds_some_memory() -> None:
    assert 5 < resident_mb() < 5000


def test_version_is_timed_in_a_process_of_its_own() -> None:
    assert startup.command()[0].startswith(sys.prefix) or startup.command()[0] == sys.executable
    assert 1 < startup.version_ms(runs=1) < 10_000


@pytest.mark.slow
def test_bench_prints_every_figure_of_the_contract(monkeypatch: pytest.MonkeyPatch) -> None:
    """In small, but with everything that is measured."""
    monkeypatch.setattr("verbteach_tui.bench.dialogue.SECONDS", 0.2)
    monkeypatch.setattr("verbteach_tui.bench.dialogue.TAUGHT", 3)
    small = Amounts(questions=10, before=20, timed=60, app=20, replayed=20)
    monkeypatch.setattr("verbteach_tui.bench.workbench.AMOUNTS", small)
    ran = here("bench", "--json")
    assert ran.status == 0
    document = ran.document
    assert set(document["startup_ms"]) == {"version", "first_paint"}
    assert document["startup_ms"]["first_paint"] > document["startup_ms"]["version"] > 0
    for name in ("turn_ms", "planned_turn_ms", "plan_ms"):
        assert 0 < document[name]["p50"] <= document[name]["p95"]
    assert document["plan_ms"]["path"] in ("plain", "compiled")
    for kind in ("typing", "turning"):
        assert (
            0 < document["key_to_paint_ms"][kind]["p50"] <= document["key_to_paint_ms"][kind]["p95"]
        )
    for name in ("dialogues_per_s", "planned_episodes_per_s", "replay_events_per_s", "rss_mb"):
        assert document[name] > 0
    assert document["peers"] == {}
    assert document["turns"]["before"] == 20
    assert document["rss"]["turns"] == 20
    assert set(document["seconds"]) == set(NAMES) - {"peers"}
