"""The lab: jobs, the worker's lines, cancelling, what is kept, and what is drawn."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach_tui.lab import lab as lab_module
from verbteach_tui.lab.drawing import curve_rows, progress_rows, smoothed, table_rows
from verbteach_tui.lab.jobs import COMPARE, ROOMS, TRAIN, Job
from verbteach_tui.lab.lab import Lab, LabState
from verbteach_tui.lab.results import earlier_runs, save_job, save_rows
from verbteach_tui.lab.worker import work
from verbteach_tui.screens.lab_settings import changed, settings_of
from verbteach_tui.views.rows import plain, width_of

FIGURE = {"mean": 0.5, "sd": 0.0, "ci95": [0.4, 0.6], "runs": 1}
NAMES = ("sji", "ied", "questions_learning", "questions_execution")
ROW = {"policy": "manual", "right": 0.25, **dict.fromkeys(NAMES, FIGURE)}


def until(lab: Lab, seconds: float = 60.0) -> LabState:
    """The state once nothing is going on any more."""
    end = time.monotonic() + seconds
    while lab.state.running:
        assert time.monotonic() < end, lab.state
        time.sleep(0.02)
    return lab.state


def worker(monkeypatch: pytest.MonkeyPatch, script: str) -> None:
    """Another program in the worker's place."""
    monkeypatch.setattr(lab_module, "_COMMAND", (sys.executable, "-c", script))


SLOW = """
import json, sys, time
sys.stdin.readline()
print(json.dumps({"stage": "learning", "done": 1, "total": 9, "figures": [1.0]}), flush=True)
time.sleep(60)
"""


def test_what_the_worker_tells_is_followed_to_the_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines = [
        {"stage": "learning", "done": 2, "total": 4, "figures": [1.0, 2.0]},
        {"stage": "learning", "done": 4, "total": 4, "figures": [3.0, 4.0]},
        {"row": ROW},
        {"saved": "there"},
    ]
    worker(
        monkeypatch,
        f"import json,sys; sys.stdin.readline()\nfor l in {lines!r}: print(json.dumps(l))",
    )
    lab = Lab(tmp_path)
    assert lab.start(Job())
    state = until(lab)
    assert state.phase == "done"
    assert state.curves == {"learning": (1.0, 2.0, 3.0, 4.0)}
    assert state.rows == (ROW,)


def test_one_job_at_a_time_and_cancelling_ends_it_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker(monkeypatch, SLOW)
    lab = Lab(tmp_path)
    lab.cancel()
    assert lab.start(Job())
    assert not lab.start(Job())
    while not lab.state.curves:
        time.sleep(0.02)
    process = lab._process
    began = time.monotonic()
    lab.close()
    assert time.monotonic() - began < 5
    assert lab.state.phase == "cancelled"
    assert process is not None
    assert process.wait(5) != 0
    assert list(tmp_path.iterdir()) == []
    assert lab.start(Job())
    lab.close()


def test_a_cancelled_job_says_no_more(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    worker(monkeypatch, SLOW)
    lab = Lab(tmp_path)
    lab.start(Job())
    lab.cancel()
    state = lab.state
    time.sleep(0.5)
    assert lab.state is state


@pytest.mark.parametrize(
    ("script", "said"),
    [
        ("raise SystemExit('no such thing')", "no such thing"),
        ('import sys; sys.stdin.readline(); print(\'{"failed": "OSError: full"}\')', "full"),
        ("", "ended early"),
        ("print('nonsense')", "ended early"),
    ],
)
def test_a_worker_that_fails_is_told_of(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, said: str
) -> None:
    worker(monkeypatch, script)
    lab = Lab(tmp_path)
    lab.start(Job())
    state = until(lab)
    assert state.phase == "failed"
    assert said in state.note
    assert said in " ".join(plain(row) for row in progress_rows(state, 60))


def test_settings_lead_through_every_value_and_back() -> None:
    for first in (Job(), Job(COMPARE)):
        for row, setting in enumerate(settings_of(first)):
            job = first
            for _ in setting.values:
                job = changed(job, row, 1)
            assert job == first
            assert changed(changed(first, row, 1), row, -1) == first
    none = Job(COMPARE)
    for row in range(5, 10):
        none = changed(none, row, 1)
    assert none.policies == ()
    assert Job.from_json(json.loads(json.dumps(none.to_json()))) == none


def test_earlier_runs_are_listed_and_what_cannot_be_read_is_left_out(tmp_path: Path) -> None:
    save_job(tmp_path / "a", Job(COMPARE))
    save_rows(tmp_path / "a", [ROW])
    save_job(tmp_path / "b", Job(TRAIN))
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "job.json").write_text('{"kind": "train"')
    newest, oldest = earlier_runs(tmp_path)
    assert (newest.path.name, newest.trained) == ("b", False)
    assert oldest.rows[0]["policy"] == "manual"
    table = (tmp_path / "a" / "comparison.csv").read_text().splitlines()
    assert table[0].startswith("policy,right,ied,ied_low")
    assert earlier_runs(tmp_path / "none") == ()


