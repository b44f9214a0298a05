"""What there is to see of a session, whether it is being taught in or played back."""

from __future__ import annotations

from typing import Protocol

from verbteach.dialogue.promise import Promise
from verbteach.dialogue.setting import Settings
from verbteach.dialogue.state import RobotState
from verbteach_sessions.history import Node
from verbteach_sessions.session import Session
from verbteach_sessions.transcript import Line


class Watched(Protocol):
    """A session at one moment.

    ``name`` is its folder's, ``scene`` where it began, ``state`` the robot's that
    holds; ``turns`` are those that hold, ``transcript`` what was said in them.
    """

    @property
    def name(self) -> str:
        """Its folder's name."""
        ...

    @property
    def scene(self) -> str:
        """Where it began."""
        ...

    @property
    def settings(self) -> Settings:
        """The scenes, made ready."""
        ...

    @property
    def state(self) -> RobotState:
        """The robot's state that holds."""
        ...

    @property
    def can_undo(self) -> bool:
        """Whether there is an act to take back."""
        ...

    @property
    def can_redo(self) -> bool:
        """Whether there is an act to do again."""
        ...

    @property
    def ended(self) -> bool:
        """Whether the person has left."""
        ...

    @property
    def content_hash(self) -> str:
        """The hash of what was said so far."""
        ...

    @property
    def promise(self) -> Promise | None:
        """What the robot promises of its executions."""
        ...

    def transcript(self) -> tuple[Line, ...]:
        """The lines that hold, in order."""
        ...

    def turns(self) -> tuple[Node, ...]:
        """The turns that hold, in order."""
        ...

    def state_after(self, turn: Node) -> RobotState | None:
        """The robot's state after a turn, where it is known."""
        ...


class Live:
    """A session that goes on."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self.name, self.scene = session.path.name, session.header.scene
        self.settings = session.robot.settings
        self.promise = session.header.method.promise
        self.transcript, self.turns = session.transcript, session.turns
        self.state_after = session.state_after

    @property
    def state(self) -> RobotState:
        """The robot's state that holds."""
        return self._session.robot.state

    @property
    def can_undo(self) -> bool:
        """Whether there is an act to take back."""
        return self._session.can_undo

    @property
    def can_redo(self) -> bool:
        """Whether there is an act to do again."""
        return self._session.can_redo

    @property
    def ended(self) -> bool:
        """Whether the person has left."""
        return self._session.ended

    @property
    def content_hash(self) -> str:
        """The hash of what was said so far."""
        return self._session.content_hash
