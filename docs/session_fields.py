"""Writes the tables of session-format.md, and the JSON Schema that ships, from the code's own.

`python docs/session_fields.py` rewrites the marked blocks and the schema; `--check`
only says whether they are current. What they show is never edited by hand.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from pathlib import Path

import verbteach_sessions
from verbteach.dialogue.codec import ROBOT_ACTS, TEACHER_ACTS
from verbteach_sessions.events import EVENT_TYPES, OUTSIDE_CONTENT, SHAPES
from verbteach_sessions.schema import SCHEMA_NAME, schema_text
from verbteach_sessions.shapes import Shape
from verbteach_sessions.validate import CAUTIONS, RULES

SCHEMA = Path(verbteach_sessions.__file__).parent / "data" / SCHEMA_NAME
PAGE = Path(__file__).resolve().parent / "session-format.md"
_BLOCK = re.compile(r"(<!-- generated: (?P<name>[a-z ]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def events() -> str:
    """A section for each type of event, with a row for each field."""
    return "\n".join(_section(shape) for shape in EVENT_TYPES.values())


def shapes() -> str:
    """A section for each kind of object inside an event."""
    return "\n".join(_section(shape) for shape in SHAPES)


def acts() -> str:
    """The acts of both sides with their fields."""
    rows = [
        f"| {side} | `{name}` | {', '.join(f'`{field.name}`' for field in fields(kind))} |"
        for side, kinds in (("teacher", TEACHER_ACTS), ("robot", ROBOT_ACTS))
        for name, kind in kinds.items()
    ]
    return _table("| by | act | fields |", rows)


def rules() -> str:
    """What validation asks of a record."""
    return _table("| rule | asks |", [f"| `{name}` | {asks} |" for name, asks in RULES.items()])


def cautions() -> str:
    """What validation asks of a record that is sound all the same without it."""
    return _table(
        "| caution | asks |", [f"| `{name}` | {asks} |" for name, asks in CAUTIONS.items()]
    )


def outside() -> str:
    """The types of event that leave no trace in the content hash."""
    return ", ".join(f"`{name}`" for name in sorted(OUTSIDE_CONTENT)) + "\n"


def _section(shape: Shape) -> str:
    rows = [
        f"| `{field.name}` | {field.kind.name} | {field.meaning} | {'yes' * field.content} |"
        for field in shape.fields
    ]
    table = _table("| field | kind | meaning | content |", rows)
    return f"### {shape.name}\n\n{shape.meaning}\n\n{table}"


def _table(head: str, rows: Iterable[str]) -> str:
    line = "|" + "---|" * (head.count("|") - 1)
    return "\n".join([head, line, *rows]) + "\n"


BLOCKS: Mapping[str, Callable[[], str]] = {
    "events": events,
    "shapes": shapes,
    "acts": acts,
    "rules": rules,
    "cautions": cautions,
    "outside": outside,
}


def current(page: str) -> str:
    """The page with every block as the code has it now."""

    def block(match: re.Match[str]) -> str:
        return f"{match[1]}\n{BLOCKS[match['name']]()}\n{match[3]}"

    return _BLOCK.sub(block, page)


def main(arguments: list[str]) -> int:
    """Rewrite the page, or with ``--check`` answer 1 if that would change it."""
    page = PAGE.read_text("utf-8")
    if "--check" in arguments:
        shipped = SCHEMA.read_text("utf-8") if SCHEMA.exists() else ""
        return int(page != current(page) or shipped != schema_text())
    PAGE.write_text(current(page), "utf-8")
    SCHEMA.write_text(schema_text(), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
