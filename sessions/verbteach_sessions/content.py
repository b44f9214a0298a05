"""The content hash: what was said, done and computed, without when, where and by which key.

One script gives one content hash in every interface. Event numbers stay out of
it, since resuming a session adds events that say nothing.
"""

from __future__ import annotations

from hashlib import sha256
from typing import Any

from verbteach_sessions.events import EVENT_TYPES, FAULT, LEARNED, OUTSIDE_CONTENT, TEACHER
from verbteach_sessions.lines import Event, canonical


def content_of(event: Event) -> dict[str, Any] | None:
    """The event's type and content fields; ``None`` where it has none."""
    if event.type in OUTSIDE_CONTENT:
        return None
    fields = EVENT_TYPES[event.type].fields
    named = [field.name for field in fields if field.content]
    content = {name: event.data[name] for name in named if name in event.data}
    return {"type": event.type, **content}


class ContentHash:
    """A hash of the contents of the events added so far, in order, each taken over the one before.

    A teacher's act waits for its reply: one that the robot failed to reply to
    was never said.
    """

    def __init__(self, hexdigest: str = sha256().hexdigest()) -> None:
        """``hexdigest``: the hash of what came before; that of nothing if it is left out."""
        self._hash = bytes.fromhex(hexdigest)
        self._waiting = b""

    def add(self, event: Event) -> None:
        """Take one event more."""
        if event.type == FAULT:
            self._waiting = b""
        content = content_of(event)
        if content is None:
            return
        line = canonical(content) + b"\n"
        if event.type in (TEACHER, LEARNED):
            self._waiting += line
            return
        self._hash = sha256(self._hash + self._waiting + line).digest()
        self._waiting = b""

    @property
    def hexdigest(self) -> str:
        """The hash so far, in hexadecimal."""
        return self._hash.hex()
