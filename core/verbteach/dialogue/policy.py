"""The interface of question policies: given what may be done, choose; and learn from what came."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, Self, runtime_checkable

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

        ``episode.phase`` says which phase it is. Every draw comes from ``rng``;
        equal arguments give equal decisions.
        """
        ...


@dataclass(frozen=True)
class Taken:
    """An act that was taken, what it earned, and the act that was taken next.

    ``phase`` is ``execution`` or ``learning``; ``features`` are the act's.
    ``following`` are the next act's features, ``None`` where the phase ended.
    """

    phase: str
    features: Mapping[str, float]
    reward: float
    following: Mapping[str, float] | None = None


@runtime_checkable
class LearningPolicy(Policy, Protocol):
    """A policy that changes with every turn; a value, so that going back to one is exact."""

    @property
    def digest(self) -> str:
        """SHA-256 of all that it has learned."""
        ...

    def told(self, taken: Taken) -> tuple[Self, Mapping[str, Any] | None]:
        """The policy after one step, and a JSON-ready record of what changed.

        A policy that is held as it is answers with itself and no record.
        """
        ...
