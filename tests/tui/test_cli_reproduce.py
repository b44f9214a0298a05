"""`reproduce`: a small corpus, from the command line to the files."""

from __future__ import annotations

import csv
import json
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from tests.docs.test_commands import documented_keys, keys
from tests.scenarios.tell_me_dave_folder import FILLING, OBJECTS, write_document
from tests.tui.commandline import Ran, assert_refused, here
from verbteach.experiments.reproduction.rows import Row

PNG = b"\x89PNG\r\n"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same demonstration five times in each of two rooms that differ."""
    made = tmp_path_factory.mktemp("corpus")
    for number in range(5):
        write_document(made, str(number))
        write_document(made, str(10 + number), objects=f"{OBJECTS} (Plate_1:IsGraspable)")
    return made


def reproduced(target: str, folder: Path, out: Path, *words: object) -> Ran:
    few = ("--runs", 2, "--episodes", 8)
    ran = here("reproduce", target, "--data", folder, "--out", out, *few, *words)
    assert ran.status == 0, ran
    return ran


@pytest.fixture(scope="module")
def done(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What `reproduce all` has left."""
    out = tmp_path_factory.mktemp("out") / "results"
    document = reproduced("all", folder, out, "--jobs", 1, "--json").document
    assert document.pop("files")
    assert document == read(out)
    return out


def read(out: Path) -> Mapping[str, Any]:
    document: Mapping[str, Any] = json.loads((out / "results.json").read_text("utf-8"))
    return document


def test_the_document_has_the_shape_that_others_rely_on(done: Path) -> None:
    document = read(done)
    cell = document["table4"]["rl"]["std5"]
    assert set(cell) == {"ied", "sji", "questions_learning", "questions_execution", "paper"}
    assert cell["paper"] == {"ied": 0.392, "sji": 0.411}
    assert set(document["table5"]["manual"]["execution"]) == {"ground", "env", "goal", "total"}
    lessons, figure = document["figure5"]["she16"][-1]
    assert lessons == 8
    assert set(figure) == {"mean", "sd", "ci95", "runs"}
    assert document["runs"] == 2
    assert document["seconds"] > 0
    assert set(keys(document)) <= documented_keys("reproduce") | set(NAMES)


NAMES = ("rl", "manual", "random", "split", "she16", "she16-all", "ied", "sji")


def test_the_files_are_what_they_say(done: Path) -> None:
    assert {path.name for path in done.iterdir()} == {
        *("rows.jsonl", "rows.csv", "tables.md", "results.json"),
        *("figure5.png", "figure5.svg", "questions.png", "questions.svg"),
    }
    assert (done / "figure5.png").read_bytes().startswith(PNG)
    assert "<svg" in (done / "figure5.svg").read_text("utf-8")
    assert "## Table 4" in (done / "tables.md").read_text("utf-8")
    with (done / "rows.csv").open(encoding="utf-8", newline="") as file:
        lines = list(csv.DictReader(file))
    rows = [json.loads(line) for line in (done / "rows.jsonl").read_text("utf-8").splitlines()]
    assert len(rows) == 2 * 4 * 6
    assert len(lines) == sum(len(row["commands"]) for row in rows)
    assert {line["policy"] for line in lines} == {row["settings"]["policy"] for row in rows}


def test_a_broken_off_run_goes_on_and_processes_change_no_figure(
    done: Path, folder: Path, tmp_path: Path
) -> None:
    whole = (done / "rows.jsonl").read_bytes().splitlines(keepends=True)
    (tmp_path / "rows.jsonl").write_bytes(b"".join(whole[:30]) + whole[30][:40])
    reproduced("all", folder, tmp_path, "--resume", "--jobs", 2)
    again = (tmp_path / "rows.jsonl").read_bytes().splitlines(keepends=True)
    assert again[:30] == whole[:30]
    rows = [[Row.from_json(json.loads(line)) for line in lines] for lines in (whole, again)]
    assert sorted(rows[0], key=lambda r: r.key) == sorted(rows[1], key=lambda r: r.key)
    before, after = read(done), read(tmp_path)
    for name in ("table4", "table5", "figure5", "comparisons", "matched", "per_question"):
        assert after[name] == before[name]


