"""JSON Lines and CSV: every row is of the schema that ships, and reads back as it was."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

from jsonschema import Draft202012Validator

from tests.sessions.corpora import ANNA, BEN, NASTY
from verbteach_sessions.exports import csv_table, jsonl_dataset
from verbteach_sessions.exports.columns import SESSIONS, TURNS, session_row, turn_rows
from verbteach_sessions.exports.dialogue import Dialogue

PARTS = ("train", "validation", "test")


def lines(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text("utf-8").splitlines()]


def test_jsonl_is_of_its_schema(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    jsonl_dataset.write(dialogues, tmp_path)
    for table, count in ((TURNS, sum(len(d.turns) for d in dialogues)), (SESSIONS, 3)):
        schema = json.loads((tmp_path / "schema" / f"{table.name}.schema.json").read_text("utf-8"))
        Draft202012Validator.check_schema(schema)
        validator = Draft202012Validator(schema)
        rows = lines(tmp_path / "data" / f"{table.name}-train.jsonl")
        assert len(rows) == count
        for row in rows:
            validator.validate(row)
            assert list(row) == [column.name for column in table.columns]
        assert not validator.is_valid({**rows[0], "another": 1})
        assert not validator.is_valid({**rows[0], "session": None})


def test_jsonl_says_all_of_a_decision(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    jsonl_dataset.write(dialogues, tmp_path)
    rows = lines(tmp_path / "data" / "turns-train.jsonl")
    decisions = [decision for row in rows for decision in row["decisions"]]
    assert decisions
    for decision in decisions:
        assert 0 <= decision["chosen"] < len(decision["candidates"])
        assert 0 < decision["propensity"] <= 1
    row = next(row for row in rows if row["text"] == NASTY[0])
    assert (row["kind"], row["speaker"]) == ("note", "teacher")


def test_each_split_has_its_files(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    parted = [replace(one, split=part) for one, part in zip(dialogues, PARTS, strict=True)]
    jsonl_dataset.write(parted, tmp_path)
    people = {
        path.name: {row["participant"] for row in lines(path)}
        for path in sorted((tmp_path / "data").glob("sessions-*.jsonl"))
    }
    assert people == {
        "sessions-test.jsonl": {None},
        "sessions-train.jsonl": {ANNA},
        "sessions-validation.jsonl": {BEN},
    }


def test_the_card_leads_with_what_the_hub_reads(
    tmp_path: Path, dialogues: tuple[Dialogue, ...]
) -> None:
    jsonl_dataset.write(dialogues, tmp_path)
    text = (tmp_path / "README.md").read_text("utf-8")
    front = text.split("---\n")[1]
    assert "license: unknown" in front
    paths = [line.split(": ", 1)[1] for line in front.splitlines() if "path: " in line]
    assert sorted(paths) == ["data/sessions-train.jsonl", "data/turns-train.jsonl"]
    assert all((tmp_path / path).is_file() for path in paths)
    assert "1 of 3 sessions were taught by a program" in text
    for column in (*TURNS.columns, *SESSIONS.columns):
        assert f"| `{column.name}` |" in text


def test_csv_reads_back(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    csv_table.write(dialogues, tmp_path)
    with (tmp_path / "turns.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    expected = [row for dialogue in dialogues for row in turn_rows(dialogue)]
    assert [row["id"] for row in rows] == [row["id"] for row in expected]
    for got, row in zip(rows, expected, strict=True):
        assert json.loads(got["acts"]) == row["acts"]
        assert float(got["at"]) == row["at"]
        assert got["text"].removeprefix("'") == row["text"]
    with (tmp_path / "sessions.csv").open(encoding="utf-8", newline="") as file:
        sessions = list(csv.DictReader(file))
    assert [one["session"] for one in sessions] == [d.id for d in dialogues]
    assert json.loads(sessions[0]["verbs_learned"]) == session_row(dialogues[0])["verbs_learned"]


def test_no_cell_of_csv_is_a_formula(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    csv_table.write(dialogues, tmp_path)
    with (tmp_path / "turns.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    formulas = [row["text"] for row in rows if "HYPERLINK" in row["text"]]
    assert formulas == [f"'{NASTY[1]}"]
    numbers = {"reward", "price_yes", "price_other"}
    for row in rows:
        cells = [cell for name, cell in row.items() if name not in numbers]
        assert not any(cell.startswith(("=", "+", "-", "@")) for cell in cells)
