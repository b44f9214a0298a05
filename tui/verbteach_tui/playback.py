"""A record told event by event, as it happened: what was taken back is told too."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from verbteach.dialogue.codec import teacher_act_from_json
from verbteach_sessions import events as kinds
from verbteach_sessions.lines import Event
from verbteach_sessions.replay import Frame
from verbteach_sessions.script import spoken

LONGEST_PAUSE = 5.0  # seconds: nobody watches a teacher go for coffee


def told(frames: Iterable[Frame], speed: float, wait: Callable[[float], None]) -> Iterator[str]:
    """The lines of a record; ``wait`` is called with the seconds to the next one.

    ``speed`` 2 is twice as fast as it was; 0 does not wait at all.
    """
    last = 0.0
    for event, _ in frames:
        if speed:
            wait(min(LONGEST_PAUSE, max(0.0, event.at - last)) / speed)
        last = event.at
        yield from lines_of(event)


def lines_of(event: Event) -> Iterator[str]:
    """One event in words, each line led by the event's number."""
    tell = _TELLERS.get(event.type)
    for line in tell(event) if tell else ():
        yield f"{event.seq:5}  {line}"


def _header(event: Event) -> Iterator[str]:
    data = event.data
    policy, noise = data["policy"].get("name"), _noise(data["noise"])
    yield f"Session {data['id']}, {data['created']}, taught by: {data['teacher']}"
    yield f"Scene {data['scene']}, policy {policy}, noise {noise}, seed {data['seed']}"


def _noise(noise: Mapping[str, Any]) -> str:
    """The spread, and those of the kinds of fluents that have their own."""
    kinds = (f", {kind} {spread}" for kind, spread in noise.get("spreads", {}).items())
    return "".join([f"{noise.get('spread')}", *kinds])


def _teacher(event: Event) -> Iterator[str]:
    yield f"You: {spoken(teacher_act_from_json(event.data['act']))}"


def _robot(event: Event) -> Iterator[str]:
    yield from (f"Robot: {text}" for text in event.data["texts"])


def _note(event: Event) -> Iterator[str]:
    yield f"Note: {event.data['text']}"


def _explained(event: Event) -> Iterator[str]:
    yield f"You: {event.type}"
    yield from _robot(event)


def _fault(event: Event) -> Iterator[str]:
    yield f"The robot could not reply: {event.data['message']}"


def _resumed(event: Event) -> Iterator[str]:
    yield f"Opened again, {event.data['created']}"
    yield from event.data["recovered"]


def _moved(event: Event) -> Iterator[str]:
    yield f"You: {event.type} (back to event {event.data['to']})"


def _flagged(event: Event) -> Iterator[str]:
    yield "You: flag"


def _ended(event: Event) -> Iterator[str]:
    yield "The session was left"


_TELLERS: Mapping[str, Callable[[Event], Iterator[str]]] = {
    kinds.HEADER: _header,
    kinds.TEACHER: _teacher,
    kinds.ROBOT: _robot,
    kinds.UNDO: _moved,
    kinds.REDO: _moved,
    kinds.FLAGGED: _flagged,
    kinds.NOTE: _note,
    kinds.WHY: _explained,
    kinds.REPEAT: _explained,
    kinds.FAULT: _fault,
    kinds.RESUME: _resumed,
    kinds.END: _ended,
}
