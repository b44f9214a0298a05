"""The interface of question policies: given what may be done, choose."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from verbteach.dialogue.decision import Candidate, Decision
from verbteach.dialogue.state import EpisodeState


class Policy(Protocol):
    """Chooses the robot's next act in the execution and the learning phase."""

    @property
    def name(self) -> str:
        """The policy's name, as the command line and the record know it."""
        ...

    @property
    def asks(self) -> bool:
        """Whether it is offered every question, or only those about unclear words."""
        ...

    def choose(
        self, episode: EpisodeState, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Choose one of ``candidates``, of which there is at least one.

        Every draw comes from ``rng``; equal arguments give equal decisions.
        """
        ...
