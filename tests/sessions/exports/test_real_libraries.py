"""Exports loaded as the page on them says, by the libraries that they are for, where installed.

Slow: these libraries take long to import. Each runs in a process of its own,
since importing some of them warns of this and that.
"""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from docs.diagrams import ROOT
from verbteach_sessions.exports import asciicast, parquet_file
from verbteach_sessions.exports.choices import episodes
from verbteach_sessions.exports.columns import Row, session_row, turn_rows
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.formats import FORMATS
from verbteach_sessions.exports.lines import spoken_lines

PAGE = (ROOT / "docs" / "exports.md").read_text("utf-8")

pytestmark = pytest.mark.slow


def needed(package: str) -> None:
    """Skip, and say why, where the library is not installed."""
    if importlib.util.find_spec(package) is None:
        pytest.skip(f"{package} is not installed here, so it does not load the export")


def typed(form: str, tail: str, folder: Path) -> Any:
    """What ``tail`` prints as JSON after what the page has one type to read a format."""
    section = PAGE.split(f"\n### {form}\n")[1].split("\n##")[0]
    (snippet,) = re.findall(r"```python\n(.*?)```", section, re.DOTALL)
    own = {"HOME": str(folder), "HF_HOME": str(folder), "HF_HUB_OFFLINE": "1"}
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", f"{snippet}\nimport json\n{tail}"],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
        cwd=folder,
        env={"PATH": "", "PYTHONPATH": os.environ.get("PYTHONPATH", ""), **own},
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


