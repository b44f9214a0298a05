"""A ConvoKit corpus: utterances, speakers, conversations, the corpus, and an index of all metadata.

A session is a conversation. Turns that an undo took back are in it, as branches
that the teacher left; their ``holds`` is false.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from verbteach_sessions.exports.columns import session_row, turn_id, turn_rows
from verbteach_sessions.exports.dialogue import ROBOT, TEACHER, Dialogue

_NOT_META = frozenset({"id", "text", "at", "reply_to", "speaker", "participant", "texts"})


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write the five files."""
    index = _Index()
    speakers: dict[str, dict[str, Any]] = {ROBOT: _speaker(ROBOT)}
    conversations = {}
    with (folder / "utterances.jsonl").open("w", encoding="ascii") as file:
        for dialogue in dialogues:
            about = {**session_row(dialogue), "totals": dict(dialogue.totals)}
            root = turn_id(dialogue, dialogue.turns[0].number)
            conversations[root] = index.noted("conversations", about)
            speakers[dialogue.person] = _speaker(TEACHER, dialogue.participant, dialogue.teacher)
            for utterance in _utterances(dialogue, root, index):
                file.write(json.dumps(utterance, allow_nan=False) + "\n")
    for meta in speakers.values():
        index.noted("speakers", meta)
    corpus = index.noted("overall", {"name": "verbteach", "sessions": len(conversations)})
    _write(folder / "speakers.json", _with_vectors(speakers))
    _write(folder / "conversations.json", _with_vectors(conversations))
    _write(folder / "corpus.json", corpus)
    _write(folder / "index.json", index.document)


def _speaker(
    role: str, participant: str | None = None, teacher: str | None = None
) -> dict[str, Any]:
    """``teacher``: a person, or a program standing in for one; null for the robot."""
    return {"role": role, "participant": participant, "teacher": teacher}


def _utterances(dialogue: Dialogue, root: str, index: _Index) -> Iterable[dict[str, Any]]:
    before: str | None = None
    for turn, row in zip(dialogue.turns, turn_rows(dialogue), strict=True):
        meta = {name: value for name, value in row.items() if name not in _NOT_META}
        yield {
            "id": row["id"],
            "conversation_id": root,
            "text": turn.text,
            "speaker": ROBOT if turn.speaker == ROBOT else dialogue.person,
            "meta": index.noted("utterances", meta),
            # A conversation has one root: a scene that began anew follows on what came before.
            "reply-to": row["reply_to"] or before,
            "timestamp": turn.at,
            "vectors": [],
        }
        before = row["id"]


class _Index:
    """Which metadata there is, and of which types: what it does not name is dropped on loading."""

    def __init__(self) -> None:
        self._types: dict[str, dict[str, set[str]]] = {
            name: {} for name in ("utterances", "speakers", "conversations", "overall")
        }

    def noted(self, part: str, meta: Mapping[str, Any]) -> dict[str, Any]:
        """The metadata, its types noted."""
        for name, value in meta.items():
            self._types[part].setdefault(name, set()).add(str(type(value)))
        return dict(meta)

    @property
    def document(self) -> dict[str, Any]:
        """What ``index.json`` says."""
        named = {
            f"{part}-index": {name: sorted(kinds) for name, kinds in types.items()}
            for part, types in self._types.items()
        }
        return {**named, "vectors": [], "version": 1}


def _with_vectors(metas: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    return {key: {"meta": meta, "vectors": []} for key, meta in metas.items()}


def _write(path: Path, value: Any) -> None:
    path.write_text(json.dumps(value, allow_nan=False), encoding="ascii")
