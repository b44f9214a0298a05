"""ConvLab-3's unified format: dialogues, an ontology of their acts, and the first ten to look at.

The published layout is a folder named after the dataset, for ``data/unified_datasets``;
the script in it makes ``data.zip`` again from ``data``, as the format's check wants.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from verbteach_sessions.exports.alternating import alternating
from verbteach_sessions.exports.convlab_acts import DOMAIN, Acts, ontology, state
from verbteach_sessions.exports.dialogue import TEACHER, Dialogue
from verbteach_sessions.exports.folder import write_json, write_text

NAME = "verbteach"
_DUMMY = 10
_DATA = ("dialogues", "ontology")


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``verbteach/`` with ``data.zip``, ``dummy_data.json``, ``README.md`` and the script."""
    home, acts = folder / NAME, Acts()
    count: Counter[str] = Counter()
    made = []
    for dialogue in dialogues:
        number = count[dialogue.split]
        count[dialogue.split] += 1
        made.append(_dialogue(dialogue, f"{NAME}-{dialogue.split}-{number}", acts))
    write_json(home / "data" / "dialogues.json", made)
    write_json(home / "data" / "ontology.json", ontology(acts))
    write_json(home / "dummy_data.json", made[:_DUMMY])
    _zip(home)
    write_text(home / "preprocess.py", _SCRIPT)
    write_text(home / "README.md", _readme(count))


def _dialogue(dialogue: Dialogue, key: str, acts: Acts) -> dict[str, Any]:
    turns = alternating(dialogue)
    commands = [t.text for t in turns if t.speaker == TEACHER and t.act_names == ("command",)]
    inform = "|".join(text.replace("|", "/") for text in commands if text)
    said = [
        {
            "speaker": "user" if turn.speaker == TEACHER else "system",
            "utterance": turn.text,
            "utt_idx": index,
            "dialogue_acts": acts.of(turn),
            **({"state": state(turn)} if turn.speaker == TEACHER else {"db_results": {}}),
        }
        for index, turn in enumerate(turns)
    ]
    return {
        "dataset": NAME,
        "data_split": dialogue.split,
        "dialogue_id": key,
        "original_id": dialogue.id,
        "domains": [DOMAIN],
        "goal": {
            "description": f"Have the robot do: {'; '.join(commands)}." if commands else "",
            "inform": {DOMAIN: {"command": inform}} if inform else {},
            "request": {},
        },
        "participant": dialogue.participant,
        "turns": said,
    }


def _zip(home: Path) -> None:
    """The zipped folder ``data``, its files dated to where the format's calendar begins."""
    with ZipFile(home / "data.zip", "w", ZIP_DEFLATED) as archive:
        for name in _DATA:
            path = f"data/{name}.json"
            entry = ZipInfo(path, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = ZIP_DEFLATED
            archive.writestr(entry, (home / path).read_bytes())


def _readme(count: Mapping[str, int]) -> str:
    return "\n".join(_lines(count)) + "\n"


def _lines(count: Mapping[str, int]) -> Iterator[str]:
    yield from ("# Dataset Card for verbteach", "", "## Dataset Summary", "")
    yield "People (or a program standing in for one) teach a simulated household robot verbs."
    yield "`user` is the teacher, `system` the robot. A session is a dialogue; what the teacher"
    yield "took back is left out. Exported by verbteach; `original_id` is the session's alias."
    yield from ("", "- How to get the transformed data: `python preprocess.py` packs `data/`.")
    yield "- Annotations: user goal, dialogue acts, state. No database."
    yield from ("", "## Data Splits", "", "| split | dialogues |", "|---|---|")
    yield from (f"| {split} | {count[split]} |" for split in sorted(count))


_SCRIPT = f'''"""Packs the folder data into data.zip, its first dialogues into dummy_data.json."""

import json
from zipfile import ZIP_DEFLATED, ZipFile


def preprocess():
    with open("data/dialogues.json", encoding="utf-8") as file:
        dialogues = json.load(file)
    with open("dummy_data.json", "w", encoding="utf-8") as file:
        json.dump(dialogues[:{_DUMMY}], file, ensure_ascii=False, indent=2)
    with ZipFile("data.zip", "w", ZIP_DEFLATED) as archive:
        for name in {json.dumps(_DATA)}:
            archive.write(f"data/{{name}}.json")


if __name__ == "__main__":
    preprocess()
'''
