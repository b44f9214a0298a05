"""The schema that ships says what the tables say, and agrees with the code about records."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from tests.sessions.records import read_events
from tests.sessions.rooms import TAUGHT, recorded
from tests.sessions.test_hostile import spoiled
from verbteach_sessions.events import EVENT_TYPES, FITTING
from verbteach_sessions.schema import made_schema, shipped_schema
from verbteach_sessions.shapes import MAX_DEPTH, depth, wrong_fields

SCRIPT = TAUGHT + "good\nnote: so\nflag\nwhy\nrepeat\nundo\nredo\nquit\n"


@pytest.fixture(scope="module")
def events(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    return read_events(recorded(tmp_path_factory.mktemp("schema"), SCRIPT))


@pytest.fixture(scope="module")
def judge() -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator(shipped_schema())


def test_the_schema_that_ships_is_the_tables() -> None:
    assert shipped_schema() == made_schema(), "run python docs/session_fields.py"


def test_it_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(shipped_schema())


def test_every_line_of_a_record_fits(
    events: list[dict[str, Any]], judge: jsonschema.Draft202012Validator
) -> None:
    for event in events:
        judge.validate(event)


def test_it_judges_spoiled_lines_as_the_code_does(
    events: list[dict[str, Any]], judge: jsonschema.Draft202012Validator
) -> None:
    rng = np.random.default_rng(5)
    refused = 0
    for _ in range(150):
        for event, was in zip(spoiled(events, rng), events, strict=True):
            if event == was:
                continue
            shape = EVENT_TYPES[event["type"]]
            wrong = any(wrong_fields(shape, event["data"]))
            assert FITTING[event["type"]](event["data"]) != wrong, event
            assert judge.is_valid(event) != wrong, event
            refused += wrong
    assert refused > 50


def test_what_is_no_event_is_refused(
    events: list[dict[str, Any]], judge: jsonschema.Draft202012Validator
) -> None:
    whole = events[3]
    for name in whole:
        event = copy.deepcopy(whole)
        del event[name]
        assert not judge.is_valid(event)
    for name, value in (("v", 1), ("type", "hum"), ("seq", -1), ("prev", "0"), ("data", [])):
        assert not judge.is_valid({**whole, name: value})


def test_no_honest_value_comes_near_the_depth_that_no_schema_bounds(
    events: list[dict[str, Any]],
) -> None:
    assert max(depth(event["data"]) for event in events) < MAX_DEPTH / 2


def test_the_file_is_in_the_package() -> None:
    package = Path(__file__).parents[2] / "sessions" / "verbteach_sessions"
    assert (package / "data" / "session.schema.json").is_file()
