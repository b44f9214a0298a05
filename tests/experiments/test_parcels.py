"""Parcels: the same value on the other side, unpacked once however often it travels."""

from __future__ import annotations

import pickle

from hypothesis import given
from hypothesis import strategies as st

from verbteach.experiments.parcels import KEPT, Parcel

VALUES = st.recursive(st.integers() | st.text(), lambda inner: st.lists(inner, max_size=4))


def sent(parcel: Parcel[object]) -> Parcel[object]:
    found = pickle.loads(pickle.dumps(parcel))
    assert isinstance(found, Parcel)
    return found


@given(VALUES)
def test_what_arrives_is_what_was_sent(value: object) -> None:
    assert sent(Parcel(value)).value == value
    assert sent(sent(Parcel(value))).value == value


def test_what_travels_twice_is_unpacked_once() -> None:
    parcel = Parcel[object](["a", "long", "list"])
    first, second = sent(parcel), sent(parcel)
    assert first.value is second.value
    assert first.value is not parcel.value


def test_others_with_the_same_content_are_the_same_parcel() -> None:
    assert sent(Parcel(["here"])).value is sent(Parcel(["here"])).value


def test_no_more_is_kept_than_is_promised() -> None:
    parcel = Parcel[object](["first"])
    before = sent(parcel).value
    for number in range(KEPT):
        sent(Parcel([number]))
    assert sent(parcel).value is not before
