"""ConvoKit, ConvLab-3 and ParlAI, held against their published formats."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import pytest

from tests.sessions.corpora import ANNA, BEN
from verbteach_sessions.exports import convlab_folder, convokit_corpus, parlai_conversations
from verbteach_sessions.exports.alternating import alternating
from verbteach_sessions.exports.choices import episodes
from verbteach_sessions.exports.dialogue import Dialogue


def load(path: Path) -> Any:
    return json.loads(path.read_text("utf-8"))


@pytest.fixture(scope="module")
def convokit(tmp_path_factory: pytest.TempPathFactory, dialogues: tuple[Dialogue, ...]) -> Path:
    folder = tmp_path_factory.mktemp("convokit")
    convokit_corpus.write(dialogues, folder)
    return folder


@pytest.fixture(scope="module")
def convlab(tmp_path_factory: pytest.TempPathFactory, dialogues: tuple[Dialogue, ...]) -> Path:
    folder = tmp_path_factory.mktemp("convlab")
    parted = [replace(dialogues[0], split="test"), *dialogues[1:]]
    convlab_folder.write(parted, folder)
    return folder / "verbteach"


def utterances(folder: Path) -> list[dict[str, Any]]:
    lines = (folder / "utterances.jsonl").read_text("ascii").splitlines()
    return [json.loads(line) for line in lines]


def test_convokit_has_the_five_files(convokit: Path) -> None:
    # https://convokit.cornell.edu: "Data format"
    names = ["conversations.json", "corpus.json", "index.json", "speakers.json"]
    assert sorted(path.name for path in convokit.iterdir()) == [*names, "utterances.jsonl"]
    fields = {"id", "conversation_id", "text", "speaker", "meta", "reply-to", "timestamp"}
    for one in utterances(convokit):
        assert set(one) == fields | {"vectors"}
        assert isinstance(one["text"], str)
        assert isinstance(one["timestamp"], float)


def test_convokit_conversations_are_trees(convokit: Path, dialogues: tuple[Dialogue, ...]) -> None:
    by_id = {one["id"]: one for one in utterances(convokit)}
    assert len(by_id) == sum(len(dialogue.turns) for dialogue in dialogues)
    roots = [one for one in by_id.values() if one["reply-to"] is None]
    assert [root["id"] for root in roots] == [root["conversation_id"] for root in roots]
    assert set(load(convokit / "conversations.json")) == {root["id"] for root in roots}
    for one in by_id.values():
        if one["reply-to"] is not None:
            assert by_id[one["reply-to"]]["conversation_id"] == one["conversation_id"]


def test_convokit_index_names_every_metadatum_and_its_types(convokit: Path) -> None:
    index = load(convokit / "index.json")
    parts = {
        "utterances-index": [one["meta"] for one in utterances(convokit)],
        "conversations-index": [c["meta"] for c in load(convokit / "conversations.json").values()],
        "speakers-index": [s["meta"] for s in load(convokit / "speakers.json").values()],
        "overall-index": [load(convokit / "corpus.json")],
    }
    for name, metas in parts.items():
        for meta in metas:
            assert set(meta) == set(index[name])
            for key, value in meta.items():
                assert str(type(value)) in index[name][key]


def test_convokit_speakers_are_codes(convokit: Path) -> None:
    speakers = load(convokit / "speakers.json")
    assert {ANNA, BEN, "robot"} < set(speakers)
    assert len(speakers) == 4
    assert {one["speaker"] for one in utterances(convokit)} == set(speakers)


def test_convlab_has_the_published_layout(convlab: Path) -> None:
    # ConvLab-3, data/unified_datasets/README.md
    names = {"README.md", "preprocess.py", "data.zip", "dummy_data.json", "data"}
    assert {path.name for path in convlab.iterdir()} == names
    with ZipFile(convlab / "data.zip") as archive:
        assert sorted(archive.namelist()) == ["data/dialogues.json", "data/ontology.json"]
        dialogues = json.loads(archive.read("data/dialogues.json"))
        assert json.loads(archive.read("data/ontology.json")) == load(
            convlab / "data/ontology.json"
        )
        assert all(info.date_time[0] == 1980 for info in archive.infolist())
    assert dialogues == load(convlab / "data" / "dialogues.json")
    assert load(convlab / "dummy_data.json") == dialogues[:10]


def test_convlab_ontology(convlab: Path) -> None:
    ontology = load(convlab / "data" / "ontology.json")
    assert set(ontology) == {"domains", "intents", "dialogue_acts", "state"}
    for domain in ontology["domains"].values():
        assert domain["description"]
        for slot in domain["slots"].values():
            assert set(slot) == {"description", "is_categorical", "possible_values"}
            assert bool(slot["possible_values"]) is slot["is_categorical"]
    assert all(intent["description"] for intent in ontology["intents"].values())
    for domain, slots in ontology["state"].items():
        assert set(slots) <= set(ontology["domains"][domain]["slots"])
        assert set(slots.values()) == {""}
    for kind in ("categorical", "non-categorical", "binary"):
        for text in ontology["dialogue_acts"][kind]:
            act = ast.literal_eval(text)
            assert set(act) == {"user", "system", "intent", "domain", "slot"}


def test_convlab_dialogues(convlab: Path) -> None:
    dialogues, ontology = (load(convlab / "data" / f"{n}.json") for n in ("dialogues", "ontology"))
    ids = [one["dialogue_id"] for one in dialogues]
    assert ids == ["verbteach-test-0", "verbteach-train-0", "verbteach-train-1"]
    for dialogue in dialogues:
        prefix, split, _ = dialogue["dialogue_id"].split("-")
        assert (prefix, split) == (dialogue["dataset"], dialogue["data_split"])
        assert set(dialogue["domains"]) <= set(ontology["domains"])
        assert set(dialogue["goal"]) == {"description", "inform", "request"}
        for slots in dialogue["goal"]["inform"].values():
            assert all(slots.values())
        speakers = [turn["speaker"] for turn in dialogue["turns"]]
        assert all(a != b for a, b in pairwise(speakers))
        for index, turn in enumerate(dialogue["turns"]):
            assert turn["utt_idx"] == index
            assert ("state" in turn) is (turn["speaker"] == "user")
            assert ("db_results" in turn) is (turn["speaker"] == "system")
            check_acts(turn, ontology)


def check_acts(turn: dict[str, Any], ontology: dict[str, Any]) -> None:
    """Every act is in the ontology, with its speaker; every span is its value."""
    known: dict[tuple[str, ...], Any] = {}
    for kind, texts in ontology["dialogue_acts"].items():
        for act in map(ast.literal_eval, texts):
            known[kind, act["intent"], act["domain"], act["slot"]] = act
    for kind, acts in turn["dialogue_acts"].items():
        for act in acts:
            assert known[kind, act["intent"], act["domain"], act["slot"]][turn["speaker"]]
            assert act["intent"] in ontology["intents"]
            if kind != "binary":
                slots = ontology["domains"][act["domain"]]["slots"]
                assert slots[act["slot"]]["is_categorical"] is (kind == "categorical")
            if "start" in act:
                assert turn["utterance"][act["start"] : act["end"]] == act["value"]
    assert set(turn["dialogue_acts"]) == {"categorical", "non-categorical", "binary"}


def test_the_script_in_the_folder_packs_the_same_again(convlab: Path, tmp_path: Path) -> None:
    for name in ("data/dialogues.json", "data/ontology.json", "preprocess.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes((convlab / name).read_bytes())
    subprocess.run([sys.executable, "preprocess.py"], cwd=tmp_path, check=True, timeout=60)
    with ZipFile(tmp_path / "data.zip") as mine, ZipFile(convlab / "data.zip") as theirs:
        for name in theirs.namelist():
            assert mine.read(name) == theirs.read(name)
    assert load(tmp_path / "dummy_data.json") == load(convlab / "dummy_data.json")


def conversations(path: Path) -> Iterator[tuple[dict[str, Any], list[dict[str, Any]]]]:
    """As ParlAI's ``Conversations`` reads them: a line each, turns from pairs, in order."""
    for line in path.read_text("ascii").splitlines():
        conversation = json.loads(line)
        yield conversation, [act for pair in conversation["dialog"] for act in pair]


