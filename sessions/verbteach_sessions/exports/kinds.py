"""Types of columns, as JSON Schema names them: what JSON Lines, Parquet and the card agree on.

Unlike the record itself, an exported table has one fixed type a column, so that
readers that want columns can take it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias


@dataclass(frozen=True)
class Plain:
    """A text, an integer, a number or a flag; ``name`` is JSON Schema's."""

    name: str


@dataclass(frozen=True)
class Many:
    """A list of one type."""

    of: Kind


@dataclass(frozen=True)
class Group:
    """An object with fixed members, all of them present."""

    members: Mapping[str, Kind]


@dataclass(frozen=True)
class Maybe:
    """A value or null."""

    of: Kind


Kind: TypeAlias = Plain | Many | Group | Maybe

TEXT = Plain("string")
INTEGER = Plain("integer")
NUMBER = Plain("number")
FLAG = Plain("boolean")


def json_schema(kind: Kind) -> dict[str, Any]:
    """The type as JSON Schema (draft 2020-12)."""
    match kind:
        case Plain(name):
            return {"type": name}
        case Many(of):
            return {"type": "array", "items": json_schema(of)}
        case Maybe(of):
            return {"anyOf": [json_schema(of), {"type": "null"}]}
        case Group(members):
            return {
                "type": "object",
                "properties": {name: json_schema(one) for name, one in members.items()},
                "required": list(members),
                "additionalProperties": False,
            }


def word(kind: Kind) -> str:
    """The type in a few words, for the card."""
    match kind:
        case Plain(name):
            return name
        case Many(of):
            return f"list of {word(of)}"
        case Maybe(of):
            return f"{word(of)} or null"
        case Group(members):
            return f"{{{', '.join(members)}}}"


def is_scalar(kind: Kind) -> bool:
    """Whether a spreadsheet's cell can hold a value as it is."""
    return isinstance(kind.of if isinstance(kind, Maybe) else kind, Plain)
