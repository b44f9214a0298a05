"""The page on the session format says what the code does now."""

from __future__ import annotations

import json
import re
from hashlib import sha256
from pathlib import Path
from typing import Any

from docs import session_fields
from tests.sessions.records import read_events
from tests.sessions.rooms import BOIL, TAUGHT, recorded, settings
from verbteach_sessions.events import EVENT_TYPES, SHAPES
from verbteach_sessions.lines import GENESIS, MAX_LINE, Event, decode, encode
from verbteach_sessions.replay import verify
from verbteach_sessions.shapes import Field
from verbteach_sessions.upcasting import VERSION


def page() -> str:
    return session_fields.PAGE.read_text("utf-8")


def test_generated_blocks_are_current() -> None:
    assert page() == session_fields.current(page()), "run: python docs/session_fields.py"


def test_every_block_is_on_the_page() -> None:
    shown = re.findall(r"<!-- generated: ([a-z ]+) -->", page())
    assert sorted(shown) == sorted(session_fields.BLOCKS)


def test_a_stale_block_is_noticed() -> None:
    assert session_fields.current(page().replace("propensity", "tendency")) != page().replace(
        "propensity", "tendency"
    )


def test_every_kind_of_object_that_is_named_is_explained() -> None:
    explained = {shape.name for shape in SHAPES}
    shapes = (*EVENT_TYPES.values(), *SHAPES)
    fields: list[Field] = [field for shape in shapes for field in shape.fields]
    plain = {"list", "of", "or", "null", "object", "text", "integer", "number", "true", "false"}
    for field in fields:
        words = set(re.findall(r"[a-z]+", field.kind.name)) - plain
        assert words <= explained, field


def test_the_example_is_a_line_that_reads() -> None:
    (example,) = re.findall(r"```json\n(.*)\n```", page())
    event, prev = decode(example.encode())
    assert (event, prev) == (Event(0, "note", 1.5, {"text": "an example"}), GENESIS)
    assert encode(event, prev).decode() == example + "\n"


def content_hash_by_the_page(events: list[dict[str, Any]]) -> str:
    """The content hash as the page describes it, made from nothing but the page."""
    outside = re.findall(
        r"`([a-z]+)`", page().split("<!-- generated: outside -->")[1].split("<!-- ")[0]
    )
    sections = {part.split("\n")[0]: part for part in page().split("\n### ")}
    reached, waiting = sha256().digest(), b""
    for event, following in zip(events, [*events[1:], {"type": "end"}], strict=True):
        if event["type"] in outside or following["type"] == "fault":
            continue
        names = re.findall(r"^\| `(\w+)` .* yes \|$", sections[event["type"]], re.MULTILINE)
        content = {
            "type": event["type"],
            **{n: event["data"][n] for n in names if n in event["data"]},
        }
        line = json.dumps(content, sort_keys=True, separators=(",", ":"))
        waiting += line.encode() + b"\n"
        if event["type"] not in ("teacher", "learned"):
            reached, waiting = sha256(reached + waiting).digest(), b""
    return reached.hex()


def test_the_content_hash_is_what_the_page_says(tmp_path: Path) -> None:
    path = recorded(tmp_path, TAUGHT + "good\nundo\nnote: é\nwhy\nflag\nquit\n")
    assert content_hash_by_the_page(read_events(path)) == verify(path, settings).content_hash


def test_the_numbers_on_the_page_are_the_codes() -> None:
    assert f"now {VERSION}" in page()
    assert f"at most {MAX_LINE // 2**20} MiB" in page()


def test_the_files_of_a_session_are_on_the_page(tmp_path: Path) -> None:
    path = recorded(tmp_path, BOIL)
    named = re.findall(r"^\| `([a-z.]+\.[a-z]+)` \|", page(), re.MULTILINE)
    assert sorted(named) == sorted(one.name for one in path.iterdir())
