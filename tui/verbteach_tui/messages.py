"""Everything that widgets and workers tell the screens, one small class a message."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual.message import Message

if TYPE_CHECKING:
    from textual.widget import Widget

    from verbteach.world.fluents import Literal
    from verbteach.world.plan import Action
    from verbteach_sessions.script import ScriptAct
    from verbteach_tui.options import OpenRecord
    from verbteach_tui.past import Past
    from verbteach_tui.snapshot import Snapshot
    from verbteach_tui.teaching import Teaching


class TargetPicked(Message):
    """Something drawn was clicked: an object's id, a node's, or what the widget named it."""

    def __init__(self, sender: Widget, target: str) -> None:
        super().__init__()
        self.sender = sender
        self.target = target

    @property
    def control(self) -> Widget:
        """The widget that was clicked, for selectors."""
        return self.sender


class WordSaid(Message):
    """The person chose a word of the script by key or click."""

    def __init__(self, word: str, via: str) -> None:
        super().__init__()
        self.word = word
        self.via = via


class LineTyped(Message):
    """The person typed a line and pressed Enter."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.text = text


class StepChosen(Message):
    """The person picked a whole action to demonstrate."""

    def __init__(self, action: Action) -> None:
        super().__init__()
        self.action = action


class ActPicked(Message):
    """The person picked a whole act, by key or mouse."""

    def __init__(self, act: ScriptAct) -> None:
        super().__init__()
        self.act = act


class StepLooked(Message):
    """The person looks at the world after so many of the steps shown."""

    def __init__(self, after: int) -> None:
        super().__init__()
        self.after = after


class InsertionMoved(Message):
    """The next step of the demonstration comes somewhere else now."""


class PartToggled(Message):
    """The person struck a part of the goal that was read back, or kept it after all."""

    def __init__(self, literal: Literal, keep: bool) -> None:
        super().__init__()
        self.literal = literal
        self.keep = keep


class StepShown(Message):
    """The execution being watched stands after so many steps; ``over``: all were shown."""

    def __init__(self, at: int, over: bool) -> None:
        super().__init__()
        self.at = at
        self.over = over


class NodeChosen(Message):
    """A hypothesis in the graph was chosen."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.name = name


class ConditionJudged(Message):
    """A condition of a learned hypothesis was confirmed (``wanted``) or struck out."""

    def __init__(self, node: str, index: int, wanted: bool) -> None:
        super().__init__()
        self.node = node
        self.index = index
        self.wanted = wanted


class SessionOpened(Message):
    """A worker has opened a session."""

    def __init__(self, teaching: Teaching) -> None:
        super().__init__()
        self.teaching = teaching


class RecordOpened(Message):
    """A worker has recomputed a record to play back."""

    def __init__(self, past: Past, opening: OpenRecord) -> None:
        super().__init__()
        self.past = past
        self.opening = opening


class SessionNotOpened(Message):
    """A worker could not open a session."""

    def __init__(self, error: Exception) -> None:
        super().__init__()
        self.error = error


class SessionLeft(Message):
    """The person has left a session; ``then`` is what to do instead of going home."""

    def __init__(self, teaching: Teaching, then: Callable[[], object] | None) -> None:
        super().__init__()
        self.teaching = teaching
        self.then = then


class TurnTaken(Message):
    """A worker has done what the person said; ``played``: the turn's execution is to be watched."""

    def __init__(self, snapshot: Snapshot, played: bool) -> None:
        super().__init__()
        self.snapshot = snapshot
        self.played = played


class Refused(Message):
    """What the person said, ``raw``, does not fit; nothing has changed."""

    def __init__(self, reason: str, raw: str) -> None:
        super().__init__()
        self.reason = reason
        self.raw = raw


class WorkFailed(Message):
    """Something broke in a worker over ``raw``; the session is as it was before.

    ``leaving``: the person wanted no more than to leave.
    """

    def __init__(self, doing: str, error: Exception, raw: str, leaving: bool = False) -> None:
        super().__init__()
        self.doing = doing
        self.error = error
        self.raw = raw
        self.leaving = leaving
