from __future__ import annotations

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verbteach_sessions.lines import (
    GENESIS,
    ChangedLineError,
    Event,
    LineError,
    NewerVersionError,
    canonical,
    decode,
    digest,
    encode,
    parse,
)

json_values = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(10**18), 10**18)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)
events = st.builds(
    Event,
    st.integers(0, 10**6),
    st.text(min_size=1, max_size=8),
    st.floats(0, 10**6),
    st.dictionaries(st.text(), json_values, max_size=5),
)


@given(events, st.binary(max_size=5))
def test_a_line_gives_its_event_back(event: Event, before: bytes) -> None:
    line = encode(event, digest(before))
    assert line.endswith(b"\n")
    assert line.count(b"\n") == 1
    assert decode(line[:-1]) == (event, digest(before))


@given(events, st.data())
def test_any_changed_byte_is_found(event: Event, data: st.DataObject) -> None:
    line = bytearray(encode(event, GENESIS)[:-1])
    place = data.draw(st.integers(0, len(line) - 1))
    other = data.draw(st.integers(0, 255).filter(lambda byte: byte != line[place]))
    line[place] = other
    with pytest.raises(LineError):
        decode(bytes(line))


@given(events, st.data())
def test_no_shorter_line_is_whole(event: Event, data: st.DataObject) -> None:
    line = encode(event, GENESIS)[:-1]
    with pytest.raises(LineError):
        decode(line[: data.draw(st.integers(0, len(line) - 1))])


def test_a_digit_that_parsing_would_lose_counts() -> None:
    # 0.1 and the longer text are the same number: only the bytes tell.
    line = encode(Event(0, "note", 0.1, {}), GENESIS)[:-1]
    longer = line.replace(b'"at":0.1,', b'"at":0.1000000000000000055,')
    assert json.loads(longer)["at"] == json.loads(line)["at"]
    with pytest.raises(ChangedLineError):
        decode(longer)


def test_a_newer_version_is_named_before_its_hash_is_looked_at() -> None:
    with pytest.raises(NewerVersionError, match="version 3"):
        decode(b'{"v":3,"quite":"different"}')


@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"[]",
        b"null",
        b"{",
        b"\xff\xfe",
        b"\x00" * 50,
        b'{"v":1}',
        b"[" * 200_000,
        b'{"a":' * 100_000,
        b"1" * 10_000,
        b'{"at":NaN}',
        b'{"at":-Infinity}',
        b'{"at":1e999}',
    ],
)
def test_hostile_bytes_are_refused_with_a_reason(raw: bytes) -> None:
    with pytest.raises(LineError) as refused:
        decode(raw)
    assert str(refused.value)


def test_large_exponents_that_are_numbers_are_read() -> None:
    assert parse(b"[1e100, 2E-300, 1.5]") == [1e100, 2e-300, 1.5]


def test_canonical_json_does_not_depend_on_the_order_of_members() -> None:
    assert (
        canonical({"b": 1, "a": [2.5]}) == canonical({"a": [2.5], "b": 1}) == b'{"a":[2.5],"b":1}'
    )
    with pytest.raises(ValueError, match="JSON"):
        canonical(math.nan)


@pytest.mark.parametrize("broken", ["v", "seq", "type", "at", "data", "prev"])
def test_a_member_of_the_wrong_type_is_named(broken: str) -> None:
    line = encode(Event(3, "note", 1.0, {"text": "x"}), GENESIS)[:-1]
    value = json.loads(line)
    del value["hash"]
    value[broken] = [True]
    body = json.dumps(value, separators=(",", ":")).encode()
    signed = body[:-1] + f',"hash":"{digest(body)}"}}'.encode()
    with pytest.raises(LineError, match="version" if broken == "v" else f"'{broken}'"):
        decode(signed)
