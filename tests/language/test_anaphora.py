"""Pronouns point back to what was said; what cannot be told stays a pronoun."""

from __future__ import annotations

import pytest
from hypothesis import given

from tests.language.strategies import WORD_SALADS
from verbteach.language.anaphora import resolve
from verbteach.language.grammar import parse
from verbteach.language.notation import write_frames

RESOLVED = {
    "the object before what it was filled with": (
        "fill the cup with milk and put it on the table",
        "fill(obj=cup; with=milk) && put(obj=cup; on=table)",
    ),
    "a chain": (
        "take the mug, wash it and dry it",
        "take(obj=mug) && wash(obj=mug) && dry(obj=mug)",
    ),
    "them, coordinated": (
        "take the cup and the plate and wash them",
        "take(obj=cup; obj=plate) && wash(obj=cup; obj=plate)",
    ),
    "them, from several clauses": (
        "grab the cup, take the plate and wash them",
        "grab(obj=cup) && take(obj=plate) && wash(obj=cup; obj=plate)",
    ),
    "them, a plural": (
        "wash the plates and dry them",
        "wash(obj=plate) && dry(obj=plate)",
    ),
    "the same role": (
        "put the fork next to the plate and the knife on it",
        "put(obj=fork; next_to=plate) && put(obj=knife; on=plate)",
    ),
    "a tool": (
        "take the key and unlock the door with it",
        "take(obj=key) && unlock(obj=door; with=key)",
    ),
    "another one of a kind": (
        "put the red coffee mug on the shelf and the blue one on the table",
        "put(obj=mug[red,coffee]; on=shelf) && put(obj=mug[blue,coffee]; on=table)",
    ),
    "there": (
        "put the cup on the table and put the plate there",
        "put(obj=cup; on=table) && put(obj=plate; on=table)",
    ),
    "left out": ("grab the pot and bring to the sink", "grab(obj=pot) && bring(obj=pot; to=sink)"),
    "nothing to point to": ("boil it", "boil(obj=it)"),
    "a person is nobody to fill": (
        "bring me the mug and fill it",
        "bring(obj=mug; to=me) && fill(obj=mug)",
    ),
}


@pytest.mark.parametrize(("text", "expected"), RESOLVED.values(), ids=RESOLVED.keys())
def test_pronouns_point_back(text: str, expected: str) -> None:
    assert write_frames(resolve(parse(text))) == expected


def test_earlier_commands_are_looked_at_last() -> None:
    earlier = parse("wash the plate")
    assert write_frames(resolve(parse("dry it"), earlier)) == "dry(obj=plate)"
    assert write_frames(resolve(parse("take the cup and fill it"), earlier)) == (
        "take(obj=cup) && fill(obj=cup)"
    )


@given(WORD_SALADS)
def test_only_arguments_change(text: str) -> None:
    frames = parse(text)
    resolved = resolve(frames)
    assert [f.verb for f in resolved] == [f.verb for f in frames]
    assert all(len(r.arguments) >= len(f.arguments) for r, f in zip(resolved, frames, strict=True))
