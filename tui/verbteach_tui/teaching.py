"""The session behind the screen: one act at a time, each answered with a snapshot.

It is called from worker threads only and knows no screen. A lock keeps two
workers from entering the session at once.
"""

from __future__ import annotations

import threading
from collections.abc import Collection

from verbteach_sessions.errors import CannotUndoError, SessionEndedError, TooLongError
from verbteach_sessions.recorder import MISFITS
from verbteach_sessions.script import ScriptAct
from verbteach_sessions.session import Session
from verbteach_tui.observer import Observer
from verbteach_tui.snapshot import Snapshot

REFUSALS = (*MISFITS, CannotUndoError, SessionEndedError, TooLongError)
"""What the person said does not fit; nothing has changed, and the reason is theirs to read."""


class Teaching:
    """An open session and what it looked like last."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._lock = threading.Lock()
        self._shown_at: float | None = None
        self._observer = Observer(session)
        self.snapshot = self._observer.look()

    @property
    def session(self) -> Session:
        """The session; only for a look at what never changes, such as its path."""
        return self._session

    @property
    def notices(self) -> tuple[str, ...]:
        """What to tell the person about repairs on opening."""
        return self._session.recovered

    def shown(self) -> None:
        """The turn has been shown; how long the person takes to answer counts from here."""
        self._shown_at = self._session.now()

    def perform(
        self, act: ScriptAct, raw: str, via: str, in_view: Collection[str] = ()
    ) -> Snapshot:
        """Let the person act, who has seen the panels ``in_view`` since the last turn.

        Raises one of ``REFUSALS``, a ``StorageError``, or what is a bug.
        """
        with self._lock:
            self._session.perform(act, raw=raw, via=via, shown_at=self._shown_at, in_view=in_view)
            self.snapshot = self._observer.look()
            return self.snapshot

    def close(self) -> None:
        """Let go of the session, once whoever is in it has left."""
        with self._lock:
            self._session.close()
