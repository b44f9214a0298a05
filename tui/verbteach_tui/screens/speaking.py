"""A screen on which the person speaks to the robot: acts go to a worker, answers come back.

The session computes in a thread, so that neither planning nor the disk blocks a
key. While it does, nothing else is said; a failure becomes a message.
"""

from __future__ import annotations

from functools import partial

from textual.screen import Screen

from verbteach_sessions.errors import StorageError
from verbteach_sessions.script import LineSyntaxError, ScriptAct
from verbteach_sessions.session_acts import SessionAct
from verbteach_tui.messages import LineTaken, Refused, TurnTaken, WorkFailed
from verbteach_tui.snapshot import Snapshot
from verbteach_tui.teaching import REFUSALS, Teaching


class SpeakingScreen(Screen[None]):
    """Knows how to say something to the robot, and whether it is still thinking."""

    def __init__(self, teaching: Teaching) -> None:
        super().__init__()
        self.teaching = teaching
        self._thinking = False

    @property
    def snapshot(self) -> Snapshot:
        """What holds now."""
        return self.teaching.snapshot

    @property
    def thinking(self) -> bool:
        """Whether the robot has not answered yet."""
        return self._thinking

    def say_line(self, line: str, via: str) -> None:
        """Say what a typed line means now."""
        try:
            act = self.snapshot.reader.read(line)
        except LineSyntaxError as error:
            self.post_message(Refused(str(error)))
            return
        if act is not None:
            self.say(act, line, via)

    def say(self, act: ScriptAct, raw: str, via: str) -> None:
        """Say ``act``; ``raw`` is what was typed or pressed, ``via`` how."""
        if self._thinking:
            return
        self._thinking = True
        self.run_worker(
            partial(self._speak, act, raw, via), thread=True, exit_on_error=False, group="session"
        )

    def _speak(self, act: ScriptAct, raw: str, via: str) -> None:
        """In a worker thread: perform the act and post what came of it."""
        try:
            snapshot = self.teaching.perform(act, raw, via)
        except REFUSALS as error:
            self.post_message(Refused(str(error.args[0] if error.args else error)))
        except StorageError as error:
            self.post_message(WorkFailed("writing the record", error))
        except Exception as error:
            self.post_message(WorkFailed("working out the robot's turn", error))
        else:
            self.post_message(LineTaken(raw))
            played = not isinstance(act, SessionAct)
            self.post_message(TurnTaken(snapshot, played and len(snapshot.moments) > 2))

    def settled(self) -> None:
        """The robot has answered, or could not; there is room for the next act."""
        self._thinking = False
