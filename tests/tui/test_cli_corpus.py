"""Exports and corpus tools as commands: one document out, one line where the input is wrong."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from unittest.mock import patch

import pytest

from tests.docs.test_commands import documented_keys, keys
from tests.sessions.corpora import ANNA, MAIL, small_corpus
from tests.tui.commandline import assert_refused, here
from verbteach_sessions.exports.formats import FORMATS
from verbteach_tui.commands.sessions_export import FormatName

STATS = {
    "sessions",
    "teachers",
    "participants",
    "turns",
    "commands",
    "seconds",
    "questions",
    "seconds_per_answer",
    "words_per_learned_verb",
    "agreement",
    "per_participant",
}


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of three sessions. Tests leave it as it is."""
    return small_corpus(tmp_path_factory)[0].parent


@pytest.fixture
def folder(kept: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(kept, tmp_path / "sessions"))


def test_the_option_names_every_format() -> None:
    assert set(FormatName.__args__) == set(FORMATS)  # type: ignore[attr-defined]


def test_export_prints_what_it_made(folder: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran = here("sessions", "export", folder, "--to", "jsonl", "--out", out, "--json")
    assert ran.status == 0, ran
    document = ran.document
    assert (document["format"], document["sessions"]) == ("jsonl", 3)
    assert all((out / name).is_file() for name in document["files"])
    assert ANNA in document["participants"]
    assert_refused(here("sessions", "export", folder, "--to", "csv", "--out", out), "--force")
    again = here("sessions", "export", folder, "--to", "csv", "--out", out, "--force")
    assert "turns" in again.out


def test_export_says_what_it_left_out(folder: Path, tmp_path: Path) -> None:
    logs = sorted(folder.glob("*/events.jsonl"))
    log = next(path for path in logs if b"boil" in path.read_bytes())
    spoiled = log.parent
    log.write_bytes(log.read_bytes().replace(b"boil", b"bowl", 1))
    words = ("sessions", "export", folder, "--to", "csv", "--out", tmp_path / "out")
    assert_refused(here(*words), str(log))
    ran = here(*words, "--skip-damaged", "--json")
    assert ran.status == 0
    assert [one["session"] for one in ran.document["left_out"]] == [spoiled.name]
    assert f"left out: {spoiled.name}: {log}, line" in ran.err
    assert ran.document["sessions"] == 2
    assert set(keys(ran.document)) <= documented_keys("sessions export")


def test_export_shows_scenes_on_pages(folder: Path, tmp_path: Path) -> None:
    session = next(path for path in folder.iterdir() if path.is_dir())
    out = tmp_path / "pages"
    assert here("sessions", "export", session, "--to", "html", "--out", out).status == 0
    (page,) = out.glob("????????.html")
    assert "kettle" in page.read_text("utf-8").split('id="data"')[1]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("export", "none", "--to", "csv", "--out", "out"), "none"),
        (("export", "none", "--to", "docx", "--out", "out"), "docx"),
        (("export", "none", "--to", "csv"), "--out"),
        (("stats", "none"), "none"),
        (("scan", "none"), "none"),
        (("split", "none"), "none"),
        (("datasheet", "none"), "none"),
        (("release", "none"), "none"),
        (("withdraw", "abc", "--sessions", "none"), "none"),
    ],
)
def test_what_is_not_there_is_one_line(words: tuple[str, ...], said: str, tmp_path: Path) -> None:
    placed = [str(tmp_path / word) if word in ("none", "out") else word for word in words]
    assert_refused(here("sessions", *placed), said)
    assert not (tmp_path / "out").exists()


def test_a_missing_extra_is_one_line(folder: Path, tmp_path: Path) -> None:
    with patch("verbteach_sessions.exports.formats.find_spec", return_value=None):
        ran = here("sessions", "export", folder, "--to", "parquet", "--out", tmp_path / "out")
    assert_refused(ran, "pip install 'verbteach[parquet]'")


def test_stats(folder: Path) -> None:
    document = here("sessions", "stats", folder, "--json").document
    assert set(document) >= STATS
    assert document["sessions"] == 3
    told = here("sessions", "stats", sessions=folder)
    assert ANNA in told.out