@given(st.lists(st.floats(-500, 500), max_size=300), st.integers(1, 60), st.integers(10, 150))
def test_curves_fit_their_place(figures: list[float], height: int, width: int) -> None:
    rows = curve_rows({"learning": figures, "execution": figures[::2]}, 300, width, height)
    assert len(rows) <= max(height, 1)
    assert all(width_of(row) <= max(width, 11) for row in rows)


@given(st.lists(st.floats(-100, 100), min_size=1, max_size=80))
def test_smoothing_is_the_mean_of_the_last_few(figures: list[float]) -> None:
    naive = [
        sum(figures[max(0, n - 24) : n + 1]) / len(figures[max(0, n - 24) : n + 1])
        for n in range(len(figures))
    ]
    assert smoothed(figures) == pytest.approx(naive, abs=1e-6)


@pytest.mark.parametrize("width", [30, 58, 80, 150])
def test_tables_fit_their_place(width: int) -> None:
    rows = table_rows([ROW, {**ROW, "policy": "silent"}], width)
    assert all(width_of(row) <= width for row in rows)
    assert "0.500" in plain(rows[1])


def test_where_it_is_narrow_the_intervals_go_and_what_was_asked_stays() -> None:
    worse = {**ROW, "policy": "silent", "sji": {**FIGURE, "mean": 0.1}}
    for width, interval in ((56, False), (76, True)):
        head, best, other, *_ = map(plain, table_rows([ROW, worse], width))
        assert "asked, learning acting" in head
        assert ("-" in best) is interval
        assert "best" in best
        assert "best" not in other


@pytest.mark.slow
def test_a_comparison_is_worked_out_saved_and_told(tmp_path: Path) -> None:
    told: list[dict[str, object]] = []
    job = Job(COMPARE, "std3", 100, 0, ("silent", "manual"), ROOMS["two rooms"], 0.05)
    work(job, tmp_path / "run", told.append)
    rows = [line["row"] for line in told if "row" in line]
    assert [row["policy"] for row in rows] == ["silent", "manual"]  # type: ignore[index]
    assert told[-1] == {"saved": str(tmp_path / "run")}
    (run,) = earlier_runs(tmp_path)
    assert [row["policy"] for row in run.rows] == ["silent", "manual"]
    assert run.rows[0]["questions_execution"]["mean"] == 0
    assert run.rows[1]["questions_execution"]["mean"] > 0


@pytest.mark.slow
def test_trained_weights_are_saved_and_can_be_taught_with(tmp_path: Path) -> None:
    from verbteach_scenarios.weights import load_weights

    told: list[dict[str, object]] = []
    work(Job(TRAIN, "perfect", 100), tmp_path / "run", told.append)
    assert load_weights(tmp_path / "run" / "weights.json").learner
    lines = (tmp_path / "run" / "curves.csv").read_text().splitlines()
    assert len(lines) == 1 + 2 * 100
    figures = [f for line in told if line.get("stage") == "learning" for f in line["figures"]]  # type: ignore[attr-defined]
    assert len(figures) == 100
