"""What of an event a person has put in their own words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from verbteach_sessions.lines import Event

_TYPED = ("raw", "text", "answers", "act")


def typed(event: Event) -> Iterator[str]:
    """The texts, in order; none of the robot's."""
    for name in _TYPED:
        yield from _texts(event.data.get(name))


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for inner in value.values():
            yield from _texts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _texts(inner)