def test_scan_asks_for_decisions_and_keeps_them(folder: Path) -> None:
    ran = here("sessions", "scan", folder, "--json")
    assert ran.status == 1
    assert ran.document["undecided"] == len(ran.document["findings"]) == 3
    assert_refused(here("sessions", "scan", folder, "--keep", "nobody wrote this"), "nobody wrote")
    kept = here("sessions", "scan", folder, "--keep", MAIL.upper(), "--json")
    assert kept.document["undecided"] == 2
    done = here("sessions", "scan", folder, "--redact", "--json")
    assert done.status == 0
    choices = {one["text"]: one["choice"] for one in done.document["findings"]}
    assert choices.pop(MAIL) == "keep"
    assert set(choices.values()) == {"redact"}
    assert "redact" in here("sessions", "scan", folder).out


def test_scan_takes_names(folder: Path, tmp_path: Path) -> None:
    names = tmp_path / "names.txt"
    names.write_text("kettle\n\n", "utf-8")
    kinds = {
        one["kind"]
        for one in here("sessions", "scan", folder, "--names", names, "--json").document["findings"]
    }
    assert "listed name" in kinds
    names.write_bytes(b"\xff\xfe")
    assert_refused(here("sessions", "scan", folder, "--names", names), "UTF-8")


def test_withdraw_needs_a_yes(folder: Path, tmp_path: Path) -> None:
    here("sessions", "export", folder, "--to", "csv", "--out", tmp_path / "out")
    refused = here("sessions", "withdraw", ANNA, "--sessions", folder, "--json", typed=f"{ANNA}\n")
    assert refused.status == 2
    assert "--yes" in refused.err
    ran = here("sessions", "withdraw", ANNA, "--sessions", folder, "--yes", "--json")
    assert ran.status == 0
    document = ran.document
    assert document["deleted"] is True
    assert not any(Path(path).exists() for path in document["sessions"])
    assert [one["out"] for one in document["exports"]] == [str(tmp_path / "out")]
    assert len([path for path in folder.iterdir() if path.is_dir()]) == 2
    again = here("sessions", "withdraw", ANNA, "--sessions", folder, "--yes", "--json").document
    assert (again["deleted"], again["sessions"]) == (False, [])


@pytest.mark.parametrize(("typed", "deleted"), [(f"{ANNA}\n", True), ("yes\n", False), ("", False)])
def test_withdraw_asks_for_the_code(folder: Path, typed: str, deleted: bool) -> None:
    with patch("verbteach_tui.commands.sessions_people._at_terminal", return_value=True):
        ran = here("sessions", "withdraw", ANNA, "--sessions", folder, typed=typed)
    assert ran.status == 0
    assert ("deleted: 1" in ran.out) is deleted
    assert (len([path for path in folder.iterdir() if path.is_dir()]) == 2) is deleted


def test_split_writes_a_file_that_export_takes(folder: Path, tmp_path: Path) -> None:
    path = tmp_path / "splits.json"
    words = ("sessions", "split", folder, "--seed", 1, "--out", path)
    shares = ("--train", 0.4, "--validation", 0.3, "--test", 0.3)
    document = here(*words, *shares, "--json").document
    assert document == json.loads(path.read_text("utf-8"))
    assert sorted(len(document[part]) for part in ("train", "validation", "test")) == [1, 1, 1]
    assert_refused(here(*words), "--force")
    assert_refused(here(*words, "--force", "--train", 2), "add up to 1")
    out = tmp_path / "out"
    export = ("sessions", "export", folder, "--to", "jsonl", "--out", out)
    made = here(*export, "--splits", path, "--json").document
    assert "data/turns-validation.jsonl" in made["files"]


def test_datasheet_and_release(tmp_path: Path) -> None:
    folder, sheet = tmp_path / "sessions", tmp_path / "sheet.md"
    script = f"command: sing\nnote: {MAIL}\n"
    words = ("teach", "--teacher", "-", "--scene", "kitchen-1", "--sessions", folder)
    assert here(*words, typed=script).status == 0
    document = here("sessions", "datasheet", folder, "--out", sheet, "--json").document
    assert document["sessions"] == 1
    assert "Licence" in document["to_do"]
    ran = here("sessions", "release", folder, "--datasheet", sheet, "--json")
    assert ran.status == 1
    assert ran.document["ready"] is False
    assert {one["rule"] for one in ran.document["problems"]} == {"datasheet", "personal"}
    assert set(ran.document["problems"][0]) == {"rule", "session", "message"}
    assert "NOT READY" in here("sessions", "release", folder, "--datasheet", sheet).out
    assert here("sessions", "scan", folder, "--redact").status == 0
    sheet.write_text(sheet.read_text("utf-8").replace("TO DO", "done"), "utf-8")
    here("sessions", "datasheet", folder, "--out", sheet)
    ready = here("sessions", "release", folder, "--datasheet", sheet)
    assert (ready.status, ready.out) == (0, "ready\n")
