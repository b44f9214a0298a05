"""Parquet: the turns and the sessions as columns. Needs the extra ``verbteach[parquet]``."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from verbteach_sessions.exports.columns import SESSIONS, TURNS, Table, session_row, turn_rows
from verbteach_sessions.exports.dialogue import Dialogue
from verbteach_sessions.exports.kinds import Group, Kind, Many, Maybe, Plain


def write(dialogues: Iterable[Dialogue], folder: Path) -> None:
    """Write ``turns.parquet`` and ``sessions.parquet``, a row group a session."""
    import pyarrow as pa  # noqa: PLC0415 - an extra, and slow to import
    import pyarrow.parquet as pq  # noqa: PLC0415

    turns, sessions = arrow_schema(TURNS), arrow_schema(SESSIONS)
    rows = []
    with pq.ParquetWriter(folder / "turns.parquet", turns) as writer:
        for dialogue in dialogues:
            writer.write_table(pa.Table.from_pylist(turn_rows(dialogue), schema=turns))
            rows.append(session_row(dialogue))
    pq.write_table(pa.Table.from_pylist(rows, schema=sessions), folder / "sessions.parquet")


def arrow_schema(table: Table) -> Any:
    """The table's columns as a ``pyarrow.Schema``, each with its meaning."""
    import pyarrow as pa  # noqa: PLC0415

    fields = []
    for column in table.columns:
        kind, nullable = _arrow(column.kind)
        meaning = {"description": column.meaning}
        fields.append(pa.field(column.name, kind, nullable=nullable, metadata=meaning))
    return pa.schema(fields)


def _arrow(kind: Kind) -> tuple[Any, bool]:
    """The Arrow type, and whether it may be null."""
    import pyarrow as pa  # noqa: PLC0415

    match kind:
        case Plain(name):
            plain = {
                "string": pa.string(),
                "integer": pa.int64(),
                "number": pa.float64(),
                "boolean": pa.bool_(),
            }
            return plain[name], False
        case Many(of):
            inner, nullable = _arrow(of)
            return pa.list_(pa.field("item", inner, nullable=nullable)), False
        case Maybe(of):
            return _arrow(of)[0], True
        case Group(members):
            made = {name: _arrow(member) for name, member in members.items()}
            return pa.struct(
                [pa.field(n, t, nullable=null) for n, (t, null) in made.items()]
            ), False