def test_parlai_conversations(tmp_path: Path, dialogues: tuple[Dialogue, ...]) -> None:
    # ParlAI, parlai/utils/conversations.py
    parlai_conversations.write(
        [*dialogues[:2], replace(dialogues[2], split="validation")], tmp_path
    )
    assert {path.name for path in tmp_path.iterdir()} == {
        "verbteach_train.jsonl",
        "verbteach_train.metadata",
        "verbteach_valid.jsonl",
        "verbteach_valid.metadata",
    }
    metadata = load(tmp_path / "verbteach_train.metadata")
    assert {"date", "opt", "self_chat", "speakers", "version"} <= set(metadata)
    found = list(conversations(tmp_path / "verbteach_train.jsonl"))
    for (conversation, turns), dialogue in zip(found, dialogues[:2], strict=True):
        said = [turn.text for turn in alternating(dialogue)]
        assert [one["text"] for one in (*conversation["context"], *turns)] == said
        assert {turn["id"] for turn in turns} == set(metadata["speakers"])
        for pair in conversation["dialog"][:-1]:
            assert [turn["id"] for turn in pair] == metadata["speakers"]


def test_two_turns_in_a_row_by_one_speaker_become_one(dialogues: tuple[Dialogue, ...]) -> None:
    dialogue = dialogues[1]
    robot = dialogue.turns[0]
    again = replace(robot, texts=("I am here again.",))
    made = alternating(replace(dialogue, turns=(robot, again, *dialogue.turns[1:])))
    assert len(made) == len(dialogue.held)
    assert made[0].text == f"{robot.text} I am here again."


def test_episodes_earn_what_the_record_says(dialogues: tuple[Dialogue, ...]) -> None:
    for dialogue in dialogues:
        for episode in episodes(dialogue):
            turns = [t for t in dialogue.held if t.command == episode.command]
            rewards = [turn.reward for turn in turns if turn.reward is not None]
            assert sum(step.reward for step in episode.steps) == pytest.approx(sum(rewards))
            assert episode.closed is any("close_episode" in turn.act_names for turn in turns)
