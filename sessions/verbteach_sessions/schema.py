"""The format of a log's lines as a JSON Schema, made from the tables of events.

It ships as :data:`SCHEMA_NAME`, so that a record can be checked by programs that
know nothing of this one. What no schema can say (hashes, order, prices, that
recomputing gives the same) is checked by validating.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from importlib import resources
from typing import Any

from verbteach_sessions.events import EVENT_TYPES, SHAPES
from verbteach_sessions.shapes import Shape
from verbteach_sessions.upcasting import VERSION

SCHEMA_NAME = "session.schema.json"
_HASH = {"type": "string", "pattern": "^[0-9a-f]{64}$"}


def made_schema() -> Mapping[str, Any]:
    """The schema of one line, as the tables have it now."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": f"urn:verbteach:session:{VERSION}",
        "title": "A line of a teaching session's events.jsonl",
        "oneOf": [{"$ref": f"#/$defs/event_{name}"} for name in EVENT_TYPES],
        "$defs": {
            **{f"event_{name}": _line(shape) for name, shape in EVENT_TYPES.items()},
            **{shape.name: _object(shape) for shape in SHAPES},
        },
    }


def schema_text() -> str:
    """The schema as the file holds it."""
    return json.dumps(made_schema(), indent=1) + "\n"


def shipped_schema() -> Mapping[str, Any]:
    """The schema that came with this installation."""
    text = resources.files("verbteach_sessions").joinpath("data", SCHEMA_NAME).read_text("utf-8")
    schema: Mapping[str, Any] = json.loads(text)
    return schema


def _line(shape: Shape) -> Mapping[str, Any]:
    members = {
        "v": {"const": VERSION},
        "seq": {"type": "integer", "minimum": 0},
        "type": {"const": shape.name},
        "at": {"type": "number"},
        "data": _object(shape),
        "prev": _HASH,
        "hash": _HASH,
    }
    return {"type": "object", "properties": members, "required": list(members)}


def _object(shape: Shape) -> Mapping[str, Any]:
    fields = {
        field.name: {**field.kind.schema, "description": field.meaning} for field in shape.fields
    }
    return {
        "description": shape.meaning,
        "type": "object",
        "properties": fields,
        "required": [field.name for field in shape.fields if not field.optional],
        "additionalProperties": False,
    }