def test_what_is_there_is_not_written_over(done: Path, folder: Path) -> None:
    ran = here("reproduce", "all", "--data", folder, "--out", done)
    assert_refused(ran, "rows.jsonl", "--resume")


def test_rows_of_other_data_are_left_alone(done: Path, folder: Path, tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.mkdir()
    for path in folder.iterdir():
        (other / path.name).write_bytes(path.read_bytes())
    write_document(other, "20")
    out = tmp_path / "out"
    out.mkdir()
    first = (done / "rows.jsonl").read_bytes().splitlines(keepends=True)[:6]
    (out / "rows.jsonl").write_bytes(b"".join(first))
    reproduced("table5", other, out, "--resume", "--jobs", 1)
    lines = (out / "rows.jsonl").read_bytes().splitlines(keepends=True)
    assert lines[:6] == first
    assert len(lines) == 6 + 2 * 6


def test_test_data_is_what_is_tested(folder: Path, tmp_path: Path) -> None:
    apart = tmp_path / "apart"
    apart.mkdir()
    waited = (*FILLING[:-1], (FILLING[-1][0], "wait"), FILLING[-1])
    for number in (30, 31):
        write_document(apart, str(number), steps=waited)
    ran = reproduced("table5", folder, tmp_path / "out", "--test-data", apart, "--jobs", 1)
    assert "Table 5" in ran.out
    document = read(tmp_path / "out")
    assert document["folds"] == "test data"
    assert document["instances"] == {"lessons": 15.0, "tested": 4.0}


def test_the_figure_is_drawn_in_the_terminal(folder: Path, tmp_path: Path) -> None:
    beside = ("--with", "harder-teacher", "--with", "paper-prices")
    out = reproduced("figure5", folder, tmp_path / "out", "--jobs", 1, *beside).out
    assert "training instances" in out
    assert any("⠀" < sign <= "⣿" for sign in out)
    assert "20 % are wrong" in out
    assert "paper's prices" in out


def test_wrong_use_is_said_in_a_line(folder: Path, tmp_path: Path) -> None:
    out = ("--out", tmp_path / "out")
    assert_refused(here("reproduce", "table9", *out), "table9")
    assert_refused(here("reproduce", "all", *out, "--test-data", folder), "--data")
    assert_refused(here("reproduce", "all", *out, "--data", tmp_path / "none"), "none")
    assert_refused(here("reproduce", "all", *out, "--data", folder, "--with", "magic"), "magic")
    few = tmp_path / "few"
    few.mkdir()
    write_document(few, "1")
    assert_refused(here("reproduce", "all", *out, "--data", few), "only one")
    write_document(few, "2", objects=f"{OBJECTS} (Plate_1:IsGraspable)")
    assert_refused(here("reproduce", "all", *out, "--data", few), "too few")
    broken = tmp_path / "broken"
    broken.mkdir()
    (broken / "rows.jsonl").write_text("{}\n")
    ran = here("reproduce", "all", "--out", broken, "--data", folder, "--resume")
    assert_refused(ran, "rows.jsonl:1", "not a row")


def test_a_cluster_that_is_not_there_is_said(folder: Path, tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    words = ("--data", folder, "--out", tmp_path / "out", "--runs", 2)
    ran = here("reproduce", "table5", *words, "--cluster", "tcp://127.0.0.1:9")
    assert ran.status == 2
    assert "127.0.0.1:9" in ran.err


@pytest.mark.slow
def test_a_cluster_gives_the_same_rows(done: Path, folder: Path, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    with (
        warnings.catch_warnings(),
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as made,
    ):
        warnings.simplefilter("ignore")
        reproduced("table5", folder, tmp_path / "out", "--cluster", made.scheduler_address)
    before, after = read(done), read(tmp_path / "out")
    for policy, cells in before["table4"].items():
        assert after["table5"][policy]["sji"]["mean"] == cells["std3"]["sji"]["mean"]
