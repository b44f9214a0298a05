"""A recorded session, to be looked at as it was after any of its events."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from verbteach.dialogue.promise import Promise
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState
from verbteach_sessions import events as kinds
from verbteach_sessions.header import Header
from verbteach_sessions.history import History, Node
from verbteach_sessions.lines import Event
from verbteach_sessions.replay import Frame, replay
from verbteach_sessions.transcript import Line, Transcript

SEEN = frozenset({
    *(kinds.ROBOT, kinds.UNDO, kinds.REDO, kinds.FLAGGED, kinds.NOTE, kinds.WHY, kinds.REPEAT),
    kinds.END,
})  # fmt: skip
"""Events after which there is something new to see."""


class Past:
    """Stands at one of ``stops``, the numbers of the events after which there is news.

    What a process could not recompute ends it: ``problem`` then says so.
    """

    def __init__(self, name: str, settings: Settings, frames: Iterable[Frame]) -> None:
        self.name, self.settings = name, settings
        self.problem = ""
        self._events: list[Event] = []
        self._states: dict[int, RobotState] = {}
        for event, state in frames:
            if state is None and event.type == kinds.ROBOT:
                self.problem = f"From event {event.seq} on this record cannot be recomputed here."
                break
            self._events.append(event)
            if event.type == kinds.ROBOT and state is not None:
                self._states[event.seq] = state
        self._header = Header.from_json(self._events[0].data)
        self.stops = tuple(event.seq for event in self._events if event.type in SEEN)
        self._at = 0
        self._begin()
        self.go(0)

    @classmethod
    def open(
        cls, path: Path, settings: Settings, heard: Callable[[int], None] | None = None
    ) -> Past:
        """Recompute a record; ``heard`` is told how many events are done.

        Raises what ``replay`` raises.
        """
        name = path.parent.name if path.is_file() else path.name
        return cls(name, settings, _told(replay(path, settings), heard))

    @property
    def at(self) -> int:
        """The index in ``stops`` of where it stands."""
        return self._at

    @property
    def event(self) -> Event:
        """The event it stands after."""
        return self._events[self.stops[self._at]]

    def go(self, stop: int) -> None:
        """Stand after the event of a stop; the first or the last one beyond the ends."""
        self._at = min(max(stop, 0), len(self.stops) - 1)
        wanted = self.stops[self._at]
        if self._taken > wanted + 1:
            self._begin()
        for event in self._events[self._taken : wanted + 1]:
            self._history.take(event)
            self._taken += 1

    def stop_at(self, seq: int) -> int:
        """The stop at event ``seq``, or the last one before it."""
        return max([i for i, stop in enumerate(self.stops) if stop <= seq], default=0)

    def _begin(self) -> None:
        self._taken, self._history = 0, History()
        self._transcript = Transcript(self._history, self._header.method.parameters.rewards)

    # ---- what there is to see

    @property
    def scene(self) -> str:
        """Where it began."""
        return self._header.scene

    @property
    def promise(self) -> Promise | None:
        """What the robot promised of its executions."""
        return self._header.method.promise

    @property
    def state(self) -> RobotState:
        """The robot's state that held."""
        current = self._history.current
        if current is None:
            raise RuntimeError("the record holds no robot turn")
        return self._states[current.seq]

    @property
    def can_undo(self) -> bool:
        """Nothing is taken back in the past."""
        return False

    @property
    def can_redo(self) -> bool:
        """Nothing is done again in the past."""
        return False

    @property
    def ended(self) -> bool:
        """A session that is looked at does not end."""
        return False

    @property
    def content_hash(self) -> str:
        """Left to verifying."""
        return ""

    def transcript(self) -> tuple[Line, ...]:
        """What had been said and held."""
        return self._transcript.lines()

    def turns(self) -> tuple[Node, ...]:
        """The turns that held."""
        return self._history.effective()

    def state_after(self, turn: Node) -> RobotState | None:
        """The robot's state after a turn."""
        return self._states.get(turn.seq)


def _told(frames: Iterable[Frame], heard: Callable[[int], None] | None) -> Iterable[Frame]:
    for count, frame in enumerate(frames, 1):
        if heard is not None:
            heard(count)
        yield frame