def written(form: str, dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Export to the folder that the page names."""
    (name,) = re.findall(rf"`verbteach sessions export \S+ --to {form} --out (\w+)", PAGE)
    (folder / name).mkdir()
    module = import_module(f"verbteach_sessions.exports.{FORMATS[form].module}")
    module.write(dialogues, folder / name)


def rows_of(dialogues: Iterable[Dialogue]) -> list[Row]:
    return [row for dialogue in dialogues for row in turn_rows(dialogue)]


def test_datasets(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("datasets")
    first, second, last = dialogues
    # What no session of one split has is there in another.
    branch = replace(second, split="test", parent=(first.id, 3), source=first.id)
    parts = (first, branch, replace(last, split="validation"))
    written("jsonl", parts, tmp_path)
    loaded = typed(
        "jsonl",
        """
turns, sessions = ({part: list(rows) for part, rows in one.items()} for one in (turns, sessions))
print(json.dumps([turns, sessions, [turn["id"] for turn in questions]]))
""",
        tmp_path,
    )
    turns, sessions, questions = loaded
    for dialogue in parts:
        assert turns[dialogue.split] == turn_rows(dialogue)
        assert sessions[dialogue.split] == [session_row(dialogue)]
    assert questions == [row["id"] for row in turn_rows(first) if row["question"]]


def test_convokit(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("convokit")
    written("convokit", dialogues, tmp_path)
    loaded = typed(
        "convokit",
        """
print(json.dumps({
    "utterances": {u.id: [u.text, u.speaker.id, u.reply_to, u.meta["kind"], u.meta["reward"]]
                   for u in corpus.iter_utterances()},
    "conversations": [
        [len(c.get_utterance_ids()), c.meta["scene"], c.check_integrity(verbose=False)]
        for c in corpus.iter_conversations()
    ],
    "teachers": {one.id: one.meta["teacher"] for one in teachers},
    "rows": len(said),
    "name": corpus.meta["name"],
}))
""",
        tmp_path,
    )
    rows = rows_of(dialogues)
    assert set(loaded["utterances"]) == {row["id"] for row in rows}
    assert loaded["rows"] == len(rows)
    for row in rows:
        text, speaker, *others = loaded["utterances"][row["id"]]
        assert text == row["text"]
        assert others == [row["reply_to"], row["kind"], row["reward"]]
        assert speaker == "robot" or speaker == row["participant"] or not row["participant"]
    assert loaded["conversations"] == [[len(d.turns), d.scene, True] for d in dialogues]
    assert loaded["teachers"] == {one.person: one.teacher for one in dialogues}
    assert loaded["name"] == "verbteach"


def test_pandas_reads_parquet(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("pandas")
    written("parquet", dialogues, tmp_path)
    tail = """
columns = ["id", "participant", "text", "at"]
turns = turns[columns].astype(object).where(turns[columns].notna(), None)
print(json.dumps([turns.values.tolist(), list(sessions["session"]), earned.to_dict()]))
"""
    turns, sessions, earned = typed("parquet", tail, tmp_path)
    expected = [[row[n] for n in ("id", "participant", "text", "at")] for row in rows_of(dialogues)]
    assert turns == expected
    assert sessions == [dialogue.id for dialogue in dialogues]
    for dialogue in dialogues:
        assert earned[dialogue.id] == sum(turn.reward or 0 for turn in dialogue.turns)


def test_pandas_reads_csv(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("pandas")
    first = dialogues[0]
    odd = tuple(replace(turn, texts=("NA",)) for turn in first.turns)
    dialogues = (replace(first, id="12345678", turns=odd), *dialogues[1:])
    written("csv", dialogues, tmp_path)
    tail = """
columns = ["session", "text", "acts", "holds"]
print(json.dumps([turns[columns].values.tolist(), turns["reward"].sum()]))
"""
    turns, reward = typed("csv", tail, tmp_path)
    rows = rows_of(dialogues)
    for (session, text, acts, holds), row in zip(turns, rows, strict=True):
        assert [session, acts, holds] == [row["session"], row["acts"], row["holds"]]
        assert text.removeprefix("'") == row["text"]
    assert reward == sum(row["reward"] or 0 for row in rows)


def test_parquet_says_what_its_columns_mean(
    tmp_path: Path, dialogues: tuple[Dialogue, ...]
) -> None:
    needed("pyarrow")
    import pyarrow.parquet as pq

    parquet_file.write(dialogues, tmp_path)
    turns = pq.read_table(tmp_path / "turns.parquet").to_pylist()
    assert turns == rows_of(dialogues)
    sessions = pq.read_table(tmp_path / "sessions.parquet").to_pylist()
    assert sessions == [session_row(dialogue) for dialogue in dialogues]
    schema = pq.read_schema(tmp_path / "turns.parquet")
    assert schema.field("text").metadata[b"description"] == b"what was said"


def test_minari(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("minari")
    written("minari", dialogues, tmp_path)
    loaded = typed(
        "minari",
        """
print(json.dumps({
    "episodes": [[len(e.rewards), [float(r) for r in e.rewards], [int(a) for a in e.actions],
                  [float(p) for p in e.infos["propensity"]], bool(e.terminations[-1]),
                  bool(e.truncations[-1]), list(e.observations["features"].shape),
                  bool(all(e in dataset.observation_space for e in [
                      {k: v[0] for k, v in e.observations.items()}]))]
                 for e in episodes],
    "steps": int(dataset.total_steps),
    "listed": list(minari.list_local_datasets()),
    "features": features,
    "about": about,
    "asked_by": dataset.storage.metadata["algorithm_name"],
}))
""",
        tmp_path,
    )
    expected = [episode for dialogue in dialogues for episode in episodes(dialogue)]
    assert loaded["listed"] == ["verbteach/teaching-v0"]
    assert loaded["steps"] == sum(len(episode.steps) for episode in expected)
    assert loaded["about"] == [episode.about for episode in expected]
    assert loaded["asked_by"] == ", ".join(sorted({one.policy for one in dialogues}))
    for got, episode in zip(loaded["episodes"], expected, strict=True):
        count, rewards, actions, propensity, terminated, truncated, shape, fits = got
        assert count == len(episode.steps)
        assert rewards == [step.reward for step in episode.steps]
        assert actions == [step.chosen for step in episode.steps]
        assert propensity[:-1] == [step.propensity for step in episode.steps]
        assert (terminated, truncated) == (episode.closed, not episode.closed)
        assert shape[0] == count + 1
        assert shape[2] == len(loaded["features"])
        assert fits


def test_asciinema(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("asciinema")
    asciicast.write(dialogues[:1], tmp_path)
    done = subprocess.run(
        [sys.executable, "-m", "asciinema", "cat", str(tmp_path / f"{dialogues[0].id}.cast")],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        env={"PATH": "", "HOME": str(tmp_path), "LANG": "C.UTF-8"},
    )
    assert done.returncode == 0, done.stderr
    words = "".join(done.stdout.split())
    for line in spoken_lines(dialogues[0]):
        assert "".join(line.text.split()) in words.replace("\x1b[0m", "")
