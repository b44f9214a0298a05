"""The YAML that leads a dataset card: what the Hugging Face hub and its loader read.

It names the type of every column. A loader left to guess takes it from the first
split's rows, and fails on another split where a column that was empty is not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from verbteach_sessions.exports.columns import SESSIONS, TURNS
from verbteach_sessions.exports.kinds import Group, Kind, Many, Maybe, Plain

Written = Mapping[str, Sequence[tuple[str, str]]]

_TYPES = {"string": "string", "integer": "int64", "number": "float64", "boolean": "bool"}

# https://hf.co/docs/hub/datasets-cards: the names of sizes that the hub knows.
_SIZES = ((1_000, "n<1K"), (10_000, "1K<n<10K"), (100_000, "10K<n<100K"), (1_000_000, "100K<n<1M"))


def front_matter(turns: int, written: Written) -> Iterator[str]:
    """Its lines. ``turns`` are counted for the size; ``written`` names each table's files."""
    yield from ("---", "pretty_name: Teaching sessions with a household robot")
    yield "license: unknown # say here under which it may be used, before you publish it"
    yield from ("language:", "- en", "tags:", "- dialogue", "- human-robot-interaction")
    yield from ("- grounded-language", "- interactive-learning", "task_categories:", "- robotics")
    yield from ("size_categories:", f"- {_size(turns)}")
    yield from _configs(written)
    yield from _dataset_info()
    yield from ("---", "")


def _size(turns: int) -> str:
    return next((name for limit, name in _SIZES if turns < limit), "1M<n<10M")


def _configs(written: Written) -> Iterator[str]:
    yield "configs:"
    for table, files in written.items():
        yield f"- config_name: {table}"
        if table == TURNS.name:
            yield "  default: true"
        yield "  data_files:"
        for split, path in files:
            yield from (f"  - split: {split}", f"    path: {path}")


def _dataset_info() -> Iterator[str]:
    yield "dataset_info:"
    for table in (TURNS, SESSIONS):
        yield from (f"- config_name: {table.name}", "  features:")
        for column in table.columns:
            yield from _named(column.name, column.kind, "  ")


def _named(name: str, kind: Kind, indent: str) -> Iterator[str]:
    yield f"{indent}- name: {name}"
    yield from _feature(kind, f"{indent}  ")


def _feature(kind: Kind, indent: str) -> Iterator[str]:
    """The type as ``datasets.Features`` writes it; each may be null there."""
    match kind:
        case Plain(name):
            yield f"{indent}dtype: {_TYPES[name]}"
        case Maybe(of):
            yield from _feature(of, indent)
        case Group(members):
            yield f"{indent}struct:"
            for name, member in members.items():
                yield from _named(name, member, indent)
        case Many(Group(members)):
            yield f"{indent}list:"
            for name, member in members.items():
                yield from _named(name, member, indent)
        case Many(of):
            yield f"{indent}list:"
            yield from _feature(of, f"{indent}  ")
