from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from verbteach.experiments.reproduction.rows import Command, Row
from verbteach_scenarios.rows_file import RowsFile, RowsFileError, write_csv

COMMAND = Command("i1", "document, 1", 0.5, 1.0, True, 0.9, 1, 2, 3, ((0.0, 0.25), (0.5, 1.0)))
ROW = Row(
    {"policy": "rl", "noise": "std3", "reading": "literal", "run": 0},
    (COMMAND, COMMAND._replace(instance="i2")),
    {"ground": 0.5, "env": 1.0, "goal": 0.0},
    10,
    0.75,
    seconds=1.5,
)
OTHER = replace(ROW, settings={**ROW.settings, "run": 1})


def test_rows_are_read_back_in_order(tmp_path: Path) -> None:
    file = RowsFile(tmp_path / "rows.jsonl")
    assert file.read() == ()
    file.append(ROW)
    file.append(OTHER)
    assert RowsFile(file.path).read() == (ROW, OTHER)


@pytest.mark.parametrize("kept", [0, 1, 50, -2, -1])
def test_what_a_crash_left_of_a_row_gives_way_to_the_next(tmp_path: Path, kept: int) -> None:
    file = RowsFile(tmp_path / "rows.jsonl")
    file.append(ROW)
    whole = file.path.read_bytes()
    file.append(OTHER)
    torn = file.path.read_bytes()[len(whole) :][:kept]
    file.path.write_bytes(whole + torn)
    assert file.read() == (ROW,)
    file.append(OTHER)
    assert file.read() == (ROW, OTHER)


def test_a_broken_row_before_the_last_is_named_with_its_line(tmp_path: Path) -> None:
    file = RowsFile(tmp_path / "rows.jsonl")
    file.append(ROW)
    file.path.write_bytes(b"nonsense\n" + file.path.read_bytes())
    with pytest.raises(RowsFileError, match=r"rows\.jsonl:1"):
        file.read()


def test_the_csv_has_a_line_a_command(tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    write_csv(path, {"main": [ROW], "phantom": [OTHER]})
    head, first, *others = path.read_text("utf-8").splitlines()
    assert head.startswith("section,policy,noise,noise_reading,run,lessons,document")
    assert first == 'main,rl,std3,literal,0,10,"document, 1",i1,0.5,1.0,1,1,2,3,6'
    assert len(others) == 3
    assert others[-1].startswith("phantom,")
