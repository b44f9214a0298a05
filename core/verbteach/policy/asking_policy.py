"""The interface of policies that ask: given candidate acts with features, choose.

It fits ``dialogue.policy.Policy`` but needs no episode: what matters of it is
in the candidates' features.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from verbteach.dialogue.acts import IncludeFluent, RequestDemonstration, SelectHypo
from verbteach.dialogue.decision import Candidate, Decision

ENDING = (SelectHypo, IncludeFluent, RequestDemonstration)
"""Acts that end a phase; all others are questions."""


class AskingPolicy(Protocol):
    """Chooses the next act of a phase."""

    @property
    def name(self) -> str:
        """The policy's name, as the command line and the record know it."""
        ...

    def choose(
        self, episode: object, candidates: Sequence[Candidate], rng: np.random.Generator
    ) -> Decision:
        """Choose one of ``candidates``; equal arguments and draws give equal decisions."""
        ...


def ending(candidates: Sequence[Candidate]) -> int:
    """The index of the act that ends the phase: the last such candidate."""
    return max(i for i, one in enumerate(candidates) if isinstance(one.act, ENDING))


def questions(candidates: Sequence[Candidate]) -> list[int]:
    """The indices of the questions."""
    return [i for i, one in enumerate(candidates) if not isinstance(one.act, ENDING)]
