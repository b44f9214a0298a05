"""Exports loaded by the libraries that they are for, where those are installed.

Slow: these libraries take long to import. ConvoKit runs in a process of its own,
since importing it warns of this and that.
"""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.sessions.corpora import ANNA, BEN
from verbteach_sessions.exports import (
    asciicast,
    convokit_corpus,
    minari_dataset,
    parquet_file,
)
from verbteach_sessions.exports.choices import episodes
from verbteach_sessions.exports.columns import session_row, turn_rows
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.lines import spoken_lines

pytestmark = pytest.mark.slow


def needed(package: str) -> None:
    """Skip, and say why, where the library is not installed."""
    if importlib.util.find_spec(package) is None:
        pytest.skip(f"{package} is not installed here, so it does not load the export")


def python(program: str, *arguments: object, **environment: str) -> Any:
    """What a program prints as JSON in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", program, *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
        env={"PATH": "", "PYTHONPATH": os.environ.get("PYTHONPATH", ""), **environment},
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


CONVOKIT = """
import json, sys
from convokit import Corpus
corpus = Corpus(filename=sys.argv[1])
print(json.dumps({
    "utterances": {u.id: [u.text, u.speaker.id, u.reply_to, u.meta["kind"], u.meta["reward"]]
                   for u in corpus.iter_utterances()},
    "conversations": [
        [len(c.get_utterance_ids()), c.meta["scene"], c.check_integrity(verbose=False)]
        for c in corpus.iter_conversations()
    ],
    "speakers": sorted(s.id for s in corpus.iter_speakers()),
    "name": corpus.meta["name"],
}))
"""


def test_convokit(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("convokit")
    convokit_corpus.write(dialogues, tmp_path)
    loaded = python(CONVOKIT, tmp_path, HOME=str(tmp_path))
    rows = [row for dialogue in dialogues for row in turn_rows(dialogue)]
    assert set(loaded["utterances"]) == {row["id"] for row in rows}
    for row in rows:
        text, _, reply, kind, reward = loaded["utterances"][row["id"]]
        assert [text, reply, kind, reward] == [
            row["text"],
            row["reply_to"],
            row["kind"],
            row["reward"],
        ]
    assert loaded["conversations"] == [[len(d.turns), d.scene, True] for d in dialogues]
    assert {ANNA, BEN, "robot"} < set(loaded["speakers"])
    assert loaded["name"] == "verbteach"


def test_parquet(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("pyarrow")
    import pyarrow.parquet as pq

    parquet_file.write(dialogues, tmp_path)
    turns = pq.read_table(tmp_path / "turns.parquet").to_pylist()
    assert turns == [row for dialogue in dialogues for row in turn_rows(dialogue)]
    sessions = pq.read_table(tmp_path / "sessions.parquet").to_pylist()
    assert sessions == [session_row(dialogue) for dialogue in dialogues]
    schema = pq.read_schema(tmp_path / "turns.parquet")
    assert schema.field("text").metadata[b"description"] == b"what was said"


MINARI = """
import json, warnings
import minari
dataset = minari.load_dataset("verbteach/teaching-v0")
print(json.dumps({
    "episodes": [[len(e.rewards), [float(r) for r in e.rewards], [int(a) for a in e.actions],
                  [float(p) for p in e.infos["propensity"]], bool(e.terminations[-1]),
                  bool(e.truncations[-1]), list(e.observations["features"].shape),
                  bool(all(e in dataset.observation_space for e in [
                      {k: v[0] for k, v in e.observations.items()}]))]
                 for e in dataset.iterate_episodes()],
    "steps": int(dataset.total_steps),
    "listed": list(minari.list_local_datasets()),
    "description": json.loads(dataset.storage.metadata["description"]),
}))
"""


def test_minari(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    needed("minari")
    minari_dataset.write(dialogues, tmp_path)
    loaded = python(MINARI, MINARI_DATASETS_PATH=str(tmp_path), HOME=str(tmp_path))
    expected = [episode for dialogue in dialogues for episode in episodes(dialogue)]
    assert loaded["listed"] == ["verbteach/teaching-v0"]
    assert loaded["steps"] == sum(len(episode.steps) for episode in expected)
    names = loaded["description"]["features"]
    for got, episode in zip(loaded["episodes"], expected, strict=True):
        count, rewards, actions, propensity, terminated, truncated, shape, fits = got
        assert count == len(episode.steps)
        assert rewards == [step.reward for step in episode.steps]
        assert actions == [step.chosen for step in episode.steps]
        assert propensity[:-1] == [step.propensity for step in episode.steps]
        assert (terminated, truncated) == (episode.closed, not episode.closed)
        assert shape[0] == count + 1
        assert shape[2] == len(names)
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
