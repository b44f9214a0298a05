"""How long a part of the benchmark may take: what it has by then is what it reports."""

from __future__ import annotations

import time


class Allowance:
    """Seconds that run from now on."""

    def __init__(self, seconds: float) -> None:
        self._seconds, self._start = seconds, time.monotonic()

    @property
    def spent(self) -> float:
        """Seconds since it began."""
        return time.monotonic() - self._start

    def over(self, share: float = 1.0) -> bool:
        """Whether ``share`` of it is used up."""
        return self.spent >= share * self._seconds

    @property
    def left(self) -> float:
        """Seconds that remain, never below nought."""
        return max(0.0, self._seconds - self.spent)
