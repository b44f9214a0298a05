"""A screen on which the person speaks to the robot: acts go to a worker, answers come back.

The session computes in a thread, so that neither planning nor the disk blocks a
key. While it does, nothing else is said; a failure becomes a message.
"""

from __future__ import annotations

from functools import partial

from textual.timer import Timer

from verbteach_sessions.errors import StorageError
from verbteach_sessions.script import LineSyntaxError, ScriptAct
from verbteach_sessions.session_acts import Quit, SessionAct
from verbteach_tui.messages import Refused, TurnTaken, WorkFailed
from verbteach_tui.screens.panels import PanelScreen
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.teaching import REFUSALS, Teaching

PATIENCE = 0.25
"""Seconds after which the screen says that the robot is thinking."""


class SpeakingScreen(PanelScreen):
    """Knows how to say something to the robot, and whether it is still thinking."""

    def __init__(self, teaching: Teaching) -> None:
        super().__init__()
        self.teaching = teaching
        self._thinking = False
        self._patience: Timer | None = None

    @property
    def snapshot(self) -> Snapshot:
        """What holds now."""
        return self.teaching.snapshot

    @property
    def thinking(self) -> bool:
        """Whether the robot has not answered yet."""
        return self._thinking

    def say_line(self, line: str, via: str) -> bool:
        """Say what a typed line means now; False where it stays unsaid."""
        if self._thinking:
            return False
        try:
            act = self.snapshot.reader.read(line)
        except LineSyntaxError as error:
            self.post_message(Refused(str(error), ""))
            return False
        return act is not None and self.say(self.meant(act), line, via)

    def meant(self, act: ScriptAct) -> ScriptAct:
        """What ``act`` comes to where the person stands; for subclasses."""
        return act

    def say(self, act: ScriptAct, raw: str, via: str) -> bool:
        """Say ``act``; ``raw`` is what was typed or pressed, ``via`` how.

        False where the robot is still thinking, and nothing was said.
        """
        if self._thinking:
            return False
        self._thinking = True
        self._patience = self.set_timer(PATIENCE, self.waiting)
        self.run_worker(
            partial(self._speak, act, raw, via, self.seen),
            thread=True,
            exit_on_error=False,
            group="session",
        )
        return True

    def waiting(self) -> None:
        """The robot takes its time; for subclasses, to say so."""

    def _speak(self, act: ScriptAct, raw: str, via: str, seen: frozenset[str]) -> None:
        """In a worker thread: perform the act and post what came of it."""
        try:
            snapshot = self.teaching.perform(act, raw, via, seen)
        except REFUSALS as error:
            reason = str(error.args[0] if error.args else error)
            self.post_message(Refused(reason, raw))
        except StorageError as error:
            leaving = isinstance(act, Quit)
            self.post_message(WorkFailed("writing the record", error, raw, leaving))
        except Exception as error:
            self.post_message(WorkFailed("working out the robot's turn", error, raw))
        else:
            played = not isinstance(act, SessionAct)
            self.post_message(TurnTaken(snapshot, played and len(snapshot.moments) > 2))

    def settled(self) -> None:
        """The robot has answered, or could not; there is room for the next act."""
        self._thinking = False
        if self._patience is not None:
            self._patience.stop()
