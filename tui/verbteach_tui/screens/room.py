"""What the app knows of the teaching room without loading it: how to leave it, and what it offers.

The room brings the learner and numpy along; the home screen should not wait for them.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable

from textual.screen import Screen


class RoomScreen(Screen[None]):
    """A screen in which a session is open."""

    @property
    @abstractmethod
    def about(self) -> str:
        """What is going on, for the help."""

    @abstractmethod
    def single_keys(self) -> Iterable[tuple[str, str]]:
        """The keys that answer now, each with what it says."""

    @abstractmethod
    def leave(self, then: Callable[[], object] | None) -> bool:
        """Record that the person leaves, and do ``then``; False where that cannot be now."""

    @abstractmethod
    def palette(self) -> Iterable[tuple[str, str, Callable[[], object]]]:
        """Every action, as title, explanation and what to call."""
