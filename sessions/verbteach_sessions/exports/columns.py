"""The two tables that dialogues make: one row a session, one row a turn.

JSON Lines, Parquet and CSV all write these columns; the card and the JSON
Schema are made from them as well.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

from verbteach_sessions.exports.dialogue import Dialogue, Turn
from verbteach_sessions.exports.kinds import (
    FLAG,
    INTEGER,
    NUMBER,
    TEXT,
    Group,
    Kind,
    Many,
    Maybe,
    json_schema,
)

Row: TypeAlias = dict[str, Any]


class Column(NamedTuple):
    """A column: its name, its type, what it means, and how it is got from a turn or session."""

    name: str
    kind: Kind
    meaning: str
    value: Callable[..., Any]


class Table(NamedTuple):
    """A table by name, and what one row of it is."""

    name: str
    meaning: str
    columns: Sequence[Column]

    @property
    def schema(self) -> dict[str, Any]:
        """JSON Schema of a row."""
        row = json_schema(Group({column.name: column.kind for column in self.columns}))
        for column in self.columns:
            row["properties"][column.name]["description"] = column.meaning
        return {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": self.name,
            "description": self.meaning,
            **row,
        }


def json_text(value: Any) -> str:
    """A value whose members differ from row to row, as JSON text."""
    return json.dumps(value, ensure_ascii=False, sort_keys=True, allow_nan=False)


def turn_id(dialogue: Dialogue, number: int) -> str:
    """The id of a turn in every export."""
    return f"{dialogue.id}:{number}"


_ACT = Group({"act": TEXT, "arguments": TEXT})
_FEATURE = Group({"name": TEXT, "value": NUMBER})
_CANDIDATE = Group({"act": TEXT, "arguments": TEXT, "q": Maybe(NUMBER), "features": Many(_FEATURE)})
_DECISION = Group(
    {
        "chosen": INTEGER,
        "propensity": NUMBER,
        "explored": FLAG,
        "reason": TEXT,
        "candidates": Many(_CANDIDATE),
    }
)
_OBJECT = Group({"object": TEXT, "probability": NUMBER})
_BELIEFS = Group(
    {
        "grounding": Many(Group({"phrase": TEXT, "objects": Many(_OBJECT)})),
        "goals": Many(Group({"goal": Many(TEXT), "share": NUMBER})),
        "uncertain": Many(Group({"fluent": TEXT, "confidence": NUMBER})),
    }
)
_TRACE = Group({"done": Many(TEXT), "failed": Maybe(TEXT), "obstacle": TEXT})


def _act(act: Mapping[str, Any]) -> Row:
    arguments = {key: value for key, value in act.items() if key != "act"}
    return {"act": str(act.get("act")), "arguments": json_text(arguments)}


def _decision(decision: Mapping[str, Any]) -> Row:
    scalars = ("chosen", "propensity", "explored", "reason")
    candidates = [_candidate(one) for one in decision["candidates"]]
    return {**{name: decision[name] for name in scalars}, "candidates": candidates}


def _candidate(candidate: Mapping[str, Any]) -> Row:
    features = candidate["features"]
    named = [{"name": name, "value": features[name]} for name in sorted(features)]
    return {**_act(candidate["act"]), "q": candidate["q"], "features": named}


def _beliefs(beliefs: Mapping[str, Any] | None) -> Row | None:
    if beliefs is None:
        return None
    return {
        "grounding": [
            {
                "phrase": phrase["phrase"],
                "objects": [{"object": key, "probability": p} for key, p in phrase["objects"]],
            }
            for phrase in beliefs["grounding"]
        ],
        "goals": [{"goal": list(one["goal"]), "share": one["share"]} for one in beliefs["goals"]],
        "uncertain": [{"fluent": text, "confidence": p} for text, p in beliefs["uncertain"]],
    }


def _trace(trace: Mapping[str, Any] | None) -> Row | None:
    if trace is None:
        return None
    return {name: trace[name] for name in ("done", "failed", "obstacle")}


def _price(answered_yes: bool) -> Callable[[Dialogue, Turn], float | None]:
    def price(dialogue: Dialogue, turn: Turn) -> float | None:
        pair = dialogue.prices.get(turn.question or "")
        return None if pair is None else pair[0 if answered_yes else 1]

    return price


def _reply(dialogue: Dialogue, turn: Turn) -> str | None:
    return None if turn.reply_to is None else turn_id(dialogue, turn.reply_to)


TURNS = Table(
    "turns",
    "What the robot or the teacher said or did at one point of a session.",
    (
        Column("id", TEXT, "session and number, joined", lambda d, t: turn_id(d, t.number)),
        Column("session", TEXT, "the session's alias", lambda d, t: d.id),
        Column(
            "participant",
            Maybe(TEXT),
            "the random code of the person who teaches, in the robot's turns as well",
            lambda d, t: d.participant,
        ),
        Column("number", INTEGER, "place in the session, from 0", lambda d, t: t.number),
        Column("event", INTEGER, "number of the event in the record", lambda d, t: t.seq),
        Column("reply_to", Maybe(TEXT), "id of the turn it replies to", _reply),
        Column("speaker", TEXT, "`robot` or `teacher`", lambda d, t: t.speaker),
        Column(
            "kind",
            TEXT,
            "`robot`, `teacher`, or an act about the session: `undo`, `redo`, `flag`, `note`,"
            " `why`, `repeat`",
            lambda d, t: t.kind,
        ),
        Column("holds", FLAG, "false where an undo took it back", lambda d, t: t.holds),
        Column("at", NUMBER, "seconds since the session began", lambda d, t: t.at),
        Column(
            "answer_seconds",
            Maybe(NUMBER),
            "seconds from the robot's turn showing to the teacher acting",
            lambda d, t: t.answer_seconds,
        ),
        Column("scene", TEXT, "where the robot is", lambda d, t: t.scene),
        Column(
            "command",
            Maybe(INTEGER),
            "which of the session's commands it belongs to, from 0",
            lambda d, t: t.command,
        ),
        Column(
            "phase",
            TEXT,
            "what the robot waits for: after its own turn, or as the teacher acts",
            lambda d, t: t.phase,
        ),
        Column("text", TEXT, "what was said", lambda d, t: t.text),
        Column(
            "acts",
            Many(_ACT),
            "the acts, the last one waits; their arguments as JSON text",
            lambda d, t: [_act(act) for act in t.acts],
        ),
        Column("texts", Many(TEXT), "the wording of each act", lambda d, t: list(t.texts)),
        Column("question", Maybe(TEXT), "the question it ends with", lambda d, t: t.question),
        Column("price_yes", Maybe(NUMBER), "what the question costs, answered yes", _price(True)),
        Column("price_other", Maybe(NUMBER), "what it costs otherwise", _price(False)),
        Column("raw", TEXT, "what was typed, or the key, as it came", lambda d, t: t.raw),
        Column("via", TEXT, "how it came, such as `typed` or `key`", lambda d, t: t.via),
        Column("reading", TEXT, "how the robot read the teacher's act", lambda d, t: t.reading),
        Column("reward", Maybe(NUMBER), "what the act replied to earned", lambda d, t: t.reward),
        Column(
            "decisions",
            Many(_DECISION),
            "the robot's choices: every candidate with features and Q, the chosen one's index and"
            " its probability",
            lambda d, t: [_decision(one) for one in t.decisions],
        ),
        Column("beliefs", Maybe(_BELIEFS), "what it believed", lambda d, t: _beliefs(t.beliefs)),
        Column("trace", Maybe(_TRACE), "a plan carried out", lambda d, t: _trace(t.trace)),
        Column(
            "learned",
            Maybe(TEXT),
            "the hypothesis spaces and meanings that came in, as JSON text",
            lambda d, t: None if t.learned is None else json_text(t.learned),
        ),
        Column("world", TEXT, "SHA-256 of the true world afterwards", lambda d, t: t.world),
        Column(
            "verbs_learned", Many(TEXT), "the verbs known by then", lambda d, t: [*t.verbs_learned]
        ),
    ),
)

SESSIONS = Table(
    "sessions",
    "A teaching session.",
    (
        Column("session", TEXT, "its alias, which tells no time of day", lambda d: d.id),
        Column("split", TEXT, "`train`, `validation` or `test`", lambda d: d.split),
        Column("participant", Maybe(TEXT), "the person's random code", lambda d: d.participant),
        Column("teacher", TEXT, "`human`, `simulated` or `script`", lambda d: d.teacher),
        Column("interface", TEXT, "such as `app` or `plain`", lambda d: d.interface),
        Column("scene", TEXT, "the scene it began in", lambda d: d.scene),
        Column("policy", TEXT, "the question policy", lambda d: d.policy),
        Column("seed", INTEGER, "the seed of every random draw", lambda d: d.seed),
        Column("noise", TEXT, "the noise model, as JSON text", lambda d: json_text(d.noise)),
        Column("method", TEXT, "policy and parameters, JSON text", lambda d: json_text(d.method)),
        Column("software", TEXT, "versions, as JSON text", lambda d: json_text(d.software)),
        Column(
            "study",
            Maybe(TEXT),
            "the study's condition, as JSON text",
            lambda d: None if d.study is None else json_text(d.study),
        ),
        Column(
            "questionnaires",
            TEXT,
            "what the person answered about it, by questionnaire, as JSON text",
            lambda d: json_text(d.questionnaires),
        ),
        Column("source", Maybe(TEXT), "alias of the session it goes on from", lambda d: d.source),
        Column(
            "parent",
            Maybe(TEXT),
            "alias of the session it branched from",
            lambda d: None if d.parent is None else d.parent[0],
        ),
        Column(
            "parent_event",
            Maybe(INTEGER),
            "the last event that both share",
            lambda d: None if d.parent is None else d.parent[1],
        ),
        Column("content_hash", TEXT, "of the whole record", lambda d: d.content_hash),
        Column("ended", FLAG, "whether it was left in good order", lambda d: d.ended),
        Column("seconds", NUMBER, "how long it took", lambda d: d.seconds),
        Column("turns", INTEGER, "rows of it among the turns", lambda d: len(d.turns)),
        Column(
            "totals",
            Many(_FEATURE),
            "episodes, successes, questions, reward, as the record counts them",
            lambda d: [{"name": name, "value": d.totals[name]} for name in sorted(d.totals)],
        ),
        Column("verbs_learned", Many(TEXT), "in the end", lambda d: list(d.verbs_learned)),
    ),
)


def session_row(dialogue: Dialogue) -> Row:
    """The row of a session."""
    return {column.name: column.value(dialogue) for column in SESSIONS.columns}


def turn_rows(dialogue: Dialogue) -> list[Row]:
    """The rows of a session's turns, in order."""
    return [
        {column.name: column.value(dialogue, turn) for column in TURNS.columns}
        for turn in dialogue.turns
    ]
